#pragma once

#include "libcontact/pair/material.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/pressure/law.hpp"
#include "libcontact/pressure/sqrt.hpp"

namespace contact {

/// Contrast D of an elastic pair, which decides how its exact pressure differs
/// from equal materials at the same half-angle; in [-1/2, 1/2], 0 for equal
/// materials. With k_i = (1 - 2 nu_i)/(2 (1 - nu_i)) and w_i the share of (1 -
/// nu_i^2)/E_i in their sum:
///
///     pin:  D = w_2 k_2 - w_1 k_1, Dundurs' beta
///     ball: D = w_2 k_2 (1 - 2 nu_2) - w_1 k_1 (1 - 2 nu_1)
///
/// A pin's pressure depends on theta0 and D alone; for a ball D is the leading
/// term of the kernel (docs/explanation/conforming.md).
double pressure_contrast(JointKind kind, const ElasticPair& pair);

/// p = w p[sqrt_tan] + (1 - w) p[cosine]: the exact pressure in closed form,
/// nearly, for 0 <= theta0 <= 175 deg.
///
///     w = cos^m(theta0/2) (1 - sum_k (c_k + D d_k) sin^k(theta0/2)),
///
/// k = 1 to 5, m = 2 (ball) or 3 (pin), with D = pressure_contrast(); the c_k
/// and d_k are fitted to S of the exact pressures of 85 pairs
/// (libcontact/tools/reference/fit_pressure_mixture.cpp). One weight serves
/// all: S, the peak and the friction coefficients.
///
/// Accuracy against ExactPressure (pressure/family_test.cpp), on pairs not used
/// in the fit, Ebar 0 to infinity, nu 0 to 0.5, theta0 up to the limit
/// half-angle: S within 0.8 % (ball) and 0.1 % (pin), the peak within 2.5 %
/// and 0.7 %.
class MixturePressure final : public PressureLaw {
 public:
  MixturePressure(JointKind kind, const ElasticPair& pair);

  std::string name() const override { return "mixture"; }
  double pressure(double theta, double half_angle) const noexcept override;
  double slope(double theta, double half_angle) const noexcept override;
  void edge_slopes(double half_angle, std::span<const double> edge_variable,
                   std::span<double> out) const noexcept override;
  double peak(double half_angle) const noexcept override;
  double force_ratio(double half_angle) const noexcept override;
  double largest_half_angle() const noexcept override;

  /// w, the share of sqrt_tan.
  double sqrt_tan_share(double half_angle) const noexcept;

 private:
  PressureExpansion expansion(double half_angle) const noexcept override;
  double mix(double half_angle, double sqrt_tan, double cosine) const noexcept;

  SqrtTanPressure sqrt_tan_;
  CosinePressure cosine_;
  double contrast_;
};

}  // namespace contact
