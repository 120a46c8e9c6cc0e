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
  /// Only these, in this order; all if it is empty.
  std::vector<std::string> columns = {};
  char separator = ',';        ///< between cells of CSV
  bool decimal_comma = false;  ///< in CSV
  TerminalReport::Style report = {};

  /// The same with a title above its report.
  TableStyle titled(std::string title) const {
    TableStyle style = *this;
    style.report.title = std::move(title);
    return style;
  }

  /// Style of files beside a table, which are CSV with all their columns.
  TableStyle beside() const {
    return {.separator = separator, .decimal_comma = decimal_comma};
  }
};

/// A table's columns in one style. Rows are built in any Text by any thread
/// (RowWriter) and leave through a TableWriter, so a table of any length
/// takes the memory of a few blocks of rows.
///
/// csv, json: shortest numbers that read back as the same doubles. NaN, no
/// value, is an empty cell in CSV and null in JSON; infinity is inf or -inf in
/// CSV and the text "inf" or "-inf" in JSON. JSON is an array of objects, one
/// on each line.
/// markdown, latex: for print, numbers with 4 significant digits; what is too
/// wide for a page is turned (TurnedTable).
/// report: what people read on a terminal (TerminalReport).
class Table {
 public:
  /// Throws contact::Error if the style asks for columns that are not there.
  Table(TableStyle style, std::vector<std::string> column_names);

  const TableStyle& style() const { return style_; }
  /// Names of the columns that are shown, as they are printed.
  std::vector<std::string> shown_names() const;
  /// Whether a row is printed as a column.
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
  /// Whether rows are collected before they are printed: turned, or reported.
  bool collected_ = false;
};

/// Writes the cells of a row from left to right, those that are not shown too.
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
  /// A field as it stood in a file of this form, handed on byte for byte to CSV
  /// of the same.
  void field(std::string_view raw, CsvForm form = {});
  /// All cells of the row must have been written.
  void end();

 private:
  /// Opens the next cell.
  Text& begin_cell();
  void printed(std::string_view cell);

  const Table& table_;
  Text& text_;
  const bool picks_;  ///< cells are put in order at the end of the row
  Text cells_ = {};
  std::vector<std::size_t> starts_ = {};  ///< begin of each cell in cells_
  std::size_t column_ = 0;
};

/// Sends a table to an output: header, blocks of rows, footer.
class TableWriter {
 public:
  TableWriter(Output& output, const Table& table);
  /// Whole rows that RowWriters of the same table have built.
  void write(std::string_view rows);
  void finish();

 private:
  Output& output_;
  const Table& table_;
  std::optional<TurnedTable> turned_;
  std::optional<TerminalReport> report_;
  bool first_ = true;
};

/// `names`, changed where needed so that none is in `taken` or occurs twice
/// ("_in" is added, then "_in2", "_in3"): the names of columns that are handed
/// on. The time is linear in the number of names.
std::vector<std::string> distinct_names(std::vector<std::string> names,
                                        const std::vector<std::string>& taken);

}  // namespace cli
