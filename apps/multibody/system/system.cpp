#include "multibody/system/system.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A moment of inertia that small beside the largest is rounding of zero.
constexpr double zero_inertia = 1e-14;

[[noreturn]] void refuse(const std::string& what, const std::string& rule) {
  throw contact::Error(contact::detail::must_be(what, rule));
}

void check_mass(double mass, const std::string& place) {
  if (std::isfinite(mass) && mass > 0) return;
  refuse(fmt::format("{}.mass = {} kg", place, mass), "above 0 and finite");
}

void check_finite(const Vector3d& v, const std::string& place) {
  if (!v.allFinite()) refuse(place, "finite");
}

std::string above_rounding(double scale) {
  return fmt::format("above {} kg m^2, the rounding of the largest moment",
                     zero_inertia * scale);
}

// The symmetric part; principal moments >= 0, or all > 0.
Matrix3d checked_inertia(const Matrix3d& inertia, bool positive,
                         const std::string& place) {
  if (!inertia.allFinite()) refuse(place, "finite");
  const double scale = inertia.cwiseAbs().maxCoeff();
  const double skew = (inertia - inertia.transpose()).cwiseAbs().maxCoeff();
  // Products of inertia printed with seven digits still pass.
  if (skew > 1e-6 * scale) {
    refuse(place, fmt::format("symmetric, it is off by {} kg m^2", skew));
  }
  Matrix3d symmetric = 0.5 * (inertia + inertia.transpose());
  const double smallest =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(symmetric, Eigen::EigenvaluesOnly)
          .eigenvalues()[0];
  if (positive ? smallest <= zero_inertia * scale
               : smallest < -zero_inertia * scale) {
    refuse(fmt::format("{}: smallest principal moment = {} kg m^2", place,
                       smallest),
           positive ? above_rounding(scale) : "0 or above");
  }
  return symmetric;
}

// Right-handed axes with the given z; the other two are arbitrary.
Matrix3d axes_along(const Vector3d& z) {
  Matrix3d axes;
  axes.col(2) = z.stableNormalized();
  axes.col(0) = axes.col(2).unitOrthogonal();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

Matrix3d turn_about_z(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

// Turns `axes` about their z so that the inertia seen by x and y with z left
// free to turn, I_xy - j j^T/I_zz, is diagonal: then so is N of (1.3).
Matrix3d axes_of_ball(const Matrix3d& inertia, const Vector3d& r) {
  if (r.isZero(0)) {
    Matrix3d axes =
        Eigen::SelfAdjointEigenSolver<Matrix3d>(inertia).eigenvectors();
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

Link ball_link(const Body& body, const std::string& place) {
  Link link{};
  link.axes = axes_of_ball(body.inertia, body.hinge_from_com);
  link.arm = body.hinge_from_com.stableNorm();
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

Link axis_link(const Body& body, const std::string& place) {
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

Link free_link(const Body& body) {
  Link link{};
  link.axes = Matrix3d::Identity();
  link.inertia = body.inertia;
  return link;
}

Link make_link(Body body, const std::string& place) {
  check_mass(body.mass, place);
  body.inertia = checked_inertia(body.inertia, body.kind == HingeKind::none,
                                 place + ".inertia_com");
  check_finite(body.hinge_from_com, place + ".hinge_from_com");
  check_finite(body.hinge_from_carrier_com, place + ".hinge_from_carrier_com");
  Link link = body.kind == HingeKind::ball   ? ball_link(body, place)
              : body.kind == HingeKind::axis ? axis_link(body, place)
                                             : free_link(body);
  link.kind = body.kind;
  link.mass = body.mass;
  return link;
}

}  // namespace

Matrix3d checked_rotation(const Matrix3d& matrix, const std::string& place) {
  const double error = (matrix.transpose() * matrix - Matrix3d::Identity())
                           .cwiseAbs()
                           .maxCoeff();
  // Seven printed digits pass.
  if (!(error <= 1e-6) || matrix.determinant() < 0) {
    refuse(place, "a rotation matrix (orthogonal to 1e-6, right-handed)");
  }
  return Eigen::Quaterniond(matrix).normalized().toRotationMatrix();
}

System::System(const Carrier& carrier, const std::vector<Body>& bodies)
    : carrier_(carrier) {
  if (carrier.fixed) {
    carrier_ = {.fixed = true};
  } else {
    check_mass(carrier.mass, "carrier");
    carrier_.inertia =
        checked_inertia(carrier.inertia, true, "carrier.inertia_com");
  }
  links_.reserve(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    links_.push_back(make_link(bodies[i], fmt::format("bodies[{}]", i)));
  }
}

}  // namespace multibody
