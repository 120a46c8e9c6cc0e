#include "libcontact/conforming/contact_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace contact {
namespace {

// The last two Clenshaw sums of sum c_k f_k with the recurrence
// f_{k+1} = 2 y f_k - f_{k-1}.
template <class Coefficient>
std::pair<double, double> clenshaw(int terms, double y, Coefficient c) {
  double b0 = 0;
  double b1 = 0;
  for (int k = terms - 1; k >= 0; --k) {
    b1 = std::exchange(b0, 2 * y * b0 - b1 + c(k));
  }
  return {b0, b1};
}

// 1 - s^2 for s = tan(theta/2)/tan(theta0/2), without cancellation.
double one_minus_square(double theta, double half_angle) {
  const double cosine = std::cos(theta / 2);
  const double sine = std::sin(half_angle / 2);
  return std::sin((half_angle - theta) / 2) *
         std::sin((half_angle + theta) / 2) / (sine * sine * cosine * cosine);
}

}  // namespace

ContactPressure::ContactPressure(double half_angle, double force_ratio,
                                 std::span<const double> coefficients)
    : half_angle_(half_angle),
      force_ratio_(force_ratio),
      tangent_(std::tan(half_angle / 2)),
      terms_(static_cast<int>(
          std::min<std::size_t>(coefficients.size(), max_terms))) {
  std::copy_n(coefficients.begin(), terms_, coefficients_.begin());
}

double ContactPressure::pressure(double theta) const noexcept {
  theta = std::abs(theta);
  if (theta >= half_angle_) return 0;
  const double rest = one_minus_square(theta, half_angle_);
  // sin((2k+1) phi)/sin phi = f_k with f_{-1} = -1, f_0 = 1.
  const auto [b0, b1] = clenshaw(terms_, 1 - 2 * rest,
                                 [this](int k) { return coefficients_[k]; });
  return std::sqrt(rest) * (b0 + b1);
}

double ContactPressure::slope(double theta) const noexcept {
  const double t = std::abs(theta);
  if (t > half_angle_) return 0;
  const double rest = one_minus_square(t, half_angle_);
  // cos((2k+1) phi)/cos phi = f_k with f_{-1} = 1, f_0 = 1.
  const auto [b0, b1] = clenshaw(terms_, 1 - 2 * rest, [this](int k) {
    return (2 * k + 1) * coefficients_[k];
  });
  const double s = std::tan(theta / 2) / tangent_;
  const double cosine = std::cos(t / 2);
  return s * (b0 - b1) / (2 * tangent_ * cosine * cosine * std::sqrt(rest));
}

double ContactPressure::peak() const noexcept { return pressure(0); }

}  // namespace contact
