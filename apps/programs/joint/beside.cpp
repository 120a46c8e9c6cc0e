#include "programs/joint/beside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "cli/number.hpp"
#include "cli/stream/csv.hpp"
#include "cli/stream/line_blocks.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace hinge_joint {
namespace {

using contact::detail::must_be;

constexpr std::array<std::string_view, 5> names = {"joint", "table", "row",
                                                   "column", "value"};

// Lines of a CSV file that are not comments, with their places.
class Records {
 public:
  explicit Records(const std::string& path) : reader_(path) {}

  bool next() {
    for (;;) {
      place_ =
          fmt::format("{}, line {}", reader_.name(), reader_.next_number());
      const auto line = reader_.line();
      if (!line) return false;
      if (line->empty() || line->starts_with('#')) continue;
      std::vector<std::string_view> fields;
      const std::string_view why = cli::split_record(*line, fields);
      if (!why.empty()) fail(std::string(why));
      fields_.clear();
      for (const auto field : fields) {
        fields_.push_back(cli::field_value(field));
      }
      return true;
    }
  }
  const std::vector<std::string>& fields() const { return fields_; }
  [[noreturn]] void fail(const std::string& why) const {
    throw contact::Error(fmt::format("{}: {}", place_, why));
  }

 private:
  cli::LineReader reader_;
  std::string place_;
  std::vector<std::string> fields_;
};

}  // namespace

Beside::Beside(const std::string& path, std::string_view joint,
               std::string_view table) {
  if (path.empty()) return;
  Records records(path);
  if (!records.next()) throw contact::Error(path + ": no header line");
  const std::vector<std::string> header = records.fields();
  std::array<std::size_t, names.size()> at = {};
  for (std::size_t i = 0; i < names.size(); ++i) {
    at[i] = std::find(header.begin(), header.end(), names[i]) - header.begin();
    if (at[i] == header.size()) {
      records.fail(fmt::format("no column {}", names[i]));
    }
  }
  while (records.next()) {
    const std::vector<std::string>& fields = records.fields();
    if (fields.size() != header.size()) {
      records.fail(fmt::format("{} fields where the header has {}",
                               fields.size(), header.size()));
    }
    const auto row = cli::parse_number(fields[at[2]]);
    const auto value = cli::parse_number(fields[at[4]]);
    if (!row || !(*row >= 1) || *row != std::floor(*row) || *row > 1e6) {
      records.fail(must_be("row " + fields[at[2]], "1 or above"));
    }
    if (!value) {
      records.fail(must_be("value " + fields[at[4]], "a number"));
    }
    if (fields[at[0]] != joint || fields[at[1]] != table) continue;
    columns_[fields[at[3]]][static_cast<std::size_t>(*row)] = *value;
  }
  if (columns_.empty()) {
    throw contact::Error(fmt::format(
        "--beside {}: no rows for joint \"{}\", table {}", path, joint, table));
  }
}

bool Beside::has(std::string_view column) const {
  return columns_.find(column) != columns_.end();
}

double Beside::at(std::size_t row, std::string_view column) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto values = columns_.find(column);
  if (values == columns_.end()) return none;
  const auto value = values->second.find(row);
  return value == values->second.end() ? none : value->second;
}

std::vector<std::string> with_beside(const std::vector<std::string>& columns,
                                     const Beside& beside) {
  std::vector<std::string> all;
  for (const std::string& column : columns) {
    all.push_back(column);
    if (beside.has(column)) all.push_back(column + "_printed");
  }
  return all;
}

}  // namespace hinge_joint
