#include "cli/stream/points.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "cli/stream/file_name.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

using contact::detail::nan;

using contact::detail::trimmed;

// A field as a message shows it.
std::string shown(std::string_view raw) {
  constexpr std::size_t longest = 40;
  const std::string_view text = trimmed(raw);
  return text.empty() ? "(empty)" : contact::detail::printable(text, longest);
}

// The rule for decimal commas in a file separated by commas.
constexpr std::string_view point_rule =
    "where commas separate, decimals have a point";

// Parses a field; for other text returns NaN and the reason in `why`.
double number(const PointColumn& column, std::string_view raw, CsvForm form,
              std::string& why) {
  const bool plain = raw.find_first_of("\",") == raw.npos;
  const std::string text = plain ? std::string() : field_value(raw);
  const std::string_view unquoted = plain ? raw : std::string_view(text);
  const bool is_open = may_be_thousands(unquoted, form);
  const auto value = is_open ? std::nullopt
                     : plain ? parse_number(raw)
                             : parse_number(field_value(raw, form));
  if (value && column.allowed.contains(*value)) return *value;
  const std::string given = fmt::format("{} = {}", column.name, shown(raw));
  if (is_open) {
    std::string thousands(unquoted);
    std::erase_if(thousands, [](char c) { return c == ',' || c == '.'; });
    why = contact::detail::needs(
        given,
        fmt::format("{}: it may be {}",
                    form.decimal == ',' ? "a decimal comma, which this file has"
                                        : "a decimal point, or --decimal-comma",
                    trimmed(thousands)));
    return nan;
  }
  why = contact::detail::must_be(given, column.allowed.rule(value.has_value()));
  if (!value && form.separator == ',' && text.find(',') != text.npos) {
    why += fmt::format("; {}", point_rule);
  }
  return nan;
}

// Names of a header's columns; for a bad header returns the reason in `why`.
std::vector<std::string> header_names(const PointHeader& header,
                                      std::string_view& why) {
  std::vector<std::string_view> fields;
  why = split_record(header.line, fields, header.form.separator);
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

// Index of the column with this name, exactly or else ignoring case;
// names.size() if there is none.
std::size_t find_name(const std::vector<std::string>& names,
                      std::string_view name) {
  auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    found = std::ranges::find_if(
        names, [name](const auto& column) { return is_named(column, name); });
  }
  return static_cast<std::size_t>(found - names.begin());
}

// True for a comment that is not a header written as one.
bool is_comment(std::string_view line, LineReader& reader) {
  if (!line.starts_with('#') && !line.starts_with('%')) return false;
  std::string_view next = reader.ahead();
  if (next.find_first_of("0123456789+-.") != 0 || !take_number(next)) {
    return true;
  }
  return next.find_first_of(",;|\t \r\n") != 0;
}

// The separator given by a first line "sep=;" of a spreadsheet.
std::optional<char> told_separator(std::string_view line) {
  const std::string value = field_value(line);
  constexpr std::string_view key = "sep=";
  if (value.size() != key.size() + 1 || !value.starts_with(key)) return {};
  return value.back();
}

void read_line(const PointColumns& columns, std::string_view line,
               PointLines& block, std::string& why) {
  block.fields.clear();
  why = line.size() > longest_line
            ? fmt::format("longer than {} characters", longest_line)
            : std::string(
                  split_record(line, block.fields, columns.form.separator));
  if (why.empty() && block.fields.size() != columns.count) {
    why = fmt::format("{} fields where the header has {}", block.fields.size(),
                      columns.count);
    if (columns.form.separator == ',' && block.fields.size() > columns.count) {
      why += fmt::format("; {}", point_rule);
    }
  }
  if (why.empty()) {
    for (const std::size_t field : columns.riding_at) {
      block.riding.push_back(block.fields[field]);
    }
  } else {
    block.riding.resize(block.riding.size() + columns.riding.size());
  }
  for (std::size_t i = 0; i < columns.needed.size(); ++i) {
    block.values[i].push_back(why.empty() ? number(columns.needed[i],
                                                   block.fields[columns.at[i]],
                                                   columns.form, why)
                                          : nan);
  }
  block.good.push_back(why.empty());
  if (why.empty()) return;
  for (auto& values : block.values) values.back() = nan;
}

}  // namespace

