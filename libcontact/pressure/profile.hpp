#pragma once

#include <optional>

#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact::detail {

/// A pressure law at one half-angle. The series of an exact pressure are made
/// once.
class PressureProfile {
 public:
  PressureProfile(const PressureLaw& law, double half_angle) noexcept
      : law_(&law), half_angle_(half_angle) {
    if (const auto* exact = dynamic_cast<const ExactPressure*>(&law)) {
      exact_ = exact->contact(half_angle);
      has_walls_ = exact->has_walls();
    }
  }

  /// PressureLaw::pressure()
  double pressure(double theta) const noexcept {
    return exact_ ? exact_->pressure(theta)
                  : law_->pressure(theta, half_angle_);
  }
  /// PressureLaw::slope()
  double slope(double theta) const noexcept {
    return exact_ ? exact_->slope(theta) : law_->slope(theta, half_angle_);
  }
  /// Whether the pressure is that of a joint with walls.
  bool has_walls() const noexcept { return has_walls_; }
  /// Whether the pressure falls from the centre to the edge.
  bool falls_outwards() const noexcept {
    return !has_walls_ || exact_->falls_outwards();
  }

 private:
  const PressureLaw* law_;
  double half_angle_;
  std::optional<ContactPressure> exact_;
  bool has_walls_ = false;
};

}  // namespace contact::detail
