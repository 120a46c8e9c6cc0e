#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/output.hpp"
#include "cli/stream/csv.hpp"
#include "cli/stream/terminal_report.hpp"
#include "cli/stream/turned_table.hpp"
#include "cli/text.hpp"

namespace cli {

enum class Format { csv, json, markdown, latex, report };

/// How a table is written.
struct TableStyle {
  Format format = Format::csv;
  /// Only these columns, in this order, also in the report; all if empty.
  std::vector<std::string> columns = {};
  char separator = ',';        ///< between cells of CSV
  bool decimal_comma = false;  ///< in CSV
  TerminalReport::Style report = {};

  /// This style with a title above the report.
  TableStyle titled(std::string title) const {
    TableStyle style = *this;
    style.report.title = std::move(title);
    return style;
  }

  /// This style for a table whose column `quantity` names the quantity of these
  /// columns in each row.
  TableStyle of_quantity(std::vector<std::string> numbers) const {
    TableStyle style = *this;
    style.report.of_quantity = std::move(numbers);
    return style;
  }

  /// Style of the files written beside a table: CSV with all columns.
  TableStyle beside() const {
    return {.separator = separator, .decimal_comma = decimal_comma};
  }
};

/// The columns of a table in one style. Any thread builds rows in any Text
/// (RowWriter); a TableWriter writes them, so a table of any length takes the
/// memory of a few blocks of rows.
///
/// csv, json: the shortest numbers that read back as the same doubles. NaN (no
/// value) is an empty cell in CSV and null in JSON; infinity is inf or -inf in
/// CSV and the text "inf" or "-inf" in JSON. JSON is an array of objects, one
/// on each line.
/// markdown, latex: for print, with 4 significant digits; tables too wide for a
/// page are transposed (TurnedTable).
/// report: for people at a terminal (TerminalReport).
class Table {
 public:
  /// Throws contact::Error if the style asks for unknown columns.
  Table(TableStyle style, std::vector<std::string> column_names);

  const TableStyle& style() const { return style_; }
  /// Printed names of the columns that are shown.
  std::vector<std::string> shown_names() const;
  /// True if rows are printed as columns.
  bool is_turned() const {
    return collected_ && style_.format != Format::report;
  }
  std::string header() const;
  std::string footer() const;

 private:
  friend class RowWriter;
  void set_marks();

  TableStyle style_;
  std::vector<std::string> names_;
  std::vector<std::size_t> shown_;   ///< which of them, in order
  std::vector<std::string> before_;  ///< text before each shown cell
  std::string end_of_row_;
  /// True if rows are collected before they are printed: transposed or
  /// reported.
  bool collected_ = false;
};

/// Writes the cells of a row from left to right, including hidden columns.
class RowWriter {
 public:
  RowWriter(const Table& table, Text& text)
      : table_(table), text_(text), picks_(!table.style_.columns.empty()) {}

  void number(double value);
  /// A whole number, in full in every format.
  void count(std::size_t value);
  /// No value: empty, null or a dash.
  void empty();
  void text(std::string_view value);
  /// A raw field of a file with this form, copied byte for byte to CSV of the
  /// same form.
  void field(std::string_view raw, CsvForm form = {});
  /// Ends the row; all of its cells must have been written.
  void end();

 private:
  /// Opens the next cell.
  Text& begin_cell();
  void printed(std::string_view cell);

  const Table& table_;
  Text& text_;
  const bool picks_;  ///< reorders cells at the end of the row
  Text cells_ = {};
  std::vector<std::size_t> starts_ = {};  ///< begin of each cell in cells_
  std::size_t column_ = 0;
};

/// Sends a table to an output: header, blocks of rows, footer.
class TableWriter {
 public:
  TableWriter(Output& output, const Table& table);
  /// Writes whole rows built by RowWriters of the same table.
  void write(std::string_view rows);
  void finish();

 private:
  Output& output_;
  const Table& table_;
  std::optional<TurnedTable> turned_;
  std::optional<TerminalReport> report_;
  bool first_ = true;
};

/// Changes `names` so that none occurs twice or is in `taken` (it appends
/// "_in", then "_in2", "_in3"): names of columns that are passed through. Time
/// is linear in the number of names.
std::vector<std::string> distinct_names(std::vector<std::string> names,
                                        const std::vector<std::string>& taken);

}  // namespace cli
