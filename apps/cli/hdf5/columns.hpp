#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace cli {

/// A data set of numbers.
struct Hdf5Column {
  std::string path;   ///< "GROUP/NAME"
  std::string unit;   ///< attribute "unit", if there is one
  std::string words;  ///< small integers: attribute "words"; "": doubles
};

/// An HDF5 file as bytes. It is built in memory, because an HDF5 library that
/// cannot write to disk crashes at the end of the program and does not report
/// the cause. Peak memory is twice the size of the numbers.
/// @param fill  writes the numbers of a column, one for each row
/// @throws contact::Error if HDF5 fails
std::string hdf5_image(
    const std::vector<Hdf5Column>& columns, std::size_t rows,
    const std::function<void(std::size_t column, double* values)>& fill);

}  // namespace cli
