#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

/// Transposes a printed table that is too wide for a page: a row for each
/// column, and a column for each row, in groups that fit the width.
class TurnedTable {
 public:
  /// Line width up to which a table is not turned.
  static constexpr std::size_t widest = 100;
  static constexpr char end_of_cell = '\n';

  /// @param names  printed names of the columns
  /// @param latex  true: LaTeX; false: Markdown
  TurnedTable(std::vector<std::string> names, bool latex);

  /// Takes the cells of whole rows, each followed by an end and free of ends
  /// inside; returns the complete groups.
  std::string add(std::string_view cells);
  /// Returns the last group.
  std::string rest();

 private:
  struct Row {
    std::vector<std::string> cells = {};
    std::size_t width = 3;
  };
  std::string group() const;

  std::vector<std::string> names_;
  bool latex_;
  std::size_t names_width_ = 3;
  std::vector<Row> rows_ = {};
  std::size_t width_ = 0;  ///< width of the group so far
  bool first_ = true;
};

}  // namespace cli
