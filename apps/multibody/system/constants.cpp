#include "multibody/system/constants.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "multibody/system/eigen_conversion.hpp"

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

BallConstants<double> ball_constants(const Link& link) {
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

AxisConstants<double> axis_constants(const Link& link) {
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

HeldConstants<double> held_constants(const Link& link) {
  const bool axis = link.kind == HingeKind::axis;
  return {link.mass,
          sym3(link.inertia),
          axis ? Vec3<double>{link.arm, 0, 0} : Vec3<double>{0, 0, link.arm},
          vec3(link.hinge),
          mat3(link.axes_to_carrier_zero),
          link.pole_offset};
}

FreeConstants<double> free_constants(const Link& link) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(link.inertia);
  // A direction without inertia has no rotation to speak of: it rests.
  const double largest = eigen.eigenvalues()[2];
  Vector3d inverse;
  for (int i = 0; i < 3; ++i) {
    const double moment = eigen.eigenvalues()[i];
    inverse[i] = moment > 1e-14 * largest ? 1 / moment : 0;
  }
  const Matrix3d& v = eigen.eigenvectors();
  return {1 / link.mass, sym3(link.inertia),
          sym3(v * inverse.asDiagonal() * v.transpose())};
}

SystemConstants::SystemConstants(const System& system)
    : carrier_mass_(system.carrier().mass),
      carrier_inertia_(sym3(system.carrier().inertia)) {
  bodies_.reserve(system.links().size());
  for (const Link& link : system.links()) {
    LinkConstants& body = bodies_.emplace_back();
    body.kind = link.kind;
    body.held = held_constants(link);
    body.free = free_constants(link);
    if (link.kind == HingeKind::ball) {
      body.ball = ball_constants(link);
    } else if (link.kind == HingeKind::axis) {
      body.axis = axis_constants(link);
    }
  }
}

int SystemConstants::size() const { return static_cast<int>(bodies_.size()); }
double SystemConstants::carrier_mass() const { return carrier_mass_; }
const Sym3<double>& SystemConstants::carrier_inertia() const {
  return carrier_inertia_;
}
HingeKind SystemConstants::kind(int body) const { return bodies_[body].kind; }
const BallConstants<double>& SystemConstants::ball(int body) const {
  return bodies_[body].ball;
}
const AxisConstants<double>& SystemConstants::axis(int body) const {
  return bodies_[body].axis;
}
const HeldConstants<double>& SystemConstants::held(int body) const {
  return bodies_[body].held;
}
const FreeConstants<double>& SystemConstants::free(int body) const {
  return bodies_[body].free;
}

}  // namespace multibody
