#include "cli/stream/csv.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "cli/number.hpp"
#include "cli/stream/line_blocks.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

bool is_quoted(std::string_view raw) {
  return raw.size() >= 2 && raw.front() == '"';
}

// End of the quoted field at the start of `text`, past its closing quote;
// npos if it stays open.
std::size_t end_of_quotes(std::string_view text) {
  for (std::size_t at = text.find('"', 1); at != std::string_view::npos;
       at = text.find('"', at + 2)) {
    if (at + 1 == text.size() || text[at + 1] != '"') return at + 1;
  }
  return std::string_view::npos;
}

// A number whose only mark is a comma, with a point instead; "" for other text.
std::string with_point(std::string_view value) {
  const std::size_t at = value.find(',');
  if (at == value.npos || value.find_first_of(",.", at + 1) != value.npos) {
    return {};
  }
  std::string number(value);
  number[at] = '.';
  return parse_number(number) ? number : std::string();
}

// Digits, a mark and three digits, with any sign: 1,250 but not 0,250.
bool has_thousands_form(std::string_view value, char mark) {
  value = contact::detail::trimmed(value);
  if (value.starts_with('+') || value.starts_with('-')) value.remove_prefix(1);
  const std::size_t at = value.find(mark);
  const auto is_digits = [](std::string_view text) {
    return text.find_first_not_of("0123456789") == text.npos;
  };
  return at != value.npos && at >= 1 && at <= 3 && value[0] != '0' &&
         is_digits(value.substr(0, at)) && value.size() == at + 4 &&
         is_digits(value.substr(at + 1));
}

}  // namespace

char find_separator(std::string_view header, char hint) {
  constexpr std::string_view separators = ",;\t|";
  std::array<std::size_t, separators.size()> counts = {};
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    const std::size_t at = separators.find(c);
    if (!quoted && at != separators.npos) ++counts[at];
  }
  const auto* const most = std::ranges::max_element(counts);
  // A file with one column has no separator.
  const bool take_hint =
      hint != ',' && (*most == 0 || counts[separators.find(hint)] > 0);
  return take_hint ? hint : separators[most - counts.begin()];
}

char find_decimal(std::string_view lines, char separator, bool comma) {
  bool has_point = false;
  bool has_comma = false;
  std::vector<std::string_view> fields;
  while (!lines.empty()) {
    const std::string_view line = next_line(lines);
    if (!split_record(line, fields, separator).empty()) continue;
    for (const std::string_view field : fields) {
      const std::string value = field_value(field);
      if (value.find('.') != value.npos) {
        has_point = has_point ||
                    (parse_number(value) && !has_thousands_form(value, '.'));
      } else {
        has_comma = has_comma || (!with_point(value).empty() &&
                                  !has_thousands_form(value, ','));
      }
    }
  }
  return has_comma == has_point ? (comma ? ',' : '.') : has_comma ? ',' : '.';
}

std::string_view split_record(std::string_view line,
                              std::vector<std::string_view>& fields,
                              char separator) {
  fields.clear();
  for (;;) {
    std::size_t end = 0;
    if (line.starts_with('"')) {
      end = end_of_quotes(line);
      if (end == std::string_view::npos) return "a quote is left open";
      if (end < line.size() && line[end] != separator) {
        return "text after a closing quote";
      }
    } else {
      end = line.find(separator);
    }
    fields.push_back(line.substr(0, end));
    if (end >= line.size()) return {};
    line.remove_prefix(end + 1);
  }
}

std::string field_value(std::string_view raw) {
  if (!is_quoted(raw)) return std::string(raw);
  std::string value;
  for (std::size_t i = 1; i + 1 < raw.size(); ++i) {
    if (raw[i] == '"') ++i;
    value += raw[i];
  }
  return value;
}

std::string field_value(std::string_view raw, CsvForm form) {
  std::string value = field_value(raw);
  if (form.separator == ',' || may_be_thousands(value, form)) return value;
  std::string number = with_point(value);
  return number.empty() ? value : number;
}

bool may_be_thousands(std::string_view value, CsvForm form) {
  return form.separator != ',' &&
         has_thousands_form(value, form.decimal == ',' ? '.' : ',');
}

std::string raw_field(std::string_view value, char separator) {
  if (value.find_first_of("\"\r\n") == value.npos &&
      value.find(separator) == value.npos) {
    return std::string(value);
  }
  std::string raw = "\"";
  for (const char c : value) {
    if (c == '"') raw += '"';
    raw += c;
  }
  return raw + '"';
}

}  // namespace cli
