#pragma once

#include <Eigen/Core>

namespace contact::detail {

/// Spherical Bessel functions j_1(x), j_3(x), ..., j_{2 count - 1}(x), to
/// 1e-14 absolute (conforming/gap_test.cpp, against Boost).
/// @param x    >= 0
/// @param out  as many as its size says
void odd_spherical_bessel(double x, Eigen::VectorXd& out);

}  // namespace contact::detail
