#include "table/point_block.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>

#include "cli/csv.hpp"
#include "libcontact/error.hpp"
#include "libcontact/units.hpp"

namespace hinge_table {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view theta0_name = "theta0_deg";
constexpr std::string_view alpha_name = "alpha_deg";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

// A field as a message shows it: on one line, without control characters.
std::string shown(std::string_view raw) {
  constexpr std::size_t longest = 40;
  std::string text(trimmed(raw).substr(0, longest));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return trimmed(raw).size() > longest ? text + "..." : text;
}

// The angle in a field; NaN and a text in `why` if it is none.
double angle(std::string_view name, std::string_view raw,
             const cli::Allowed& allowed, std::string& why) {
  const auto value = raw.starts_with('"')
                         ? cli::parse_number(cli::field_value(raw))
                         : cli::parse_number(raw);
  if (value && allowed.contains(*value)) return *value;
  why =
      fmt::format("{} = {}: {}, allowed {}", name, shown(raw),
                  value ? "outside the range" : "not a number", allowed.text());
  return nan;
}

void read_line(const PointColumns& columns, std::string_view line,
               PointBlock& block, std::string& why) {
  double theta0_deg = nan;
  double alpha_deg = nan;
  why = cli::split_record(line, block.fields);
  if (why.empty() && block.fields.size() != columns.count) {
    why = fmt::format("{} fields where the header has {}", block.fields.size(),
                      columns.count);
  }
  if (why.empty()) {
    theta0_deg =
        angle(theta0_name, block.fields[columns.theta0], allowed_theta0, why);
    if (why.empty()) {
      alpha_deg =
          angle(alpha_name, block.fields[columns.alpha], allowed_alpha, why);
    }
    for (std::size_t i = 0; i < columns.count; ++i) {
      if (i != columns.theta0 && i != columns.alpha) {
        block.riding.push_back(block.fields[i]);
      }
    }
  } else {
    block.riding.resize(block.riding.size() + columns.riding.size());
  }
  block.theta0_deg.push_back(why.empty() ? theta0_deg : nan);
  block.alpha_deg.push_back(alpha_deg);
}

void clear(PointBlock& block) {
  block.theta0_deg.clear();
  block.alpha_deg.clear();
  block.riding.clear();
  block.messages.clear();
  block.bad_lines = 0;
}

}  // namespace

PointColumns::PointColumns(std::string_view header, const std::string& place) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (header.starts_with(byte_order_mark)) {
    header.remove_prefix(byte_order_mark.size());
  }
  std::vector<std::string_view> fields;
  const std::string_view why = cli::split_record(header, fields);
  if (!why.empty()) throw contact::Error(fmt::format("{}: {}", place, why));

  count = fields.size();
  theta0 = alpha = count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string value = cli::field_value(fields[i]);
    const std::string_view name = trimmed(value);
    if (name != theta0_name && name != alpha_name) {
      riding.emplace_back(name);
      continue;
    }
    std::size_t& column = name == theta0_name ? theta0 : alpha;
    if (column != count) {
      throw contact::Error(
          fmt::format("{}: column {} occurs twice", place, name));
    }
    column = i;
  }
  if (theta0 == count || alpha == count) {
    throw contact::Error(fmt::format(
        "{}: no column {}; the header must name theta0_deg and alpha_deg",
        place, theta0 == count ? theta0_name : alpha_name));
  }
}

void take_grid_points(const cli::Sweep& theta0, const cli::Sweep& alpha,
                      std::size_t first, std::size_t last, PointBlock& block) {
  clear(block);
  for (std::size_t i = first; i < last; ++i) {
    block.theta0_deg.push_back(theta0[i / alpha.size()]);
    block.alpha_deg.push_back(alpha[i % alpha.size()]);
  }
}

void read_points(const PointColumns& columns, PointBlock& block) {
  clear(block);
  std::string why;
  std::size_t number = block.lines.first_line;
  for (std::string_view rest = block.lines.text; !rest.empty(); ++number) {
    const std::string_view line = cli::next_line(rest);
    if (trimmed(line).empty()) continue;
    read_line(columns, line, block, why);
    if (why.empty()) continue;
    ++block.bad_lines;
    fmt::format_to(std::back_inserter(block.messages), "ERROR: line {}: {}\n",
                   number, why);
  }
}

void compute(const Method& method, PointBlock& block) {
  const std::size_t count = block.size();
  block.half_angle.resize(count);
  block.axis_sin.resize(count);
  block.axis_cos.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    block.half_angle[i] = block.theta0_deg[i] * contact::degree;
    const auto [sin, cos] = contact::sine_cosine_deg(block.alpha_deg[i]);
    block.axis_sin[i] = sin;
    block.axis_cos[i] = cos;
  }
  Columns columns;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    block.results[j].resize(count);
    columns[j] = block.results[j];
  }
  block.inaccurate =
      method({block.half_angle, block.axis_sin, block.axis_cos}, columns);
}

void write_rows(const cli::Table& table, PointBlock& block) {
  block.rows.clear();
  cli::RowWriter row(table, block.rows);
  const std::size_t riding = table.columns() - 2 - quantities.size();
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (std::isnan(block.theta0_deg[i])) {
      row.text("ERROR");
      for (std::size_t j = 0; j <= quantities.size(); ++j) row.empty();
    } else {
      row.number(block.theta0_deg[i]);
      row.number(block.alpha_deg[i]);
      for (const auto& column : block.results) row.number(column[i]);
    }
    for (std::size_t j = 0; j < riding; ++j) {
      row.field(block.riding[i * riding + j]);
    }
    row.end();
  }
}

}  // namespace hinge_table
