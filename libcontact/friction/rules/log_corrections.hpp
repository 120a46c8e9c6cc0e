#pragma once

#include <Eigen/Core>

#include "libcontact/friction/rules/modulus.hpp"

namespace contact::detail {

template <class Real>
struct GaussRule;

namespace rules {

/// For integrands f + g ln T, f and g smooth, g ~ T^2, T = 0 at the end behind
/// the last node: what to add to ln T at the last nodes so that a rule has
/// T^2 ln T, T^3 ln T, ... exactly, as many as it corrects nodes. The higher
/// powers are smooth enough for any rule.
class LogCorrections {
 public:
  /// Midpoints (i + 1/2) (pi/2)/steps, i < n, T = cos^2.
  static LogCorrections midpoint(int n, Real steps);
  /// The upper half of a rule, T = 1 - x^2.
  static LogCorrections gauss(const GaussRule<Real>& rule);

  /// ln cos^2 at node i with its correction. The cosine may be that of another
  /// variable, sqrt T times a smooth function.
  Real log_square(Real cosine, int i) const;

 private:
  /// By measurement; with 8 of 8 nodes the corrections are wild.
  static constexpr int most = 7;
  using Column = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, most, 1>;

  template <class Vanishing, class Weight, class Moment>
  LogCorrections(int n, Vanishing vanishing, Weight weight, Moment moment);

  int first_;
  Column value_;
};

}  // namespace rules
}  // namespace contact::detail
