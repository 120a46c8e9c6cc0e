#pragma once

#include <optional>

#include "libcontact/conforming/contact_pressure.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact {
class WornPressure;
}

namespace contact::detail {

/// A pressure law at one half-angle. The series of an exact pressure, also of a
/// joint that wears, are made once.
class PressureProfile {
 public:
  PressureProfile(const PressureLaw& law, double half_angle) noexcept;

  /// PressureLaw::pressure()
  double pressure(double theta) const noexcept;
  /// PressureLaw::slope()
  double slope(double theta) const noexcept;
  /// Whether the pressure is that of a joint with walls.
  bool has_walls() const noexcept { return has_walls_; }
  /// Whether the pressure falls from the centre to the edge.
  bool falls_outwards() const noexcept {
    return !has_walls_ || exact_->falls_outwards();
  }

 private:
  const PressureLaw* law_;
  const WornPressure* worn_ = nullptr;
  double share_ = 0;  // of the worn pressure
  double half_angle_;
  std::optional<ContactPressure> exact_;
  bool has_walls_ = false;
};

}  // namespace contact::detail
