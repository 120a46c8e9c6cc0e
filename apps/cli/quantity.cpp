#include "cli/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <string>

#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"

namespace cli {
namespace {

using contact::Dimension;
using contact::Unit;

// Characters between the numbers of a list or range.
constexpr const char* separators = ",:";

// "N/m" and "N_per_m" are one, and so are "N_m", "N*m", "N m" and "Nm".
std::string spelling(std::string_view unit) {
  constexpr std::string_view per = "_per_";
  std::string text(unit);
  for (std::size_t at; (at = text.find(per)) != text.npos;) {
    text.replace(at, per.size(), 1, '/');
  }
  std::erase_if(text,
                [](char c) { return std::strchr("_*^ \t", c) != nullptr; });
  return text;
}

// Null if the text is not a unit of this dimension.
const Unit* find_unit(std::string_view text, Dimension dimension) {
  const auto all = contact::units_of(dimension);
  const auto unit = std::ranges::find(
      all, spelling(text), [](const Unit& u) { return spelling(u.ending); });
  return unit == all.end() ? nullptr : &*unit;
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t") == text.npos;
}

// "a number in N, kN, MN or lbf"
std::string unit_rule(Dimension dimension) {
  std::vector<std::string> names;
  for (const Unit& unit : contact::units_of(dimension)) {
    names.emplace_back(unit.ending);
  }
  return "a number in " + contact::detail::either(names);
}

}  // namespace

std::vector<std::string_view> split(std::string_view text,
                                    std::string_view cuts) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find_first_of(cuts);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

std::optional<double> read_quantity(std::string_view option,
                                    std::string_view text,
                                    Dimension dimension) {
  if (dimension == Dimension::number) return parse_number(text);
  std::string_view rest = text;
  const auto number = take_number(rest);
  if (!number || is_blank(rest)) return number;
  const Unit* unit = find_unit(rest, dimension);
  if (unit == nullptr) refuse(option, text, unit_rule(dimension));
  const Unit* plain = &contact::printed_unit(dimension);
  return unit == plain ? *number : plain->from_si(unit->to_si(*number));
}

contact::KeySetting quantity_key(std::string_view option, std::string_view text,
                                 std::string_view key, Dimension dimension) {
  std::string_view rest = text;
  const auto number = take_number(rest);
  const Unit* unit = is_blank(rest) ? &contact::printed_unit(dimension)
                                    : find_unit(rest, dimension);
  if (!number || unit == nullptr) refuse(option, text, unit_rule(dimension));
  return {fmt::format("{}_{}", key, unit->ending), number_text(*number),
          given(option, text)};
}

void refuse_some_units(std::string_view option, std::string_view text) {
  bool with = false;
  bool without = false;
  for (std::string_view part : split(text, separators)) {
    const auto number = take_number(part);
    if (!number) continue;
    with = with || !is_blank(part);
    without = without || (is_blank(part) && *number != 0);
  }
  if (with && without) {
    refuse(option, text, "numbers that all have a unit, or all have none");
  }
}

std::optional<Dimension> unit_dimension(
    std::string_view text, std::initializer_list<Dimension> among) {
  for (std::string_view part : split(text, separators)) {
    if (!take_number(part) || is_blank(part)) continue;
    for (const Dimension dimension : among) {
      if (find_unit(part, dimension) != nullptr) return dimension;
    }
  }
  return std::nullopt;
}

// Two groups may also be an ascending list of a number below 100 and one below
// 1000, for which a note does no harm; "0,5kN" may be a list too, but hardly.
bool looks_like_thousands(std::string_view text) {
  const auto groups = split(text, ",");
  const auto is_digits = [](std::string_view group) {
    return group.find_first_not_of("0123456789") == group.npos;
  };
  if (groups.size() != 2 || !is_digits(groups[0])) return false;
  if (groups[0] == "0") {
    return groups[1].find_first_of("123456789") == 0 && !is_digits(groups[1]) &&
           groups[1].find_first_of(".:") == groups[1].npos;
  }
  return !groups[0].empty() && groups[0].size() < 3 && groups[0][0] != '0' &&
         groups[1].size() == 3 && is_digits(groups[1]);
}

bool has_cut_number(std::string_view text) {
  bool found = false;
  for (const std::string_view group : split(text, ",")) {
    const std::size_t digits =
        std::min(group.find_first_not_of("0123456789"), group.size());
    const std::string_view unit = group.substr(digits);
    const bool is_whole =
        digits > 0 && std::ranges::all_of(unit, [](unsigned char c) {
          return std::isalpha(c) != 0 || c == ' ';
        });
    if (!is_whole) return false;
    found = found || (digits > 1 && group[0] == '0');
  }
  return found && text.find(',') != text.npos;
}

double parse_quantity(std::string_view option, std::string_view text,
                      Dimension dimension, const Allowed& allowed) {
  const auto value = read_quantity(option, text, dimension);
  if (!value || !allowed.contains(*value)) {
    refuse(option, text, allowed.rule(value.has_value()));
  }
  return *value;
}

double parse_value(std::string_view option, std::string_view text,
                   const Allowed& allowed) {
  return parse_quantity(option, text, Dimension::number, allowed);
}

int parse_count(std::string_view option, std::string_view text, int min,
                int max) {
  const auto value = parse_number(text);
  if (!value || !(*value >= min && *value <= max) ||
      *value != std::floor(*value)) {
    refuse(option, text, fmt::format("a whole number, {} to {}", min, max));
  }
  return static_cast<int>(*value);
}

std::array<double, 3> parse_vector(std::string_view option,
                                   std::string_view text, std::string_view what,
                                   Dimension dimension) {
  const auto parts = split(text, ",");
  std::array<double, 3> vector = {};
  bool good = parts.size() == vector.size();
  for (std::size_t i = 0; good && i < vector.size(); ++i) {
    const auto number = read_quantity(option, parts[i], dimension);
    good = number && std::isfinite(*number);
    if (good) vector[i] = *number;
  }
  if (!good) refuse(option, text, fmt::format("X,Y,Z, {}", what));
  if (dimension != Dimension::number) refuse_some_units(option, text);
  return vector;
}

}  // namespace cli
