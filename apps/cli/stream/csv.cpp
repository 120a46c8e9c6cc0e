#include "cli/stream/csv.hpp"

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

}  // namespace

std::string_view split_record(std::string_view line,
                              std::vector<std::string_view>& fields) {
  fields.clear();
  for (;;) {
    std::size_t end = 0;
    if (line.starts_with('"')) {
      end = end_of_quotes(line);
      if (end == std::string_view::npos) return "a quote is left open";
      if (end < line.size() && line[end] != ',') {
        return "text after a closing quote";
      }
    } else {
      end = line.find(',');
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
