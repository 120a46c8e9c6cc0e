#include "multibody/system/hinges/ball.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "libcontact/base/linear/parts.hpp"
#include "libcontact/base/magnitude.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/hinges/link_checks.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Right-handed axes with the given z; the other two are arbitrary.
Matrix3d axes_along(const Vector3d& z) {
  Matrix3d axes;
  axes.col(2) = z.stableNormalized();
  axes.col(0) = axes.col(2).unitOrthogonal();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

// Turns `axes` about their z so that the inertia seen by x and y with z left
// free to turn, I_xy - j j^T/I_zz, is diagonal: then so is N of (1.3).
Matrix3d axes_of_ball(const Matrix3d& inertia, const Vector3d& r) {
  if (r.isZero(0)) {
    Matrix3d axes = contact::detail::symmetric_parts(inertia).vectors;
    if (axes.determinant() < 0) axes.col(0) *= -1;
    return axes;
  }
  const Matrix3d axes = axes_along(r);
  const Matrix3d i = axes.transpose() * inertia * axes;
  const double per_spin =
      i(2, 2) > zero_inertia * inertia.trace() ? 1 / i(2, 2) : 0;
  const double xx = i(0, 0) - i(0, 2) * i(0, 2) * per_spin;
  const double yy = i(1, 1) - i(1, 2) * i(1, 2) * per_spin;
  const double xy = i(0, 1) - i(0, 2) * i(1, 2) * per_spin;
  return axes * turn_about_z(0.5 * std::atan2(2 * xy, xx - yy));
}

}  // namespace

Link BallHinge::link(const Body& body, const std::string& place) {
  Link link{};
  link.axes = axes_of_ball(body.inertia, body.hinge_from_com);
  link.arm = contact::magnitude(body.hinge_from_com);
  link.inertia = link.axes.transpose() * body.inertia * link.axes;
  link.hinge = body.hinge_from_carrier_com;
  const double scale = body.inertia.trace();
  const bool can_turn = link.arm * link.arm * body.mass > 0;
  const double smallest = link.inertia.diagonal().minCoeff();
  if (!can_turn && !(smallest > zero_inertia * scale)) {
    refuse(fmt::format(
               "{}.inertia_com: smallest moment about the joint = {} kg m^2",
               place, smallest),
           fmt::format("{}, or the joint away from the centre of mass",
                       above_rounding(scale)));
  }
  // A point on a thread has no spin; what rounding left of it goes.
  if (link.inertia(2, 2) <= zero_inertia * scale) {
    link.inertia.row(2).setZero();
    link.inertia.col(2).setZero();
  }
  return link;
}

BallConstants<double> BallHinge::constants(const Link& link) {
  BallConstants<double> k{};
  const double m = link.mass;
  const Matrix3d& i = link.inertia;
  k.inverse_mass = 1 / m;
  k.arm = link.arm;
  k.mass_arm = m * link.arm;
  k.spin = i(2, 2);
  k.inverse_spin = k.spin > 0 ? 1 / k.spin : 0;
  k.ux = i(0, 2) * k.inverse_spin;
  k.uy = i(1, 2) * k.inverse_spin;
  // Negative by rounding only: System checked the principal moments.
  k.ix = std::max(0.0, i(0, 0) - k.ux * i(0, 2));
  k.iy = std::max(0.0, i(1, 1) - k.uy * i(1, 2));
  k.inverse_dx = 1 / (k.ix + k.mass_arm * link.arm);
  k.inverse_dy = 1 / (k.iy + k.mass_arm * link.arm);
  k.kx = k.mass_arm * k.inverse_dx;
  k.ky = k.mass_arm * k.inverse_dy;
  k.n = {m * k.iy * k.inverse_dy, m * k.ix * k.inverse_dx, m};
  k.n_xy = k.n.x - k.n.y;
  k.n_zy = k.n.z - k.n.y;
  k.hinge = vec3(link.hinge);
  return k;
}

}  // namespace multibody
