#pragma once

#include <array>
#include <numbers>
#include <optional>

#include "libcontact/conforming/contact_pressure.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact {
class WornPressure;
}

namespace contact::detail {

/// A pressure law at one half-angle. The series of an exact pressure, also of a
/// joint that wears, are made once. For a wide contact (beyond
/// PressureLaw::largest_half_angle()) it is a Chebyshev series in sqrt(1 -
/// theta/theta0), within 1e-6 of the peak (pressure/interference_test.cpp).
class PressureProfile {
 public:
  PressureProfile(const PressureLaw& law, double half_angle) noexcept;

  /// PressureLaw::pressure()
  double pressure(double theta) const noexcept;
  /// PressureLaw::slope()
  double slope(double theta) const noexcept;
  /// Whether expansions of the law are less accurate than it: with walls, and
  /// of wide contacts.
  bool is_beyond_expansions() const noexcept { return has_walls_ || is_wide_; }
  /// Whether the pressure falls from the centre to the edge.
  bool falls_outwards() const noexcept {
    return is_wide_ ? half_angle_ == std::numbers::pi
                    : !has_walls_ || exact_->falls_outwards();
  }

 private:
  const PressureLaw* law_;
  const WornPressure* worn_ = nullptr;
  double share_ = 0;  // share of the worn pressure
  double half_angle_;
  std::optional<ContactPressure> exact_;
  bool has_walls_ = false;
  bool is_wide_ = false;
  // Series of a wide contact that is not closed all round.
  static constexpr int terms = 48;
  struct Value {
    double pressure;
    double slope;  // -dp/dtheta
  };
  void tabulate() noexcept;
  Value tabulated(double theta) const noexcept;
  std::array<double, terms> series_ = {};
};

}  // namespace contact::detail
