#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cli/table.hpp"

namespace hinge_joint {

/// Published or measured numbers that a table shows beside its own: a CSV file
/// with the columns joint, table, row, column, value; further columns are
/// ignored.
class Beside {
 public:
  /// No numbers.
  Beside() = default;
  /// Reads the numbers of one joint and table.
  /// @param path   "" for none
  /// @param joint  name of the joint
  /// @param table  "solution", "trace", "outer" or "inner"
  /// @param hints  form of the file, as for cli::read_header()
  /// Throws contact::Error if the file is wrong or has no such numbers.
  Beside(const std::string& path, std::string_view joint,
         std::string_view table, const cli::TableStyle& hints);

  bool empty() const { return columns_.empty(); }
  /// True if a row has a value for this column.
  bool has(std::string_view column) const;
  /// NaN if there is no value.
  /// @param row  from 1
  double at(std::size_t row, std::string_view column) const;

 private:
  std::map<std::string, std::map<std::size_t, double>, std::less<>> columns_;
};

/// Inserts COLUMN_printed after each column that has values in `beside`.
std::vector<std::string> with_beside(const std::vector<std::string>& columns,
                                     const Beside& beside);
/// Writes the cell of such a column, or its two cells.
inline void write_number(cli::RowWriter& to, double value,
                         std::string_view column, std::size_t row,
                         const Beside& beside) {
  to.number(value + 0.0);  // turns -0 into 0
  if (!beside.empty() && beside.has(column)) to.number(beside.at(row, column));
}

}  // namespace hinge_joint
