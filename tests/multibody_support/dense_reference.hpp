#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <vector>

#include "multibody_support/instant.hpp"

/// The traditional way, section 1.3 of the paper: the conditions of all joints
/// at once, a symmetric system of 3 (spherical), 5 (axis) or 6 (held)
/// equations for each load, solved by Cholesky. Moments of the loads about
/// their centres of mass, in given axes: another formulation than the
/// library's, in any real type.
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

/// One load in the dense equations.
template <class Real>
struct DenseLoad {
  using V = Vector<Real>;
  using M = Matrix<Real>;
  using Rows = Eigen::Matrix<Real, Eigen::Dynamic, 6, 0, 6, 6>;
  using Multipliers = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, 6, 1>;

  Real mass;
  M inertia, inverse_inertia, rotation;
  V r, r0, w, friction, force, moment;
  Rows load_rows;     ///< conditions on the load's accelerations
  Rows carrier_rows;  ///< and on the carrier's
  Multipliers bias;   ///< conditions: rows * accelerations + bias = 0

  DenseLoad(const LoadInstant& load, const V& w0)
      : mass(load.load.mass),
        inertia(load.load.inertia.cast<Real>()),
        inverse_inertia(inertia.inverse()),
        rotation(load.load.kind == JointKind::axis
                     ? turned(load)
                     : M(load.rotation.cast<Real>())),
        r(load.load.hinge_from_com.cast<Real>()),
        r0(load.load.hinge_from_carrier_com.cast<Real>()),
        friction(load.friction_moment.cast<Real>()),
        force(load.active_force.cast<Real>()),
        moment(load.active_moment_com.cast<Real>()) {
    const V relative = load.load.kind == JointKind::axis
                           ? V(Real(load.angle_rate) *
                               load.load.hinge_to_load.cast<Real>().col(2))
                           : V(load.relative_angular_velocity.cast<Real>());
    const V w0_load = rotation.transpose() * w0;
    w = w0_load + relative;
    const M b = load.load.hinge_to_load.cast<Real>();
    if (load.load.kind == JointKind::axis) friction = b * friction;
    if (load.mode == JointMode::held) friction.setZero();

    // Directions in which the load cannot turn.
    const int turns = load.mode == JointMode::released         ? 6
                      : load.mode == JointMode::held           ? 0
                      : load.load.kind == JointKind::spherical ? 3
                                                               : 1;
    const M d = load.load.kind == JointKind::axis ? b : M(M::Identity());
    const int fixed = turns == 6 ? 0 : 3 - turns;
    const int rows = turns == 6 ? 0 : 6 - turns;
    Eigen::Matrix<Real, 6, 6> all = Eigen::Matrix<Real, 6, 6>::Zero();
    all.template topLeftCorner<3, 3>().setIdentity();
    all.template topRightCorner<3, 3>() = -tilde<Real>(r);
    all.template bottomRightCorner<3, 3>() = d.transpose();
    load_rows = all.topRows(rows);
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
  static M turned(const LoadInstant& load) {
    const Real angle = load.angle;
    return load.load.hinge_to_carrier_zero.cast<Real>() *
           Eigen::AngleAxis<Real>(angle, V::UnitZ()).toRotationMatrix() *
           load.load.hinge_to_load.cast<Real>().transpose();
  }
};

/// Accelerations and reactions of an instant; loads need inertia about every
/// axis. Joint moments of a load on an axis about the hinge's centre.
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
  std::vector<DenseLoad<Real>> loads;
  std::vector<int> first;
  int rows = 0;
  Six carrier;
  carrier.template head<3>() = instant.active_force.cast<Real>();
  carrier.template tail<3>() =
      instant.active_moment_com.cast<Real>() - w0.cross(inertia * w0);
  for (const LoadInstant& load : instant.loads) {
    loads.emplace_back(load, w0);
    first.push_back(rows);
    rows += static_cast<int>(loads.back().bias.size());
    if (load.mode != JointMode::released) {
      carrier.template tail<3>() -=
          loads.back().rotation * loads.back().friction;
    } else {
      loads.back().friction.setZero();
    }
  }
  carrier = mobility * carrier;

  Dense k(rows, rows);
  Eigen::Matrix<Real, Eigen::Dynamic, 1> rhs(rows);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const DenseLoad<Real>& a = loads[i];
    const int n = static_cast<int>(a.bias.size());
    for (std::size_t j = 0; j < loads.size(); ++j) {
      const DenseLoad<Real>& b = loads[j];
      k.block(first[i], first[j], n, b.bias.size()) =
          a.carrier_rows * mobility * b.carrier_rows.transpose();
    }
    k.block(first[i], first[i], n, n) +=
        a.load_rows * a.mobility() * a.load_rows.transpose();
    rhs.segment(first[i], n) = -(a.bias + a.carrier_rows * carrier +
                                 a.load_rows * a.free_acceleration());
  }
  const Eigen::Matrix<Real, Eigen::Dynamic, 1> multipliers =
      rows > 0 ? Eigen::Matrix<Real, Eigen::Dynamic, 1>(k.llt().solve(rhs))
               : rhs;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    carrier += mobility * loads[i].carrier_rows.transpose() *
               multipliers.segment(first[i], loads[i].bias.size());
  }

  InstantResult result;
  const V gravity =
      instant.rotation.cast<Real>().transpose() * instant.gravity.cast<Real>();
  const V linear = carrier.template head<3>();
  const V angular = carrier.template tail<3>();
  result.acceleration_minus_gravity = linear.template cast<double>();
  result.acceleration = V(linear + gravity).template cast<double>();
  result.angular_acceleration = angular.template cast<double>();
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const DenseLoad<Real>& load = loads[i];
    const LoadInstant& given = instant.loads[i];
    const Six forces = load.load_rows.transpose() *
                       multipliers.segment(first[i], load.bias.size());
    const Six a = load.free_acceleration() + load.mobility() * forces;
    const V w = a.template tail<3>();
    const V force = forces.template head<3>();
    // load_rows has moments about the centre of mass.
    const V moment = V(forces.template tail<3>()) - load.r.cross(force);
    const V w0_load = load.rotation.transpose() * w0;
    V relative =
        w - load.rotation.transpose() * angular + load.w.cross(w0_load);
    if (given.mode == JointMode::held) relative.setZero();  // a condition
    LoadResult out;
    out.acceleration =
        V(V(a.template head<3>()) + load.rotation.transpose() * gravity)
            .template cast<double>();
    out.angular_acceleration = w.template cast<double>();
    out.relative_angular_acceleration = relative.template cast<double>();
    const Matrix<Real> b = given.load.hinge_to_load.cast<Real>();
    out.angle_acceleration =
        static_cast<double>((b.transpose() * relative).z());
    out.reaction_force = force.template cast<double>();
    out.reaction_moment = moment.template cast<double>();
    out.reaction_moment_hinge =
        V(b.transpose() * moment).template cast<double>();
    result.loads.push_back(out);
  }
  return result;
}

}  // namespace multibody::test
