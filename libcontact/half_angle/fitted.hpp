#pragma once

#include <memory>
#include <string>
#include <vector>

#include "libcontact/half_angle/paper_laws.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"

namespace contact {

namespace detail {
class FittedHalfAngle;
struct NominalCoefficients;
}  // namespace detail

/// A formula for the load at a half-angle, for any elastic pair, fitted to the
/// exact contact: docs/half_angle.md, "The fitted laws". With r =
/// sin(theta0/2), c = cos^2(theta0/2):
///
///     pin:  r^2/lambda = c^2 - w_2 (2 r^4 - c^2 ln c)
///                        + beta sum r^k (C_1k + w_2 C_2k)
///     ball: 8 r^3/mu = (closed form in theta0 and c_0)
///                      + c^2 sum r^k (C_1k d_2 + C_2k d_3 + C_3k kappa
///                                     + C_4k c_0 d_2),     k = 1 ... 5
///
/// half_angle() finds the root by Newton's method inside a bracket.
///
/// Range: any pair, nu from 0 to 0.5, rigid bodies included, all loads.
/// Error of the law: theta0 within 0.021 % (pin) and 0.07 % (ball) of the
/// exact one at the same load; half_angle/fitted_test.cpp, on pairs that the
/// fit did not see. Accuracy of the code: round trips within 1e-14 of the
/// limit, log_slope within 1e-8.
class FittedLaw final : public HalfAngleLaw {
 public:
  FittedLaw(JointKind kind, const ElasticPair& pair);
  ~FittedLaw() override;

  std::string name() const override { return "fitted"; }
  HalfAngleResult half_angle(double load_parameter) const noexcept override;
  LoadParameterResult load_parameter(double half_angle) const noexcept override;
  double limit_half_angle() const noexcept override;
  /// None: the law holds for every pair.
  std::vector<std::string> validity_notes(
      const ElasticPair& pair) const override;

 private:
  std::unique_ptr<const detail::FittedHalfAngle> fit_;
};

/// A direct formula for the half-angle at a load, fitted to the exact contact
/// of materials with nu1 = nu2 = 0.3:
///
///     theta0 = theta0* xi sqrt((1 + n1 xi + n2 xi^2)
///              / (1 + d1 xi + d2 xi^2 + n1 xi^3 + n2 xi^4)),
///     xi = x/theta0*,
///
/// theta0*, n1, n2, d1, d2 polynomials in (Ebar - 1)/(Ebar + 1):
/// docs/half_angle.md.
///
/// Error of the law for nu = 0.3: 0.05 % (pin), 0.09 % (ball) of theta0 at the
/// same load, any Ebar, all loads. Other Poisson's ratios move theta0 by
/// several percent. Accuracy of the code: relative error at most 2e-15
/// forward, 2e-14 inverse (half_angle/fitted_test.cpp, against 50-digit
/// arithmetic).
class NominalLaw final : public SaturatingLaw {
 public:
  /// @param modulus_ratio  Ebar, [0, infinity]
  /// @throws Error if out of range.
  NominalLaw(JointKind kind, double modulus_ratio);

  std::string name() const override { return "nominal"; }
  /// Another Poisson's ratio than 0.3 in a body that deforms.
  std::vector<std::string> validity_notes(
      const ElasticPair& pair) const override;

 private:
  NominalLaw(JointKind kind, double al,
             const detail::NominalCoefficients& table);
  Shape shape(double xi) const noexcept override;
  InverseResult inverse_shape(double ratio,
                              double complement) const noexcept override;

  double n1_;
  double n2_;
  double d1_;
  double d2_;
};

}  // namespace contact
