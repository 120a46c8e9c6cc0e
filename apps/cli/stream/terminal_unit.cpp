#include "cli/stream/terminal_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/number.hpp"
#include "cli/picture/axis.hpp"

namespace cli {
namespace {

using contact::Dimension;

// Number of the last Dimension.
constexpr int dimensions = static_cast<int>(Dimension::inverse_temperature);

// Products of units in columns of results; no key has them.
constexpr std::array<std::string_view, 2> products = {"Pa_m", "N_m_s"};

struct SiPrefix {
  double factor;
  std::string_view symbol;
};
// Descending; µ as in the programs' pictures.
constexpr std::array<SiPrefix, 7> si_prefixes = {{{1e9, "G"},
                                                  {1e6, "M"},
                                                  {1e3, "k"},
                                                  {1, ""},
                                                  {1e-3, "m"},
                                                  {1e-6, "µ"},
                                                  {1e-9, "n"}}};
// Powers of lengths use the prefixes of the length.
constexpr std::array<SiPrefix, 2> area_prefixes = {{{1, ""}, {1e-6, "m"}}};
constexpr std::array<SiPrefix, 2> volume_prefixes = {{{1, ""}, {1e-9, "m"}}};

template <class Prefixes>
const SiPrefix& prefix_for(double value, const Prefixes& all) {
  // Allows for half a unit of the fourth digit: 999.96 becomes 1.000 of the
  // next prefix.
  const double size = std::abs(value) * (1 + 5e-5);
  for (const SiPrefix& prefix : all) {
    if (size >= prefix.factor) return prefix;
  }
  return all.back();
}

// The unit at the end of a column's name.
struct EndUnit {
  std::string_view ending = {};  ///< "": none
  bool printed = false;          ///< true if it is the unit of tables
};

EndUnit unit_at_end(std::string_view column) {
  EndUnit best;
  const auto take = [&](std::string_view end, bool printed) {
    // A single letter of a symbol, such as f_t, is a unit only if tables print
    // it, or of masses.
    if (end.empty() ||
        (end.size() == 1 && !printed && column.find("mass_") == column.npos)) {
      return;
    }
    if (column.size() <= end.size() + 1 || !column.ends_with(end) ||
        column[column.size() - end.size() - 1] != '_') {
      return;
    }
    if (best.ending.size() < end.size()) best = {end, printed};
  };
  for (int d = 0; d <= dimensions; ++d) {
    const auto dimension = static_cast<Dimension>(d);
    for (const contact::Unit& unit : contact::units_of(dimension)) {
      take(unit.ending, &unit == &contact::printed_unit(dimension));
    }
  }
  for (const std::string_view end : products) take(end, true);
  return best;
}

// A divisor of several units: (N m).
std::string grouped(const std::string& symbol) {
  return symbol.find(' ') == symbol.npos ? symbol : '(' + symbol + ')';
}

}  // namespace

ShownUnit ShownUnit::scaled(double value) const {
  // What is left by rounding has an exponent and no prefix.
  constexpr double least = si_prefixes.back().factor;
  if (!prefixes || std::abs(value) < least || !std::isfinite(value)) {
    return *this;
  }
  const SiPrefix& prefix =
      symbol == "m^2"   ? prefix_for(value, area_prefixes)
      : symbol == "m^3" ? prefix_for(value, volume_prefixes)
      : symbol == "m"   ? prefix_for(std::min(std::abs(value), 999.0),
                                     si_prefixes)  // no km of a joint
                        : prefix_for(value, si_prefixes);
  ShownUnit unit = *this;
  unit.symbol = std::string(prefix.symbol) + symbol;
  unit.divide = divide * prefix.factor;
  return unit;
}

std::string ShownUnit::text(double value) const {
  const double number = value / divide + 0.0;  // no -0
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  constexpr double largest_count = 1e7;
  if (number == std::floor(number) && std::abs(number) < largest_count) {
    return fmt::format("{:.0f}", number);
  }
  const std::string rounded = rounded_text(number, 4);
  const double shown = std::stod(rounded);
  // Keeps trailing zeros only of a rounded number; from 10^4 on rounded_text()
  // would use an exponent.
  const bool is_long = std::abs(shown) >= 1e4 && std::abs(shown) < 1e7;
  return shown == number || is_long ? number_text(shown) : rounded;
}

ShownUnit shown_unit(std::string_view column) {
  const auto [end, printed] = unit_at_end(column);
  if (end.empty()) return {std::string(column)};
  const std::string_view front =
      column.substr(0, column.size() - end.size() - 1);
  if (front.ends_with("_per")) {
    // Units that no key has: K_N_m_per_rad.
    ShownUnit unit = shown_unit(front.substr(0, front.size() - 4));
    unit.symbol += "/" + grouped(contact::unit_symbol(end));
    unit.prefixes = false;
    return unit;
  }
  ShownUnit unit{std::string(front), with_micro(contact::unit_symbol(end))};
  unit.prefixes = printed && end != "deg" && end != "C" && end != "kg" &&
                  end != "per_K" && end != "rad_per_s" && end != "kg_m2";
  if (end == "deg") unit.symbol = "°";
  // As pictures and catalogues have it.
  if (end == "W_per_m2" && front.find("pv") != front.npos) {
    unit.symbol = "Pa m/s";
  }
  return unit;
}

}  // namespace cli
