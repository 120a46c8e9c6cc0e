#pragma once

#include <span>
#include <string>

#include "libcontact/pressure/law.hpp"

namespace contact {

/// p = p0 (cos theta - cos theta0) (3.3), for 0 <= theta0 <= pi.
///
/// p0 is the amplitude; the peak pressure is p0 (1 - cos theta0), 263 times
/// less at theta0 = 5 deg (the paper calls p0 the peak).
/// With h = sin(theta0/2), c = cos theta0, s = sin theta0:
///
/// | | ball | pin |
/// |---|---|---|
/// | 1/p0 = I_n | (pi/3)(1 - c)^2 (2 + c) | theta0 - s c |
/// | peak | 3/(2 pi h^2 (2 + c)) | 2 h^2/(theta0 - s c) |
/// | S | 3/(2 + c) | 2 (s - theta0 c)/(theta0 - s c) |
///
/// Accuracy: relative error at most 1e-15 for theta0 from 1e-150 rad to
/// 170 deg, 2e-15 for pressure(), at any theta inside
/// (pressure/cosine_test.cpp, against the formulas in high precision). slope()
/// overflows to infinity below 1e-102 rad.
class CosinePressure final : public PressureLaw {
 public:
  explicit CosinePressure(JointKind kind) : PressureLaw(kind) {}

  std::string name() const override { return "cosine"; }
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

/// I_n of the cosine pressure: the force that p0 = 1 carries, in units of
/// rho^2 (ball) or rho (pin).
///
///     ball: (pi/3)(1 - c)^2 (2 + c),  (pi/4) theta0^4 as theta0 -> 0 (3.4)
///     pin:  theta0 - sin theta0 cos theta0,  (2/3) theta0^3
///
/// @param half_angle  theta0, rad, [0, pi]; NaN outside
/// @return relative error at most 1e-15 (pressure/cosine_test.cpp) while the
/// result
///         is a normal number.
double cosine_normal_integral(JointKind kind, double half_angle);

}  // namespace contact
