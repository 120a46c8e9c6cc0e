#pragma once

#include <array>

#include "libcontact/pressure/law.hpp"

namespace contact {

/// A pressure as the sum of the cosine pressure and one that starts like a
/// square root from the edge,
///
///     p = cosine_share p[cosine] + edge_pressure + x sum_k c_k B_k
///         + x^3 ln X sum_k b_k x^(2k),
///     X^2 = (cos theta - cos theta0)/(1 - cos theta0),
///     x^2 = X^2 (1 + v)/(v + cos theta),
///     B_k = y^r (y^4 - y^2)^j,  y = 2 x^2 - 1,  k = r + 4 j,  r < 4,
///
/// to which the friction integrals have short ways. x and X are 0 at the edge
/// and 1 at the centre for every v; with v = 1, x is the edge variable of
/// PressureLaw. ln X and not ln x: along a great circle X is a constant times
/// a cosine. The B_k cost what powers of y do, which would multiply roundings
/// by 2.4^k; these do by 2.4^(k/2). Which of the parts there are at all, a law
/// says for all half-angles at once; NaN for theta0 that it is not defined for.
struct PressureExpansion {
  static constexpr int max_terms = 32;
  double cosine_share = 0;
  double edge_pressure = 0;  ///< pressure units
  double edge_constant = 1;  ///< v, >= 1
  int size = 0;
  /// c_k, pressure units; from `size` on negligible, counted or not.
  std::array<double, max_terms> coefficient = {};
  std::array<double, 3> logarithmic = {};  ///< b_k, likewise

  /// B_k at the centre: 1, and from here on 0.
  static constexpr int powers = 4;
  /// Nothing: the law has no expansion.
  bool is_empty() const {
    return cosine_share == 0 && edge_pressure == 0 && size == 0 &&
           !has_logarithm();
  }
  /// The cosine pressure itself.
  bool is_cosine() const {
    return cosine_share == 1 && edge_pressure == 0 && size == 0 &&
           !has_logarithm();
  }
  bool has_logarithm() const {
    return logarithmic[0] != 0 || logarithmic[1] != 0 || logarithmic[2] != 0;
  }
};

namespace detail {

/// Parts of a law's expansion, for is_empty() and is_cosine().
inline PressureExpansion expansion_form(const PressureLaw& law) noexcept {
  return expansion_of(law, law.largest_half_angle() / 2);
}

}  // namespace detail

}  // namespace contact
