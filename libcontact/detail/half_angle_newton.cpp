#include "libcontact/detail/half_angle_newton.hpp"

#include <Eigen/LU>

namespace contact::detail {

void DirectStart::fit(const std::array<double, 4>& xi) {
  // Multiplied out, the law is linear in its coefficients:
  //   r^2 (1 + d1 xi + d2 xi^2 + n1 xi^3 + n2 xi^4)
  //     = xi^2 (1 + n1 xi + n2 xi^2),   r = theta0/limit.
  Eigen::Matrix4d matrix;
  Eigen::Vector4d right;
  for (int i = 0; i < 4; ++i) {
    const double r2 = shares[i] * shares[i];
    const double x1 = xi[i];
    const double x2 = x1 * x1;
    matrix.row(i) << (r2 - 1) * x1 * x2, (r2 - 1) * x2 * x2, r2 * x1, r2 * x2;
    right(i) = x2 - r2;
  }
  const Eigen::Vector4d solution = matrix.partialPivLu().solve(right);
  n1_ = solution(0);
  n2_ = solution(1);
  d1_ = solution(2);
  d2_ = solution(3);
}

}  // namespace contact::detail
