#include "libcontact/pressure/profile.hpp"

#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/running_in.hpp"

namespace contact::detail {
namespace {

using detail::pi;

}  // namespace

PressureProfile::PressureProfile(const PressureLaw& law,
                                 double half_angle) noexcept
    : law_(&law), half_angle_(half_angle) {
  if (const auto* wears = dynamic_cast<const RunningInPressure*>(&law)) {
    law_ = &wears->law();
    worn_ = &wears->worn();
    share_ = wears->share(half_angle);
  }
  is_wide_ = half_angle > law_->largest_half_angle() &&
             half_angle <= law_->closing_half_angle();
  if (is_wide_) {
    tabulate();
    return;
  }
  if (const auto* exact = dynamic_cast<const ExactPressure*>(law_)) {
    exact_ = exact->contact(half_angle);
    has_walls_ = exact->has_walls();
  }
}

// Over u = sqrt(1 - theta/theta0): smooth at the edge, where the pressure
// begins like a power 3/2 or 1/2 of the distance.
void PressureProfile::tabulate() noexcept {
  if (half_angle_ == pi) return;
  std::array<double, terms> values;
  for (int i = 0; i < terms; ++i) {
    const double u = (1 + std::cos(pi * (i + 0.5) / terms)) / 2;
    values[i] = law_->pressure(half_angle_ * (1 - u * u), half_angle_);
  }
  for (int k = 0; k < terms; ++k) {
    double sum = 0;
    for (int i = 0; i < terms; ++i) {
      sum += values[i] * std::cos(pi * k * (i + 0.5) / terms);
    }
    series_[k] = (k == 0 ? 1.0 : 2.0) / terms * sum;
  }
}

PressureProfile::Value PressureProfile::tabulated(double theta) const noexcept {
  if (half_angle_ == pi) {
    const double p = law_->pressure(0, pi) / 2;
    return {p * (1 + std::cos(theta)), p * std::sin(theta)};
  }
  const double share = std::abs(theta) / half_angle_;
  if (!(share < 1)) return {share >= 1 ? 0 : share, share >= 1 ? 0 : share};
  const double u = std::sqrt(1 - share);
  const double v = 2 * u - 1;
  // Clenshaw's sums, and their derivatives by v.
  double b0 = 0, b1 = 0, d0 = 0, d1 = 0;
  for (int k = terms - 1; k > 0; --k) {
    const double d = 2 * b0 + 2 * v * d0 - d1;
    const double b = 2 * v * b0 - b1 + series_[k];
    d1 = d0;
    d0 = d;
    b1 = b0;
    b0 = b;
  }
  const double rate = b0 + v * d0 - d1;
  // du/dtheta = -1/(2 u theta0)
  return {v * b0 - b1 + series_[0],
          std::copysign(rate / (u * half_angle_), theta)};
}

double PressureProfile::pressure(double theta) const noexcept {
  if (is_wide_) return tabulated(theta).pressure;
  const double p =
      exact_ ? exact_->pressure(theta) : law_->pressure(theta, half_angle_);
  if (share_ == 0) return p;
  return RunningInPressure::mixed(share_, p,
                                  worn_->pressure(theta, half_angle_));
}

double PressureProfile::slope(double theta) const noexcept {
  if (is_wide_) return tabulated(theta).slope;
  const double slope =
      exact_ ? exact_->slope(theta) : law_->slope(theta, half_angle_);
  if (share_ == 0) return slope;
  return RunningInPressure::mixed(share_, slope,
                                  worn_->slope(theta, half_angle_));
}

}  // namespace contact::detail
