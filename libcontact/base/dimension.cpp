#include "libcontact/base/dimension.hpp"

#include <algorithm>
#include <numbers>

#include "libcontact/base/units.hpp"

namespace contact {
namespace {

constexpr double rpm = std::numbers::pi / 30;

// In the order of Dimension.
constexpr Unit units[][6] = {
    {{""}},
    {{"m"},
     {"mm", 1, 1e3},
     {"um", 1, 1e6},
     {"cm", 1, 1e2},
     {"in", 254, 1e4},
     {"km", 1e3}},
    {{"Pa"},
     {"kPa", 1e3},
     {"MPa", 1e6},
     {"GPa", 1e9},
     {"psi", 44482216152605, 6451600000}},  // lbf over in^2
    {{"N"}, {"kN", 1e3}, {"MN", 1e6}, {"lbf", 44482216152605, 1e13}},
    {{"N_per_m"}, {"kN_per_m", 1e3}, {"N_per_mm", 1e3}},
    {{"N_m"}, {"kN_m", 1e3}, {"N_mm", 1, 1e3}},
    {{"rad"}, {"deg", degree}},
    {{"rad_per_s"}, {"deg_per_s", degree}, {"rpm", rpm}},
    {{"rad_per_s2"}, {"deg_per_s2", degree}},
    {{"m_per_s"}, {"mm_per_s", 1, 1e3}, {"km_per_h", 1, 3.6}},
    {{"m_per_s2"}},
    {{"s"}, {"ms", 1, 1e3}},
    {{"kg"}, {"g", 1, 1e3}, {"t", 1e3}},
    {{"kg_m2"}},
    {{"Pa_s_per_m"},
     {"kPa_s_per_m", 1e3},
     {"MPa_s_per_m", 1e6},
     {"GPa_s_per_m", 1e9}},
    {{"s_per_m"}},
    {{"m_per_s_Pa"}, {"mm_per_s_MPa", 1, 1e9}},
    {{"m2"}},
    {{"m3"}, {"mm3", 1, 1e9}},
    {{"J"}},
    {{"W"}},
    {{"W_per_m2"}},
    {{"K"}, {"C", 1, 1, 273.15}},
    {{"per_K"}},
};

}  // namespace

std::span<const Unit> units_of(Dimension dimension) {
  const std::span<const Unit> all = units[static_cast<int>(dimension)];
  const auto end = std::find_if(all.begin() + 1, all.end(),
                                [](const auto& u) { return u.ending.empty(); });
  return {all.begin(), end};
}

const Unit& unit_of(Dimension dimension, std::string_view ending) {
  return *std::ranges::find(units_of(dimension), ending, &Unit::ending);
}

const Unit& printed_unit(Dimension dimension) {
  switch (dimension) {
    case Dimension::angle:
      return unit_of(dimension, "deg");
    case Dimension::temperature:
      return unit_of(dimension, "C");
    default:
      return units_of(dimension).front();
  }
}

std::string unit_symbol(std::string_view ending) {
  const auto per = ending.find("_per_");
  if (per != ending.npos) {
    return unit_symbol(ending.substr(0, per)) + '/' +
           unit_symbol(ending.substr(per + 5));
  }
  if (ending.ends_with('2') || ending.ends_with('3')) {
    return unit_symbol(ending.substr(0, ending.size() - 1)) + '^' +
           ending.back();
  }
  std::string text(ending);
  std::ranges::replace(text, '_', ' ');
  return text;
}

}  // namespace contact
