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
}  // namespace detail

/// A formula for the load at a half-angle, for any elastic pair, fitted to the
/// exact contact: docs/internals/fitted_laws.md. With r =
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

}  // namespace contact
