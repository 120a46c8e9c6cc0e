#pragma once

#include <string>
#include <vector>

namespace contact::reference {

enum class EllipticKind { k, e };

/// P(x) - Q(x) ln x with the smallest largest relative error on (0, 1] that the
/// order allows; x = 1 - k^2. The terms without x come from the limit x -> 0
/// (ln 4 and 1/2 for K, 1 and 0 for E), the rest is fitted.
struct EllipticLogFit {
  std::vector<double> p;  ///< coefficients of x, x^2, ..., x^order in P
  std::vector<double> q;  ///< the same of Q
  double error;           ///< largest relative error before rounding
  int exchanges;          ///< Remez exchanges used
};

/// Remez exchange in 50-digit arithmetic: the powers and the powers times
/// ln x form a Chebyshev system on (0, 1], so the best approximation is the
/// one whose relative error takes its largest value with alternating signs at
/// 2 order + 1 points. Extrema are found on a grid of 1,000 points and
/// refined by a parabola; the exchange stops when the largest error exceeds
/// the levelled one by less than 1e-9 of it.
///
/// @param order  1 to 9; otherwise throws Error, as when the exchange fails
EllipticLogFit fit_elliptic_log_form(EllipticKind kind, int order);

/// The text of libcontact/friction/elliptic/log_coefficients.hpp; printed by
/// the program fit-elliptic.
std::string elliptic_log_coefficients_header();

}  // namespace contact::reference
