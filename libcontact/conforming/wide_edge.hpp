#pragma once

#include <cmath>

namespace contact::detail {

/// The edge variable in which exact pressures have short series, also for wide
/// contacts:
///
///     x^2 = (cos theta - cos theta0)/((1 - c)(1 + 2 c + cos theta)),
///     c = cos(theta0/2),
///
/// 0 at the edge, 1 at the centre. A pressure over x is analytic in cos theta
/// but for a cut from -1 to -infinity, whose ends this x^2 puts at equal
/// distances from both ends of [0, 1]: series in it converge like
/// ((1 - sqrt c)/(1 + sqrt c))^(2k), in the edge variable of PressureLaw,
/// y^2 = 1 - tan^2(theta/2)/tan^2(theta0/2), like ((1 - c)/(1 + c))^k.
class WideEdge {
 public:
  explicit WideEdge(double half_angle)
      : half_angle_(half_angle), c_(std::cos(half_angle / 2)) {}

  /// cos(theta0/2)
  double cosine() const { return c_; }
  /// 1 + 2 c, which stands beside cos theta.
  double constant() const { return 1 + 2 * c_; }

  /// x^2 at theta in [0, theta0], without cancellation.
  double square(double theta) const {
    const double q = std::sin(half_angle_ / 4);
    return std::sin((half_angle_ - theta) / 2) / q *
           (std::sin((half_angle_ + theta) / 2) / q) /
           (constant() + std::cos(theta));
  }

  /// -d(x^2)/dtheta
  double square_slope(double theta) const {
    const double q = std::sin(half_angle_ / 4);
    const double sum = constant() + std::cos(theta);
    return c_ * (1 + c_) * (std::sin(theta) / q) / q / (sum * sum);
  }

  /// y^2/x^2 at a given x^2.
  template <class V>
  V tangent_share(const V& square) const {
    return 1 / (c_ + (1 - c_) * square);
  }
  /// x^2/y^2 at a given y^2.
  double share(double tangent_square) const {
    return c_ / (1 - (1 - c_) * tangent_square);
  }

 private:
  double half_angle_;
  double c_;
};

}  // namespace contact::detail
