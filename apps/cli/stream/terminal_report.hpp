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
/// without important columns shows its first ones.
class TerminalReport {
 public:
  static constexpr char end_of_cell = '\n';

  struct Style {
    bool all = false;     ///< every column
    bool colour = false;  ///< escape sequences round verdicts
    std::string title = {};
    std::string more = {};  ///< further commands, last line
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

  std::string lines(const Row& row) const;
  std::vector<Line> chosen_lines(const Row& row) const;
  std::optional<Line> line(const ReportRow& of, std::size_t at,
                           const Row& row) const;
  std::optional<Line> plain_line(std::size_t at, const Row& row) const;
  std::string shown_cell(const Row& row, std::size_t at,
                         const ShownUnit& unit) const;
  void begin_table();
  std::string table_rows();

  std::vector<std::string> names_;
  Style style_;
  std::vector<Row> rows_ = {};           ///< not yet printed
  std::vector<std::size_t> shown_ = {};  ///< columns of a table of rows
  std::vector<ShownUnit> units_ = {};
  std::vector<std::size_t> widths_ = {};
  std::vector<bool> has_number_ = {};  ///< such columns stand to the right
  bool is_table_ = false;
  bool empty_ = true;
};

}  // namespace cli
