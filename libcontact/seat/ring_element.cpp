#include "libcontact/seat/ring_element.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace contact::detail {
namespace {

struct Shape {
  Eigen::Matrix<double, 8, 1> value;
  Eigen::Matrix<double, 8, 2> slope;
};

// Serendipity functions at (x, y) of the square -1 to 1.
Shape shape(double x, double y) {
  constexpr double at_x[] = {-1, 1, 1, -1}, at_y[] = {-1, -1, 1, 1};
  Shape n;
  for (int i = 0; i < 4; ++i) {
    const double a = at_x[i], b = at_y[i];
    n.value(i) = (1 + a * x) * (1 + b * y) * (a * x + b * y - 1) / 4;
    n.slope(i, 0) = a * (1 + b * y) * (2 * a * x + b * y) / 4;
    n.slope(i, 1) = b * (1 + a * x) * (a * x + 2 * b * y) / 4;
  }
  for (const int i : {4, 6}) {
    const double b = i == 4 ? -1 : 1;
    n.value(i) = (1 - x * x) * (1 + b * y) / 2;
    n.slope.row(i) << -x * (1 + b * y), b * (1 - x * x) / 2;
  }
  for (const int i : {5, 7}) {
    const double a = i == 7 ? -1 : 1;
    n.value(i) = (1 + a * x) * (1 - y * y) / 2;
    n.slope.row(i) << a * (1 - y * y) / 2, -y * (1 + a * x);
  }
  return n;
}

// Elastic matrix for the strains of ring_stiffness: along x, z, around, then
// twice the shears xz, x around, z around.
Eigen::Matrix<double, 6, 6> stiffness_of(const Material& material,
                                         double unit) {
  // Nearer to 1/2 only rounding would change.
  const double nu = std::min(material.poissons_ratio, 0.4999);
  const double shear = material.youngs_modulus / unit / (2 * (1 + nu));
  const double lame = 2 * shear * nu / (1 - 2 * nu);
  Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
  d.topLeftCorner<3, 3>().setConstant(lame);
  d.diagonal() << lame + 2 * shear, lame + 2 * shear, lame + 2 * shear, shear,
      shear, shear;
  return d;
}

}  // namespace

Eigen::Matrix<double, 24, 24> ring_stiffness(const RingElementNodes& nodes,
                                             int m, const Material& material,
                                             double unit) {
  const Eigen::Matrix<double, 6, 6> d = stiffness_of(material, unit);
  const double point = std::sqrt(1.0 / 3);
  Eigen::Matrix<double, 24, 24> k = Eigen::Matrix<double, 24, 24>::Zero();
  Eigen::Matrix<double, 6, 24> b;
  for (const double at_x : {-point, point}) {
    for (const double at_y : {-point, point}) {
      const Shape n = shape(at_x, at_y);
      const Eigen::Matrix2d to = n.slope.transpose() * nodes;
      const double area = std::abs(to.determinant());
      const Eigen::Matrix<double, 8, 2> slope =
          n.slope * to.inverse().transpose();
      const double x = n.value.dot(nodes.col(0));
      b.setZero();
      for (int i = 0; i < 8; ++i) {
        const double over = n.value(i) / x;
        const double along = slope(i, 0), up = slope(i, 1);
        b.col(3 * i) << along, 0, over, up, -m * over, 0;
        b.col(3 * i + 1) << 0, up, 0, along, 0, -m * over;
        b.col(3 * i + 2) << 0, 0, m * over, 0, along - over, up;
      }
      k.noalias() += (area * x) * (b.transpose() * (d * b));
    }
  }
  return k;
}

}  // namespace contact::detail
