#include "programs/joint/beside.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cli/stream/points.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace hinge_joint {
namespace {

using contact::detail::must_be;

const std::vector<cli::PointColumn> numbers = {{"row", {1, 1e6, ""}},
                                               {"value", {-1e300, 1e300, ""}}};

// Index of a column of text among the columns passed through.
std::size_t text_at(const cli::PointColumns& columns,
                    const cli::PointHeader& header, std::string_view name) {
  const auto found = std::ranges::find_if(
      columns.riding,
      [name](const auto& column) { return cli::is_named(column, name); });
  if (found == columns.riding.end()) {
    header.fail(fmt::format("no column {}", name));
  }
  return static_cast<std::size_t>(found - columns.riding.begin());
}

}  // namespace

Beside::Beside(const std::string& path, std::string_view joint,
               std::string_view table, const cli::TableStyle& hints) {
  if (path.empty()) return;
  cli::LineReader reader(path);
  const cli::PointHeader header = cli::read_header(reader, hints);
  const cli::PointColumns columns(header, numbers);
  const std::size_t joint_at = text_at(columns, header, "joint");
  const std::size_t table_at = text_at(columns, header, "table");
  const std::size_t column_at = text_at(columns, header, "column");
  cli::read_all_points(reader, columns, [&](const cli::PointLines& block) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      const auto text = [&](std::size_t at) {
        return cli::field_value(block.riding[i * columns.riding.size() + at]);
      };
      const double row = block.values[0][i];
      if (row != std::floor(row)) {
        throw contact::Error(
            must_be(fmt::format("{}: row = {}", path, row), "a whole number"));
      }
      if (text(joint_at) != joint || text(table_at) != table) continue;
      columns_[text(column_at)][static_cast<std::size_t>(row)] =
          block.values[1][i];
    }
  });
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
