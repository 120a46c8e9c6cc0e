#pragma once

#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/table.hpp"
#include "separation/results/record.hpp"

namespace separation {

/// Writes a time history completely or not at all: HDF5 if the name ends in .h5
/// or .hdf5, CSV if the name ends in .csv, is "-", or names a pipe or device.
///
/// CSV: named columns, modes as words, empty cells for missing values.
/// HDF5: one data set for each column, "BODY/QUANTITY", with its unit as
/// attribute "unit" (time: "time_s"). Modes are integers; the attribute "words"
/// lists their words. A missing value is NaN.
class HistoryFile {
 public:
  /// @param columns  columns of the rows; the style selects those written
  /// @throws contact::Error for other names, if the file cannot be made, or if
  ///   the style asks for an unknown column
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
