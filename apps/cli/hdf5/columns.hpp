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
  std::string words;  ///< for small integers, attribute "words"; "": doubles
};

/// An HDF5 file as bytes, made in memory and to be written by us: an HDF5 that
/// cannot write crashes when it closes itself at the end of the program, and
/// does not say why it cannot. It takes twice the memory of the numbers, for a
/// moment.
/// @param fill  writes the numbers of a column, as many as rows
/// @throws contact::Error if HDF5 fails
std::string hdf5_image(
    const std::vector<Hdf5Column>& columns, std::size_t rows,
    const std::function<void(std::size_t column, double* values)>& fill);

}  // namespace cli
