#pragma once

#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/table.hpp"
#include "separation/results/record.hpp"

namespace separation {

/// A time history's file: HDF5 if the name ends in .h5 or .hdf5, CSV if it
/// ends in .csv, is "-" or that of a pipe or device; whole or not at all.
///
/// CSV: columns as named, modes as words, empty where there is no value.
/// HDF5: one data set for each column, "BODY/QUANTITY" with its unit as
/// attribute "unit" (time: "time_s"); modes as integers, their words in the
/// attribute "words"; no value is NaN.
class HistoryFile {
 public:
  /// @param columns  of the rows; those that the style asks for are written
  /// @throws contact::Error for other names, if the file cannot be made, and if
  ///   the style asks for a column that is not there
  HistoryFile(const std::string& name, const cli::TableStyle& style,
              const std::vector<std::string>& columns);
  /// @throws contact::Error if it cannot be written
  void write(const Rows& rows);

 private:
  bool hdf5_;
  cli::Table table_;
  cli::Output output_;
};

}  // namespace separation
