#include "support/reference_table.hpp"

#include <algorithm>
#include <fstream>

#include "libcontact/base/error.hpp"
#include "libcontact/base/number.hpp"

namespace contact::test {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = line.find(',', begin);
    cells.push_back(line.substr(begin, end - begin));
    if (end == std::string::npos) return cells;
    begin = end + 1;
  }
}

}  // namespace

ReferenceTable::ReferenceTable(const std::filesystem::path& path)
    : name_(path.string()) {
  std::ifstream file(std::filesystem::path(CONTACT_DATA_DIR) / "reference" /
                     path);
  if (!file) throw Error(name_ + ": cannot be read");
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    if (columns_.empty()) {
      columns_ = split(line);
      continue;
    }
    rows_.push_back(split(line));
    lines_.push_back(number);
    if (rows_.back().size() != columns_.size()) {
      throw Error(name_ + ":" + std::to_string(number) + ": " +
                  std::to_string(rows_.back().size()) + " cells, need " +
                  std::to_string(columns_.size()));
    }
  }
  if (rows_.empty()) throw Error(name_ + ": holds no rows");
}

bool ReferenceTable::has(std::string_view column) const {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

const std::string& ReferenceTable::Row::text(std::string_view column) const {
  const auto& columns = table_->columns_;
  const auto found = std::find(columns.begin(), columns.end(), column);
  if (found == columns.end()) {
    throw Error(table_->name_ + ": has no column " + std::string(column));
  }
  return table_->rows_.at(number_)[found - columns.begin()];
}

std::string ReferenceTable::Row::label() const {
  const auto& columns = table_->columns_;
  std::string result =
      table_->name_ + ":" + std::to_string(table_->lines_.at(number_)) + ":";
  for (std::size_t i = 0; i < std::min<std::size_t>(2, columns.size()); ++i) {
    result +=
        (i == 0 ? " " : ", ") + columns[i] + "=" + table_->rows_[number_][i];
  }
  return result;
}

template <>
double ReferenceTable::Row::value<double>(std::string_view column) const {
  const std::string& cell = text(column);
  // Rounded to nearest: the double nearest to the printed decimal.
  const auto number = detail::number_in(cell);
  if (!number) {
    throw Error(label() + ": " + std::string(column) + " is \"" + cell +
                "\", not a number");
  }
  return *number;
}

}  // namespace contact::test
