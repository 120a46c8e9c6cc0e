#pragma once

#include <string>
#include <vector>

#include "libcontact/pair/joint_geometry.hpp"

namespace contact::reference {

/// Coefficients of FittedLaw for one kind of joint, fitted to ExactLaw.
struct FittedCoefficients {
  /// One row per feature, detail::fitted_terms columns.
  std::vector<std::vector<double>> rows;
  /// Largest relative error of theta0 at the same load on the pairs of the
  /// fit, before rounding.
  double largest_error;
};

/// Least squares weighted so that every residual is a relative error of
/// theta0, then Lawson's iteration towards the smallest largest error. Pairs:
/// Ebar from 0.03 to 30, 0 and infinity, both Poisson's ratios from 0 to 0.5;
/// half-angles from 0.05 deg to the limit.
FittedCoefficients fit_fitted_law(JointKind kind);

/// The text of libcontact/half_angle/coefficients.hpp; printed by the
/// program fit-half-angle.
std::string half_angle_coefficients_header();

}  // namespace contact::reference
