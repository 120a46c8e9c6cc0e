#include "cli/stream/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cli/quantity.hpp"
#include "libcontact/base/text.hpp"

namespace cli {
namespace {

// "" for neutral words.
std::string_view colour_of(std::string_view word) {
  constexpr std::string_view good[] = {"ok", "met", "holds"};
  constexpr std::string_view bad[] = {"not met",      "slips",  "not_converged",
                                      "out_of_range", "missed", "ERROR",
                                      "out_of_seat",  "failed"};
  if (std::ranges::find(good, word) != std::end(good)) return "\033[32m";
  if (std::ranges::find(bad, word) != std::end(bad)) return "\033[31m";
  return "";
}

}  // namespace

std::string coloured(std::string_view padded, std::string_view word) {
  const std::string_view begin = colour_of(word);
  return begin.empty() ? std::string(padded)
                       : fmt::format("{}{}\033[0m", begin, padded);
}

std::string with_coloured_verdicts(std::string_view table) {
  std::string text;
  for (const std::string_view line : split(table, "\n")) {
    if (!text.empty()) text += '\n';
    std::string cells;
    for (const std::string_view cell : split(line, "|")) {
      if (cell.data() != line.data()) cells += '|';
      cells += coloured(cell, contact::detail::trimmed(cell));
    }
    text += cells;
  }
  return text;
}

}  // namespace cli
