#include "multibody/system/hinges/axis.hpp"

#include <algorithm>
#include <cmath>

#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/hinges/link_checks.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// v_1 + v_c cos t + v_s sin t
struct Turning {
  Vector3d one, cos, sin;
};

/// The matrices of 1, cos t, sin t, cos 2t, sin 2t.
struct Harmonics {
  Matrix3d one = Matrix3d::Zero(), cos = one, sin = one, cos2 = one, sin2 = one;

  // += factor * a b^T
  void add(double factor, const Turning& a, const Turning& b) {
    const auto outer = [&](const Vector3d& u, const Vector3d& v) {
      return Matrix3d(factor * u * v.transpose());
    };
    one +=
        outer(a.one, b.one) + 0.5 * (outer(a.cos, b.cos) + outer(a.sin, b.sin));
    cos += outer(a.one, b.cos) + outer(a.cos, b.one);
    sin += outer(a.one, b.sin) + outer(a.sin, b.one);
    cos2 += 0.5 * (outer(a.cos, b.cos) - outer(a.sin, b.sin));
    sin2 += 0.5 * (outer(a.cos, b.sin) + outer(a.sin, b.cos));
  }
  void add_unit(const Harmonics& traces) {
    one += traces.one.trace() * Matrix3d::Identity();
    cos += traces.cos.trace() * Matrix3d::Identity();
    sin += traces.sin.trace() * Matrix3d::Identity();
    cos2 += traces.cos2.trace() * Matrix3d::Identity();
    sin2 += traces.sin2.trace() * Matrix3d::Identity();
  }
};

}  // namespace

Link AxisHinge::link(const Body& body, const std::string& place) {
  Link link{};
  const Matrix3d to_body =
      checked_rotation(body.hinge_to_body, place + ".hinge_to_body");
  const Matrix3d to_carrier = checked_rotation(
      body.hinge_to_carrier_zero, place + ".hinge_to_carrier_zero");
  const Vector3d r = to_body.transpose() * body.hinge_from_com;
  link.arm = std::hypot(r.x(), r.y());
  link.axes_to_hinge =
      turn_about_z(link.arm > 0 ? std::atan2(r.y(), r.x()) : 0.0);
  link.axes = to_body * link.axes_to_hinge;
  link.axes_to_carrier_zero = to_carrier * link.axes_to_hinge;
  link.pole_offset = r.z();
  link.inertia = link.axes.transpose() * body.inertia * link.axes;
  link.hinge = body.hinge_from_carrier_com - r.z() * to_carrier.col(2);
  const double about_axis =
      link.inertia(2, 2) + body.mass * link.arm * link.arm;
  if (!(about_axis > zero_inertia * body.inertia.trace())) {
    refuse(fmt::format("{}.inertia_com: inertia about the axis = {} kg m^2",
                       place, about_axis),
           above_rounding(body.inertia.trace()));
  }
  return link;
}

AxisConstants<double> AxisHinge::constants(const Link& link) {
  AxisConstants<double> k{};
  const double m = link.mass;
  const Matrix3d& i = link.inertia;
  k.mass = m;
  k.arm = link.arm;
  k.mass_arm = m * link.arm;
  const double jzz = i(2, 2) + k.mass_arm * link.arm;
  k.inverse_jzz = 1 / jzz;
  k.k = k.mass_arm * k.inverse_jzz;
  k.inertia = sym3(i);
  k.zero = mat3(link.axes_to_carrier_zero);
  k.hinge = vec3(link.hinge);
  k.pole_offset = link.pole_offset;

  const Matrix3d& c = link.axes_to_carrier_zero;
  const Vector3d none = Vector3d::Zero();
  const Turning x{none, c.col(0), c.col(1)};
  const Turning y{none, c.col(1), -c.col(0)};
  const Turning z{c.col(2), none, none};
  const Turning com{link.hinge, -link.arm * x.cos, -link.arm * x.sin};
  const Turning p{
      jzz * z.one,
      i(0, 2) * x.cos + i(1, 2) * y.cos - k.mass_arm * link.hinge.cross(y.cos),
      i(0, 2) * x.sin + i(1, 2) * y.sin - k.mass_arm * link.hinge.cross(y.sin)};
  k.p_1 = vec3(p.one);
  k.p_cos = vec3(p.cos);
  k.p_sin = vec3(p.sin);

  // F: the body as one piece with the carrier, less p p^T/J_zz.
  Harmonics f;
  const Turning* axes[] = {&x, &y, &z};
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) {
      f.add(i(std::min(row, col), std::max(row, col)), *axes[row], *axes[col]);
    }
  }
  Harmonics com_squared;
  com_squared.add(m, com, com);
  f.add_unit(com_squared);
  f.add(-m, com, com);
  f.add(-k.inverse_jzz, p, p);
  k.f_1 = sym3(f.one);
  k.f_cos = sym3(f.cos);
  k.f_sin = sym3(f.sin);
  k.f_cos2 = sym3(f.cos2);
  k.f_sin2 = sym3(f.sin2);
  return k;
}

}  // namespace multibody
