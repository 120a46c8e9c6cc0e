#pragma once

#include <optional>

#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/law.hpp"
#include "libcontact/pressure/running_in.hpp"

namespace contact::detail {

/// A pressure law at one half-angle. The series of an exact pressure, also of a
/// joint that wears, are made once.
class PressureProfile {
 public:
  PressureProfile(const PressureLaw& law, double half_angle) noexcept
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

  /// PressureLaw::pressure()
  double pressure(double theta) const noexcept {
    const double p =
        exact_ ? exact_->pressure(theta) : law_->pressure(theta, half_angle_);
    return share_ == 0 ? p : with_wear(p, worn_->pressure(theta, half_angle_));
  }
  /// PressureLaw::slope()
  double slope(double theta) const noexcept {
    const double slope =
        exact_ ? exact_->slope(theta) : law_->slope(theta, half_angle_);
    return share_ == 0 ? slope
                       : with_wear(slope, worn_->slope(theta, half_angle_));
  }
  /// Whether the pressure is that of a joint with walls.
  bool has_walls() const noexcept { return has_walls_; }
  /// Whether the pressure falls from the centre to the edge.
  bool falls_outwards() const noexcept {
    return !has_walls_ || exact_->falls_outwards();
  }

 private:
  double with_wear(double of_law, double of_worn) const noexcept {
    return RunningInPressure::mixed(share_, of_law, of_worn);
  }

  const PressureLaw* law_;
  const WornPressure* worn_ = nullptr;
  double share_ = 0;  // of the worn pressure
  double half_angle_;
  std::optional<ContactPressure> exact_;
  bool has_walls_ = false;
};

}  // namespace contact::detail
