#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/pair/joint_geometry.hpp"

namespace contact::detail {

/// The variable u in [0, 1] in which what depends on a contact's half-angle
/// has short Chebyshev series: theta0/largest for a pin; its square root for a
/// ball, which hides a term theta0^3 ln(theta0). Walls change contacts whose
/// half-angle is of the order of t = thickness over radius: with them
/// ln(1 + theta0/t) takes the place of theta0.
class HalfAngleVariable {
 public:
  /// @param thickness  t; infinite without walls
  HalfAngleVariable(JointKind kind, double largest, double thickness)
      : ball_(kind == JointKind::ball),
        largest_(largest),
        thickness_(thickness),
        range_(std::log1p(largest / thickness)) {}

  bool has_walls() const { return std::isfinite(thickness_); }
  double thickness() const { return thickness_; }

  /// u and du/dtheta0.
  std::pair<double, double> operator()(double half_angle) const {
    const double share = has_walls()
                             ? std::log1p(half_angle / thickness_) / range_
                             : half_angle / largest_;
    // 1/(dshare/dtheta0)
    const double width =
        has_walls() ? (thickness_ + half_angle) * range_ : largest_;
    if (!ball_) return {share, 1 / width};
    // At theta0 = 0 the derivative of the series vanishes with u.
    const double u = std::sqrt(share);
    return {u, 0.5 / (width * std::max(u, 1e-150))};
  }

  /// theta0 and (largest - theta0)/largest, by u and 1 - u.
  std::pair<double, double> half_angle(double u, double rest) const {
    const double share = ball_ ? u * u : u;
    const double complement = ball_ ? rest * (1 + u) : rest;
    if (!has_walls()) return {largest_ * share, complement};
    return {thickness_ * std::expm1(range_ * share),
            -(1 + thickness_ / largest_) * std::expm1(-range_ * complement)};
  }

 private:
  bool ball_;
  double largest_;
  double thickness_;
  double range_;
};

}  // namespace contact::detail
