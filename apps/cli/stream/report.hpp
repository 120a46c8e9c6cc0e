#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cli/output.hpp"
#include "cli/program.hpp"
#include "cli/table.hpp"
#include "libcontact/quantities/quantity.hpp"

namespace cli {

/// Nothing, a number, a whole number, a text.
using Cell = std::variant<std::monostate, double, std::size_t, std::string>;

/// A program's report on a whole run: named numbers with their meaning.
class Report {
 public:
  struct Line {
    std::string name;  ///< with its unit: "period_s"
    Cell value;
    std::string meaning;
    std::vector<Cell> beside = {};
  };

  /// A column between value and meaning.
  struct Beside {
    std::string name;
    bool has_unit_of_value = false;
  };

  explicit Report(std::vector<Beside> beside = {})
      : beside_(std::move(beside)) {}

  /// @param beside  one cell for each column, or fewer
  void add(std::string_view name, Cell value, std::string_view meaning,
           std::vector<Cell> beside = {}) {
    lines_.push_back({std::string(name), std::move(value), std::string(meaning),
                      std::move(beside)});
  }
  /// Adds the numbers of a quantity.
  template <class T>
  void add(const contact::Quantity<T>& quantity, const T& of) {
    for (const auto& column : contact::columns_of(quantity)) {
      add(column.name, column(of), column.meaning);
    }
  }

  /// quantity, value, the columns beside it, meaning.
  std::vector<std::string> columns() const;
  const std::vector<Line>& lines() const { return lines_; }
  /// A number added before.
  double number(std::string_view name) const;

  void write(Output& output, const TableStyle& style) const;

 private:
  void write_for_people(Output& output, const TableStyle& style) const;
  void write_lines(Output& output, const TableStyle& style) const;

  std::vector<Beside> beside_;
  std::vector<Line> lines_;
};

void write_cell(const Cell& cell, RowWriter& row);

/// Writes a table to a file that the caller commits.
/// @param write  makes the rows with a RowWriter
template <class Rows>
void write_table(const TableStyle& style,
                 const std::vector<std::string>& columns, Output& output,
                 const Rows& write) {
  const Table table(style, columns);
  Text text;
  RowWriter row(table, text);
  write(row);
  TableWriter writer(output, table);
  writer.write(text.view());
  writer.finish();
}

/// Writes a program's table, completely or not at all.
template <class Rows>
void write_table(const OutputOptions& options,
                 const std::vector<std::string>& columns, const Rows& write) {
  Output output(options.output);
  write_table(options, columns, output, write);
  output.commit();
}

}  // namespace cli
