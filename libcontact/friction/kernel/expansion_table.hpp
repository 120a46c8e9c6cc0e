#pragma once

#include <array>
#include <cmath>

#include "libcontact/friction/kernel/arc_rule.hpp"
#include "libcontact/pressure/expansion.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact {
class PressureLaw;
}

namespace contact::detail {

/// Kind of rule that an expansion needs from arc_rules().
[[gnu::always_inline]] inline ArcTerms arc_terms(const PressureExpansion& p) {
  // By measurement: they leave some 5e-11.
  constexpr int few = 8;
  constexpr int many = 12;
  constexpr double large = 0.02;
  constexpr double small = 1e-8;
  constexpr int most_of_usual = 16;
  if (p.size > most_of_usual) return ArcTerms::high_order;
  const double first = std::abs(p.coefficient[0]);
  if (p.has_logarithm()) {
    return p.size > many || std::abs(p.logarithmic[0]) > large * first
               ? ArcTerms::large_logarithm
               : ArcTerms::logarithm;
  }
  return p.size > few && std::abs(p.coefficient[p.size - 1]) > small * first
             ? ArcTerms::logarithm
             : ArcTerms::smooth;
}

/// PressureExpansion over a range of half-angles, for lanes to evaluate: each
/// of its numbers as a Chebyshev series in sqrt(theta0), the pressures times
/// 4 sin^2(theta0/2).
struct ExpansionTable {
  static constexpr int most_rows = 40;
  static constexpr int cosine_share = 0;
  static constexpr int edge_constant = 1;
  static constexpr int logarithmic = 2;
  static constexpr int coefficient = logarithmic + 3;
  static constexpr int columns = coefficient + PressureExpansion::max_terms;
  /// Up to here the series are good to 1e-12; no law's expansion is short
  /// much beyond.
  static constexpr double largest_half_angle = 2.0943951023931957;  // 120 deg

  /// @param lower, upper  ends of the range, (0, largest_half_angle]
  ExpansionTable(const PressureLaw& law, double lower, double upper);

  int rows;      ///< 1 for a single half-angle
  int size = 1;  ///< number of coefficients
  bool has_cosine = false, has_logarithm = false;
  ArcTerms arc_terms = ArcTerms::smooth;  ///< the most that any asks
  double middle;                          ///< value of sqrt(theta0)
  double inverse_half_width;
  /// One more than rows, for loops over pairs.
  std::array<std::array<double, most_rows + 1>, columns> series{};
};

}  // namespace contact::detail
