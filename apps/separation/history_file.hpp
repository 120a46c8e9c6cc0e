#pragma once

#include <string>

#include "separation/record.hpp"

namespace separation {

/// Writes a time history: HDF5 if the name ends in .h5 or .hdf5, else CSV;
/// whole or not at all.
///
/// CSV: columns as named, modes as words, empty where there is no value.
/// HDF5: one data set for each column, "BODY/QUANTITY" with its unit as
/// attribute "unit" (time: "time_s"); modes as integers, their words in the
/// attribute "words"; no value is NaN.
/// @throws contact::Error if it cannot be written
void write_history(const Rows& rows, const std::string& file);

}  // namespace separation
