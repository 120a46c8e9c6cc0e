#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <vector>

#include "multibody_support/instant.hpp"

/// The traditional method, section 1.3 of the paper: the conditions of all
/// joints at once, a symmetric system of 3 (ball), 5 (axis) or 6 (held)
/// equations for each body, solved by Cholesky. Moments are about the centres
/// of mass, in body axes: another formulation than the library's, for any real
/// type.
namespace multibody::test {

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using Matrix = Eigen::Matrix<Real, 3, 3>;

template <class Real>
Matrix<Real> tilde(const Vector<Real>& a) {
  Matrix<Real> m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

/// One body in the dense equations.
template <class Real>
struct DenseBody {
  using V = Vector<Real>;
  using M = Matrix<Real>;
  using Rows = Eigen::Matrix<Real, Eigen::Dynamic, 6, 0, 6, 6>;
  using Multipliers = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, 6, 1>;

  Real mass;
  M inertia, inverse_inertia, rotation;
  V r, r0, w, friction, force, moment;
  Rows body_rows;     ///< conditions on the body's accelerations
  Rows carrier_rows;  ///< and on the carrier's
  Multipliers bias;   ///< bias: rows * accelerations + bias = 0

  DenseBody(const BodyInstant& body, const V& w0)
      : mass(body.body.mass),
        inertia(body.body.inertia.cast<Real>()),
        inverse_inertia(inertia.inverse()),
        rotation(body.body.kind == HingeKind::axis
                     ? turned(body)
                     : M(body.rotation.cast<Real>())),
        r(body.body.hinge_from_com.cast<Real>()),
        r0(body.body.hinge_from_carrier_com.cast<Real>()),
        friction(body.friction_moment.cast<Real>()),
        force(body.active_force.cast<Real>()),
        moment(body.active_moment_com.cast<Real>()) {
    const V relative = body.body.kind == HingeKind::axis
                           ? V(Real(body.angle_rate) *
                               body.body.hinge_to_body.cast<Real>().col(2))
                           : V(body.relative_angular_velocity.cast<Real>());
    const V w0_load = rotation.transpose() * w0;
    w = w0_load + relative;
    const M b = body.body.hinge_to_body.cast<Real>();
    if (body.body.kind == HingeKind::axis) friction = b * friction;
    if (body.mode == JointMode::held) friction.setZero();

    // Directions in which the body cannot turn.
    const int turns = body.mode == JointMode::released    ? 6
                      : body.mode == JointMode::held      ? 0
                      : body.body.kind == HingeKind::ball ? 3
                                                          : 1;
    const M d = body.body.kind == HingeKind::axis ? b : M(M::Identity());
    const int fixed = turns == 6 ? 0 : 3 - turns;
    const int rows = turns == 6 ? 0 : 6 - turns;
    Eigen::Matrix<Real, 6, 6> all = Eigen::Matrix<Real, 6, 6>::Zero();
    all.template topLeftCorner<3, 3>().setIdentity();
    all.template topRightCorner<3, 3>() = -tilde<Real>(r);
    all.template bottomRightCorner<3, 3>() = d.transpose();
    body_rows = all.topRows(rows);
    Eigen::Matrix<Real, 6, 6> carrier = Eigen::Matrix<Real, 6, 6>::Zero();
    carrier.template topLeftCorner<3, 3>() = -rotation.transpose();
    carrier.template topRightCorner<3, 3>() =
        rotation.transpose() * tilde<Real>(r0);
    carrier.template bottomRightCorner<3, 3>() = -(rotation * d).transpose();
    carrier_rows = carrier.topRows(rows);
    bias.resize(rows);
    if (rows > 0) {
      bias.head(3) = w.cross(w.cross(r)) -
                     rotation.transpose() * V(w0.cross(w0.cross(r0)));
      bias.tail(fixed) = (d.transpose() * w.cross(w0_load)).head(fixed);
    }
  }

  Eigen::Matrix<Real, 6, 1> free_acceleration() const {
    Eigen::Matrix<Real, 6, 1> a;
    a.template head<3>() = force / mass;
    a.template tail<3>() =
        inverse_inertia * (moment + friction - w.cross(inertia * w));
    return a;
  }
  Eigen::Matrix<Real, 6, 6> mobility() const {
    Eigen::Matrix<Real, 6, 6> m = Eigen::Matrix<Real, 6, 6>::Zero();
    m.template topLeftCorner<3, 3>().setIdentity();
    m *= 1 / mass;
    m.template bottomRightCorner<3, 3>() = inverse_inertia;
    return m;
  }

 private:
  static M turned(const BodyInstant& body) {
    const Real angle = body.angle;
    return body.body.hinge_to_carrier_zero.cast<Real>() *
           Eigen::AngleAxis<Real>(angle, V::UnitZ()).toRotationMatrix() *
           body.body.hinge_to_body.cast<Real>().transpose();
  }
};

/// Accelerations and reactions of an instant; bodies need inertia about every
/// axis. Joint moments of a body on an axis about the hinge's centre.
template <class Real>
InstantResult dense_evaluate(const Instant& instant) {
  using V = Vector<Real>;
  using Dense = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using Six = Eigen::Matrix<Real, 6, 1>;
  const V w0 = instant.angular_velocity.cast<Real>();
  const Matrix<Real> inertia = instant.carrier.inertia.cast<Real>();
  Eigen::Matrix<Real, 6, 6> mobility = Eigen::Matrix<Real, 6, 6>::Zero();
  mobility.template topLeftCorner<3, 3>().setIdentity();
  mobility /= Real(instant.carrier.mass);
  mobility.template bottomRightCorner<3, 3>() = inertia.inverse();
  std::vector<DenseBody<Real>> bodies;
  std::vector<int> first;
  int rows = 0;
  Six carrier;
  carrier.template head<3>() = instant.active_force.cast<Real>();
  carrier.template tail<3>() =
      instant.active_moment_com.cast<Real>() - w0.cross(inertia * w0);
  for (const BodyInstant& body : instant.bodies) {
    bodies.emplace_back(body, w0);
    first.push_back(rows);
    rows += static_cast<int>(bodies.back().bias.size());
    if (body.mode != JointMode::released) {
      carrier.template tail<3>() -=
          bodies.back().rotation * bodies.back().friction;
    } else {
      bodies.back().friction.setZero();
    }
  }
  carrier = mobility * carrier;

  Dense k(rows, rows);
  Eigen::Matrix<Real, Eigen::Dynamic, 1> rhs(rows);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const DenseBody<Real>& a = bodies[i];
    const int n = static_cast<int>(a.bias.size());
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      const DenseBody<Real>& b = bodies[j];
      k.block(first[i], first[j], n, b.bias.size()) =
          a.carrier_rows * mobility * b.carrier_rows.transpose();
    }
    k.block(first[i], first[i], n, n) +=
        a.body_rows * a.mobility() * a.body_rows.transpose();
    rhs.segment(first[i], n) = -(a.bias + a.carrier_rows * carrier +
                                 a.body_rows * a.free_acceleration());
  }
  const Eigen::Matrix<Real, Eigen::Dynamic, 1> multipliers =
      rows > 0 ? Eigen::Matrix<Real, Eigen::Dynamic, 1>(k.llt().solve(rhs))
               : rhs;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    carrier += mobility * bodies[i].carrier_rows.transpose() *
               multipliers.segment(first[i], bodies[i].bias.size());
  }

  InstantResult result;
  const V gravity =
      instant.rotation.cast<Real>().transpose() * instant.gravity.cast<Real>();
  const V linear = carrier.template head<3>();
  const V angular = carrier.template tail<3>();
  result.acceleration_minus_gravity = linear.template cast<double>();
  result.acceleration = V(linear + gravity).template cast<double>();
  result.angular_acceleration = angular.template cast<double>();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const DenseBody<Real>& body = bodies[i];
    const BodyInstant& given = instant.bodies[i];
    const Six forces = body.body_rows.transpose() *
                       multipliers.segment(first[i], body.bias.size());
    const Six a = body.free_acceleration() + body.mobility() * forces;
    const V w = a.template tail<3>();
    const V force = forces.template head<3>();
    // body_rows has moments about the centre of mass.
    const V moment = V(forces.template tail<3>()) - body.r.cross(force);
    const V w0_load = body.rotation.transpose() * w0;
    V relative =
        w - body.rotation.transpose() * angular + body.w.cross(w0_load);
    if (given.mode == JointMode::held) relative.setZero();  // a condition
    BodyResult out;
    out.acceleration =
        V(V(a.template head<3>()) + body.rotation.transpose() * gravity)
            .template cast<double>();
    out.angular_acceleration = w.template cast<double>();
    out.relative_angular_acceleration = relative.template cast<double>();
    const Matrix<Real> b = given.body.hinge_to_body.cast<Real>();
    out.angle_acceleration =
        static_cast<double>((b.transpose() * relative).z());
    out.reaction_force = force.template cast<double>();
    out.reaction_moment = moment.template cast<double>();
    out.reaction_moment_hinge =
        V(b.transpose() * moment).template cast<double>();
    result.bodies.push_back(out);
  }
  return result;
}

}  // namespace multibody::test
