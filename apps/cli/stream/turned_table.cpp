#include "cli/stream/turned_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cli {

TurnedTable::TurnedTable(std::vector<std::string> names, bool latex)
    : names_(std::move(names)), latex_(latex) {
  for (const std::string& name : names_) {
    names_width_ = std::max(names_width_, name.size());
  }
}

std::string TurnedTable::add(std::string_view cells) {
  std::string full;
  while (!cells.empty()) {
    Row row;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const std::size_t end = cells.find(end_of_cell);
      row.cells.emplace_back(cells.substr(0, end));
      row.width = std::max(row.width, end);
      cells.remove_prefix(end + 1);
    }
    if (!rows_.empty() && width_ + row.width + 3 > widest) full += rest();
    if (rows_.empty()) width_ = names_width_ + 4;
    width_ += row.width + 3;
    rows_.push_back(std::move(row));
  }
  return full;
}

std::string TurnedTable::rest() {
  if (rows_.empty() && !first_) return {};
  std::string text = first_ ? "" : "\n";
  text += group();
  first_ = false;
  rows_.clear();
  return text;
}

std::string TurnedTable::group() const {
  std::string text;
  std::string rule = "\\hline\n";
  if (latex_) {
    text = "\\begin{tabular}{l" + std::string(rows_.size(), 'r') + "}\n" + rule;
  } else {
    rule = "| :" + std::string(names_width_ - 1, '-') + " |";
    for (const Row& row : rows_) {
      rule += ' ' + std::string(row.width - 1, '-') + ": |";
    }
    rule += '\n';
  }
  for (std::size_t i = 0; i < names_.size(); ++i) {
    text += fmt::format("{}{:{}}", latex_ ? "" : "| ", names_[i], names_width_);
    for (const Row& row : rows_) {
      text += fmt::format("{}{:>{}}", latex_ ? " & " : " | ", row.cells[i],
                          row.width);
    }
    text += latex_ ? " \\\\\n" : " |\n";
    if (i == 0) text += rule;
  }
  return latex_ ? text + rule + "\\end{tabular}\n" : text;
}

}  // namespace cli
