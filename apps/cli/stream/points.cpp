#include "cli/stream/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "cli/stream/csv.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

// A field as a message shows it.
std::string shown(std::string_view raw) {
  constexpr std::size_t longest = 40;
  const std::string_view text = trimmed(raw);
  return text.empty() ? "(empty)" : contact::detail::printable(text, longest);
}

// The number in a field; NaN and a text in `why` if it is none.
double number(const PointColumn& column, std::string_view raw,
              std::string& why) {
  const auto value =
      raw.starts_with('"') ? parse_number(field_value(raw)) : parse_number(raw);
  if (value && column.allowed.contains(*value)) return *value;
  why =
      contact::detail::must_be(fmt::format("{} = {}", column.name, shown(raw)),
                               column.allowed.rule(value.has_value()));
  return nan;
}

// Names of a header's columns; a text in `why` if it is none.
std::vector<std::string> header_names(std::string_view header,
                                      std::string_view& why) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (header.starts_with(byte_order_mark)) {
    header.remove_prefix(byte_order_mark.size());
  }
  std::vector<std::string_view> fields;
  why = split_record(header, fields);
  std::vector<std::string> names;
  for (const std::string_view field : fields) {
    const std::string value = field_value(field);
    names.emplace_back(trimmed(value));
  }
  return names;
}

// "a, b and c"
std::string list_of(std::span<const PointColumn> columns) {
  std::string text;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0) text += i + 1 == columns.size() ? " and " : ", ";
    text += columns[i].name;
  }
  return text;
}

void read_line(const PointColumns& columns, std::string_view line,
               PointLines& block, std::string& why) {
  block.fields.clear();
  why = line.size() > longest_line
            ? fmt::format("longer than {} characters", longest_line)
            : std::string(split_record(line, block.fields));
  if (why.empty() && block.fields.size() != columns.count) {
    why = fmt::format("{} fields where the header has {}", block.fields.size(),
                      columns.count);
  }
  if (why.empty()) {
    for (const std::size_t field : columns.riding_at) {
      block.riding.push_back(block.fields[field]);
    }
  } else {
    block.riding.resize(block.riding.size() + columns.riding.size());
  }
  for (std::size_t i = 0; i < columns.needed.size(); ++i) {
    block.values[i].push_back(
        why.empty()
            ? number(columns.needed[i], block.fields[columns.at[i]], why)
            : nan);
  }
  block.good.push_back(why.empty());
  if (why.empty()) return;
  for (auto& values : block.values) values.back() = nan;
}

}  // namespace

PointColumns::PointColumns(std::string_view header,
                           std::span<const PointColumn> needed_columns,
                           const std::string& place)
    : needed(needed_columns.begin(), needed_columns.end()) {
  std::string_view why;
  const std::vector<std::string> names = header_names(header, why);
  if (!why.empty()) throw contact::Error(fmt::format("{}: {}", place, why));

  count = names.size();
  at.assign(needed.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = std::find_if(
        needed.begin(), needed.end(),
        [&](const auto& column) { return column.name == names[i]; });
    if (found == needed.end()) {
      riding_at.push_back(i);
      riding.push_back(names[i]);
      continue;
    }
    std::size_t& column = at[found - needed.begin()];
    if (column != count) {
      throw contact::Error(fmt::format(
          "{}: {}", place, contact::detail::duplicate("column", names[i])));
    }
    column = i;
  }
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (at[i] != count) continue;
    throw contact::Error(
        fmt::format("{}: no column {}; the header must name {}", place,
                    needed[i].name, list_of(needed)));
  }
}

bool PointHeader::has(std::span<const PointColumn> columns) const {
  std::string_view why;
  const std::vector<std::string> names = header_names(line, why);
  return std::all_of(columns.begin(), columns.end(), [&](const auto& column) {
    return std::find(names.begin(), names.end(), column.name) != names.end();
  });
}

PointHeader read_header(LineReader& reader) {
  for (;;) {
    std::string place =
        fmt::format("{}, line {}", reader.name(), reader.next_number());
    auto line = reader.line();
    if (!line) throw contact::Error(reader.name() + ": no header line");
    if (!line->starts_with('#')) return {std::move(*line), std::move(place)};
  }
}

void read_points(const PointColumns& columns, PointLines& block) {
  block.good.clear();
  block.values.resize(columns.needed.size());
  for (auto& values : block.values) values.clear();
  block.riding.clear();
  block.messages.clear();
  block.bad_lines = 0;
  std::string why;
  std::size_t line_number = block.lines.first_line;
  for (std::string_view rest = block.lines.text; !rest.empty(); ++line_number) {
    const std::string_view line = next_line(rest);
    if (line.size() <= longest_line && trimmed(line).empty()) continue;
    read_line(columns, line, block, why);
    if (why.empty()) continue;
    ++block.bad_lines;
    fmt::format_to(std::back_inserter(block.messages), "ERROR: line {}: {}\n",
                   line_number, why);
  }
  block.first = 0;
  block.last = block.good.size();
}

void read_all_points(LineReader& reader, const PointColumns& columns, bool tabs,
                     const std::function<void(const PointLines&)>& each) {
  constexpr std::string_view mark = "ERROR: ";
  PointLines block;
  while (reader.next(block.lines)) {
    if (tabs) std::ranges::replace(block.lines.text, '\t', ',');
    read_points(columns, block);
    if (block.bad_lines > 0) {
      std::string_view message = block.messages;
      message = message.substr(0, message.find('\n'));
      throw contact::Error(
          fmt::format("{}, {}", reader.name(), message.substr(mark.size())));
    }
    each(block);
  }
}

void write_riding(const PointColumns& columns, const PointLines& block,
                  std::size_t point, RowWriter& row) {
  const std::size_t riding = columns.riding.size();
  for (std::size_t i = 0; i < riding; ++i) {
    row.field(block.riding[point * riding + i]);
  }
}

}  // namespace cli
