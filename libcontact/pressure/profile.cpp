#include "libcontact/pressure/profile.hpp"

#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/running_in.hpp"

namespace contact::detail {

PressureProfile::PressureProfile(const PressureLaw& law,
                                 double half_angle) noexcept
    : law_(&law), half_angle_(half_angle) {
  if (const auto* wears = dynamic_cast<const RunningInPressure*>(&law)) {
    law_ = &wears->law();
    worn_ = &wears->worn();
    share_ = wears->share(half_angle);
  }
  if (const auto* exact = dynamic_cast<const ExactPressure*>(law_)) {
    exact_ = exact->contact(half_angle);
    has_walls_ = exact->has_walls();
  }
}

double PressureProfile::pressure(double theta) const noexcept {
  const double p =
      exact_ ? exact_->pressure(theta) : law_->pressure(theta, half_angle_);
  if (share_ == 0) return p;
  return RunningInPressure::mixed(share_, p,
                                  worn_->pressure(theta, half_angle_));
}

double PressureProfile::slope(double theta) const noexcept {
  const double slope =
      exact_ ? exact_->slope(theta) : law_->slope(theta, half_angle_);
  if (share_ == 0) return slope;
  return RunningInPressure::mixed(share_, slope,
                                  worn_->slope(theta, half_angle_));
}

}  // namespace contact::detail