bool is_named(std::string_view column, std::string_view name) {
  constexpr std::string_view comment = "#% ";
  column.remove_prefix(
      std::min(column.find_first_not_of(comment), column.size()));
  return column.size() == name.size() && ends_in(column, name);
}

PointColumns::PointColumns(const PointHeader& header,
                           std::span<const PointColumn> needed_columns)
    : form(header.form), needed(needed_columns.begin(), needed_columns.end()) {
  std::string_view why;
  const std::vector<std::string> names = header_names(header, why);
  if (!why.empty()) {
    throw contact::Error(fmt::format("{}: {}", header.place, why));
  }
  count = names.size();
  for (const PointColumn& column : needed) {
    const std::size_t found = find_name(names, column.name);
    if (found == count || std::ranges::find(at, found) != at.end()) {
      header.fail(fmt::format("no column {}; the header must name {}",
                              column.name, list_of(needed)));
    }
    at.push_back(found);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (std::ranges::find(at, i) != at.end()) continue;
    for (std::size_t k = 0; k < at.size(); ++k) {
      const std::string& taken = names[at[k]];
      const bool twice = names[i] == taken ||
                         (taken != needed[k].name && is_named(names[i], taken));
      if (!twice) continue;
      throw contact::Error(
          fmt::format("{}: {}", header.place,
                      contact::detail::duplicate("column", names[i])));
    }
    riding_at.push_back(i);
    riding.push_back(names[i]);
  }
}

bool PointHeader::has(std::span<const PointColumn> columns) const {
  std::string_view why;
  const std::vector<std::string> names = header_names(*this, why);
  return std::ranges::all_of(columns, [&](const auto& column) {
    return find_name(names, column.name) != names.size();
  });
}

std::string PointHeader::shown() const {
  constexpr std::size_t longest = 200;
  std::string_view why;
  const std::string names =
      fmt::format("{}", fmt::join(header_names(*this, why), ", "));
  const std::string_view separator =
      form.separator == '\t' ? "tab" : std::string_view(&form.separator, 1);
  return fmt::format(
      "the header has {}{}", contact::detail::printable(names, longest),
      form.separator == ',' ? std::string()
                            : fmt::format(" (separator {})", separator));
}

void PointHeader::fail(std::string_view problem) const {
  throw contact::Error(fmt::format("{}: {}; {}", place, problem, shown()));
}

PointHeader read_header(LineReader& reader, const TableStyle& hints) {
  std::optional<char> told;
  for (;;) {
    PointHeader header;
    header.place =
        fmt::format("{}, line {}", reader.name(), reader.next_number());
    auto line = reader.line();
    if (!line) throw contact::Error(reader.name() + ": no header line");
    if (trimmed(*line).empty() || is_comment(*line, reader)) continue;
    if (!told) {
      told = told_separator(*line);
      if (told) continue;
    }
    header.form.separator =
        told ? *told : find_separator(*line, hints.separator);
    if (header.form.separator != ',') {
      const std::string_view lines = reader.ahead();
      header.form.decimal =
          find_decimal(lines.substr(0, lines.rfind('\n')),
                       header.form.separator, hints.decimal_comma);
    }
    header.line = std::move(*line);
    return header;
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

void read_all_points(LineReader& reader, const PointColumns& columns,
                     const std::function<void(const PointLines&)>& each) {
  constexpr std::string_view mark = "ERROR: ";
  PointLines block;
  while (reader.next(block.lines)) {
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
    row.field(block.riding[point * riding + i], columns.form);
  }
}

}  // namespace cli
