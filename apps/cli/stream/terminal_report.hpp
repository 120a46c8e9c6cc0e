#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/stream/terminal_rows.hpp"
#include "cli/stream/terminal_unit.hpp"

namespace cli {

/// A table for people at a terminal. A single row is printed as the lines of
/// report_rows, with engineering prefixes and units; several rows are printed
/// with their important columns. Other columns need --all or --columns. A table
/// without important columns shows its first ones. Names of columns are broken,
/// and then the last columns left out, if a table would be wider than a page.
class TerminalReport {
 public:
  static constexpr char end_of_cell = '\n';
  /// Width of a page, which a table exceeds only if all of it is wanted.
  static constexpr std::size_t widest_table = 80;

  struct Style {
    bool all = false;           ///< every column
    bool chosen = false;        ///< --columns: every column, in their order
    bool always_table = false;  ///< of one row too
    bool colour = false;        ///< escape sequences round verdicts
    std::string title = {};
    std::string more = {};  ///< further commands, last line
    /// Columns of numbers of the quantity that the column `quantity` names,
    /// each in the unit of its row. Rows without such a number are left out.
    std::vector<std::string> of_quantity = {};
  };

  /// @param names  of the columns
  TerminalReport(std::vector<std::string> names, Style style);

  /// Takes the cells of whole rows, each followed by an end and free of ends
  /// inside; returns the text that can be printed.
  std::string add(std::string_view cells);
  std::string rest();

 private:
  using Row = std::vector<std::string>;

  struct Line {
    std::string label;
    std::string value;
    std::string beside;
  };

  bool says_something(const Row& row) const;
  // A column of a table of rows.
  struct Column {
    std::size_t at;  ///< its number in names_
    /// Columns of a larger rank are left out first, columns of rank 0 never.
    std::size_t rank = 0;
    ShownUnit unit = {};
    std::size_t width = 0;               ///< of its cells, then of its head too
    bool has_number = false;             ///< it stands to the right
    std::vector<std::string> head = {};  ///< its lines
  };

  std::string lines(const Row& row) const;
  std::vector<Line> important_lines(const Row& row) const;
  std::optional<Line> line(const ReportRow& of, std::size_t at,
                           const Row& row) const;
  std::optional<Line> plain_line(std::size_t at, const Row& row) const;
  Line chosen_line(std::size_t at, const Row& row) const;
  std::string shown_cell(const Row& row, const Column& column) const;
  std::vector<Column> all_columns() const;
  std::vector<Column> important_columns() const;
  void measure(Column& column) const;
  std::size_t table_width() const;
  void begin_table();
  std::string heads() const;
  std::string table_rows();

  std::vector<std::string> names_;
  Style style_;
  std::vector<Row> rows_ = {};        ///< not yet printed
  std::vector<Column> columns_ = {};  ///< of a table of rows
  bool is_table_ = false;
  bool empty_ = true;
};

}  // namespace cli
