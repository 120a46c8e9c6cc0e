#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cli/table.hpp"

namespace hinge_joint {

/// Printed or measured numbers that a table shows beside its own: a CSV file
/// with the columns joint, table, row, column, value (others are left alone).
class Beside {
 public:
  /// None.
  Beside() = default;
  /// Columns of one joint and table.
  /// @param path   "" for none
  /// @param joint  name of the joint
  /// @param table  "solution", "trace", "outer" or "inner"
  /// @param hints  of its form, as cli::read_header() takes them
  /// Throws contact::Error if the file is wrong or has none.
  Beside(const std::string& path, std::string_view joint,
         std::string_view table, const cli::TableStyle& hints);

  bool empty() const { return columns_.empty(); }
  /// Whether any row has a value for this column.
  bool has(std::string_view column) const;
  /// NaN where there is no value.
  /// @param row  from 1
  double at(std::size_t row, std::string_view column) const;

 private:
  std::map<std::string, std::map<std::size_t, double>, std::less<>> columns_;
};

/// Columns, each that has values in `beside` followed by COLUMN_printed.
std::vector<std::string> with_beside(const std::vector<std::string>& columns,
                                     const Beside& beside);
/// The cell or the two cells of such a column.
inline void write_number(cli::RowWriter& to, double value,
                         std::string_view column, std::size_t row,
                         const Beside& beside) {
  to.number(value + 0.0);  // no -0
  if (!beside.empty() && beside.has(column)) to.number(beside.at(row, column));
}

}  // namespace hinge_joint
