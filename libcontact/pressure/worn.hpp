#pragma once

#include <span>
#include <string>

#include "libcontact/pressure/law.hpp"

namespace contact {

/// p = p(0) cos theta: a seat or hole that has worn in while the ball or pin
/// turned about one axis and sank steadily (docs/internals/pressure_laws.md).
/// Unlike all others it does not vanish at the edge.
///
/// | | ball | pin |
/// |---|---|---|
/// | p(0) | 3/(2 pi (1 - c^3)) | 1/(theta0 + s c) |
/// | S | 3 s^2/(2 (1 - c^3)) | 2 s/(theta0 + s c) |
///
/// Exact for a pin, and for a ball if all points slide alike. Friction
/// integrals combine the cosine pressure and the area, I[p] + c I[1]. 0 to 90
/// deg; relative error of peak and S at most 2e-15 (pressure/family_test.cpp).
class WornPressure final : public PressureLaw {
 public:
  explicit WornPressure(JointKind kind) : PressureLaw(kind) {}

  std::string name() const override { return "worn"; }
  double pressure(double theta, double half_angle) const noexcept override;
  double slope(double theta, double half_angle) const noexcept override;
  void edge_slopes(double half_angle, std::span<const double> edge_variable,
                   std::span<double> out) const noexcept override;
  double peak(double half_angle) const noexcept override;
  double force_ratio(double half_angle) const noexcept override;
  double largest_half_angle() const noexcept override;

 private:
  PressureExpansion expansion(double half_angle) const noexcept override;
};

}  // namespace contact
