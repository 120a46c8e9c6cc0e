#pragma once

#include <array>

#include "libcontact/pressure_expansion.hpp"

namespace contact {
class PressureLaw;
}

namespace contact::detail {

/// Whether terms of a high order count, as in an exact pressure beyond 90 deg.
[[gnu::always_inline]] inline bool is_rough(const PressureExpansion& p) {
  constexpr int few = 8;
  const double first = p.coefficient.front();
  const double last = p.coefficient[p.size - 1];
  return p.size > few && last * last > 1e-16 * first * first;
}

/// PressureExpansion over a range of half-angles, for lanes to evaluate: each
/// of its numbers as a Chebyshev series in sqrt(theta0), the pressures times
/// 4 sin^2(theta0/2).
struct ExpansionTable {
  static constexpr int most_rows = 32;
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
  int size = 1;  ///< of the coefficients
  bool has_cosine = false, has_logarithm = false, rough = false;
  double middle;  ///< of sqrt(theta0)
  double inverse_half_width;
  /// One more than rows, for loops over pairs.
  std::array<std::array<double, most_rows + 1>, columns> series{};
};

}  // namespace contact::detail
