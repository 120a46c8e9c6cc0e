#include "programs/duty/sto_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cli/number.hpp"
#include "cli/refuse.hpp"

namespace hinge_duty {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blank), text.size()));
  return text.substr(0, text.find_last_not_of(blank) + 1);
}

bool alike(std::string_view a, std::string_view b) {
  const auto lower = [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  };
  return std::ranges::equal(a, b, {}, lower, lower);
}

// The text behind "KEY=" or nothing.
std::optional<std::string_view> value_of(std::string_view line,
                                         std::string_view key) {
  const std::size_t at = line.find('=');
  if (at == line.npos || !alike(trimmed(line.substr(0, at)), key)) {
    return {};
  }
  return trimmed(line.substr(at + 1));
}

double count_of(std::string_view key, std::string_view text,
                const std::string& place) {
  const auto count = cli::parse_number(text);
  if (count && *count >= 0) return *count;
  throw contact::Error(contact::detail::must_be(
      fmt::format("{}: {} = {}", place, key, text), "a number, 0 or more"));
}

bool yes_or_no(std::string_view text, const std::string& place) {
  if (alike(text, "yes") || alike(text, "no")) return alike(text, "yes");
  throw contact::Error(contact::detail::must_be(
      fmt::format("{}: inDegrees = {}", place, text), "yes or no"));
}

}  // namespace

StoHeader read_sto_header(cli::LineReader& reader) {
  StoHeader header;
  std::optional<double> columns;
  for (;;) {
    const std::string place =
        fmt::format("{}, line {}", reader.name(), reader.next_number());
    const auto line = reader.line();
    if (!line) {
      cli::refuse_without(reader.name() + ": a table of OpenSim",
                          "a line endheader");
    }
    if (line->starts_with("endheader")) break;
    if (const auto rows = value_of(*line, "nRows")) {
      header.rows = count_of("nRows", *rows, place);
    }
    if (const auto count = value_of(*line, "nColumns")) {
      columns = count_of("nColumns", *count, place);
    }
    if (const auto answer = value_of(*line, "inDegrees")) {
      header.in_degrees = yes_or_no(*answer, place);
    }
  }
  header.columns = cli::read_header(reader, {.separator = '\t'});
  const std::string& names = header.columns.line;
  const auto found = 1 + std::ranges::count(names, '\t');
  if (found == 1) {
    cli::refuse_without(header.columns.place + ": a line of names",
                        "tabs between them");
  }
  if (columns && *columns != static_cast<double>(found)) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("{}: nColumns = {}", header.columns.place, *columns),
        fmt::format("{}, the number of names", found)));
  }
  return header;
}

void check_sto_rows(const StoHeader& header, std::size_t rows,
                    const std::string& name) {
  if (!header.rows || *header.rows == static_cast<double>(rows)) return;
  throw contact::Error(contact::detail::must_be(
      fmt::format("{}: nRows = {}", name, *header.rows),
      fmt::format("{}, the number of rows", rows)));
}

}  // namespace hinge_duty
