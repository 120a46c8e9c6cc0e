#pragma once

#include <string>
#include <vector>

#include "libcontact/pair/joint_geometry.hpp"

namespace contact::reference {

/// Coefficients of MixturePressure and the largest relative error of S that
/// they leave on the pairs of the fit.
struct MixtureFit {
  std::vector<double> equal;     ///< c_k, k = 1, 2, ...
  std::vector<double> contrast;  ///< d_k
  double largest_error;
};

/// Fits them to S of ExactPressure by least squares of its relative error,
/// over theta0 up to the limit half-angle of each pair, or where ExactPressure
/// ends if that is less.
MixtureFit fit_pressure_mixture(JointKind kind);

/// libcontact/pressure/mixture_coefficients.hpp.
std::string pressure_mixture_header();

}  // namespace contact::reference
