// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>

/// Dimensions, units and ranges of numbers.
namespace contact {

/// Dimension of a key, which fixes the unit endings it takes: the length
/// `radius` may be spelled radius (in m), radius_m, radius_mm, radius_um. A key
/// without an ending is in the first unit of its list.
enum class Dimension {
  number,                ///< no unit, no ending
  length,                ///< m, mm, um, cm, in, km
  stress,                ///< Pa, kPa, MPa, GPa, psi
  force,                 ///< N, kN, MN, lbf
  line_force,            ///< N_per_m, kN_per_m, N_per_mm
  moment,                ///< N_m, kN_m, N_mm
  angle,                 ///< rad, deg
  angular_velocity,      ///< rad_per_s, deg_per_s, rpm
  angular_acceleration,  ///< rad_per_s2, deg_per_s2
  velocity,              ///< m_per_s, mm_per_s, km_per_h
  acceleration,          ///< m_per_s2
  time,                  ///< s, ms
  mass,                  ///< kg, g, t
  inertia,               ///< kg_m2
  viscous_constant,      ///< Pa_s_per_m, kPa_s_per_m, ... GPa_s_per_m
  inverse_velocity,      ///< s_per_m
  hersey,                ///< m_per_s_Pa, mm_per_s_MPa
  area,                  ///< m2
  volume,                ///< m3, mm3
  energy,                ///< J
  power,                 ///< W
  power_density,         ///< W_per_m2
  temperature,           ///< K, C
  inverse_temperature,   ///< per_K
};

/// A unit of keys and options. value in SI = value * multiply / divide +
/// offset; powers of ten are divided where that is exact, so that 50 mm is the
/// double nearest to 0.05 m.
struct Unit {
  std::string_view ending;  ///< ending of keys: "N_per_m"; "" for none
  double multiply = 1;
  double divide = 1;
  double offset = 0;  ///< for temperatures only; 0 leaves -0 as it is

  double to_si(double value) const {
    const double scaled = value * multiply / divide;
    return offset == 0 ? scaled : scaled + offset;
  }
  double from_si(double value) const {
    return (offset == 0 ? value : value - offset) * divide / multiply;
  }
};

/// The first one applies to a key without an ending.
std::span<const Unit> units_of(Dimension dimension);
/// The one with this ending.
const Unit& unit_of(Dimension dimension, std::string_view ending);
/// Unit of printed tables and of a plain number on a command line: degrees and
/// degrees Celsius, else the first one.
const Unit& printed_unit(Dimension dimension);
/// "kg m^2" of "kg_m2", "Pa s/m" of "Pa_s_per_m".
std::string unit_symbol(std::string_view ending);

/// Values that a number may take, in SI units. Always finite, unless
/// `or_infinity`.
struct Interval {
  double low;
  double high;
  bool low_excluded = false;
  bool high_excluded = false;
  bool or_infinity = false;  ///< +infinity too

  static constexpr double largest = std::numeric_limits<double>::max();
  static constexpr Interval any() { return {-largest, largest}; }
  static constexpr Interval positive() { return {0, largest, true}; }
  static constexpr Interval non_negative() { return {0, largest}; }

  /// False for NaN.
  bool contains(double value) const {
    if (std::isinf(value)) return or_infinity && value > 0;
    return (low_excluded ? value > low : value >= low) &&
           (high_excluded ? value < high : value <= high);
  }
};

}  // namespace contact
