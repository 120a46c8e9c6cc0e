// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <span>
#include <vector>

/// Forces of an application on its bodies.
namespace multibody {

/// Motion of a body. In rows of bodies the carrier comes first.
struct BodyMotion {
  Eigen::Vector3d position;  ///< centre of mass, inertial axes, m
  Eigen::Vector3d velocity;  ///< centre of mass, inertial axes, m/s
  /// Body axes to inertial axes.
  Eigen::Matrix3d rotation;
  Eigen::Vector3d angular_velocity;  ///< inertial axes, rad/s
  /// Angle of the hinge of a body on an axis, full turns counted, rad; after
  /// its release the angle at that time. NaN otherwise.
  double hinge_angle = std::numeric_limits<double>::quiet_NaN();

  /// Position of a point fixed to the body, inertial axes, m.
  /// @param from_com  from the centre of mass, body axes, m
  Eigen::Vector3d point(const Eigen::Vector3d& from_com) const {
    return position + rotation * from_com;
  }
  /// Velocity of this point, inertial axes, m/s.
  Eigen::Vector3d point_velocity(const Eigen::Vector3d& from_com) const {
    return velocity + angular_velocity.cross(rotation * from_com);
  }
};

/// Load on a body, inertial axes.
struct BodyForce {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about the COM, N m

  /// Adds a force whose line passes through a point.
  /// @param point  inertial axes, m
  void add_at(const BodyMotion& body, const Eigen::Vector3d& point,
              const Eigen::Vector3d& applied) {
    force += applied;
    moment += (point - body.position).cross(applied);
  }
};

/// Mass of a body that changes as propellant leaves it.
///
/// All positions of the body, its motion and the points of forces continue to
/// refer to the initial place of its centre of mass.
struct BodyMass {
  int body;                 ///< in rows of bodies: the carrier comes first
  double mass;              ///< kg, > 0
  Eigen::Vector3d com;      ///< centre of mass, body axes, m
  Eigen::Matrix3d inertia;  ///< about it, body axes, kg m^2
  // Time derivatives of the three.
  double mass_rate;
  Eigen::Vector3d com_rate;
  Eigen::Matrix3d inertia_rate;
};

/// A variable of the bodies' positions over which a force has kinks, such as a
/// table at its rows.
struct KinkedVariable {
  double value;
  std::span<const double> kinks;  ///< increasing
};

/// Applied forces and moments: thrust, springs, pushers, air. Not uniform
/// gravity (MotionOptions::gravity), reactions or hinge friction.
///
/// Called at every evaluation of the accelerations, also at trial states that a
/// step later discards: it must depend only on its arguments, be cheap, and
/// must not allocate or throw. Smooth between the times of next_break() and the
/// kinks of add_kinks().
class ForceModel {
 public:
  virtual ~ForceModel() = default;

  /// Adds to `forces`, one for each body, initially 0.
  virtual void add_forces(double time, std::span<const BodyMotion> bodies,
                          std::span<BodyForce> forces) const = 0;

  /// Appends the masses at a time of the bodies with Carrier::flows or
  /// Body::flows. The accelerations follow from a rigid body with this mass;
  /// add_forces() accounts for the escaping mass.
  virtual void add_masses([[maybe_unused]] double time,
                          [[maybe_unused]] std::vector<BodyMass>& to) const {}

  /// Next time after `time` at which a force jumps or has a kink: steps end
  /// there, and add_forces() at that time gives the forces after it. Infinity:
  /// none.
  virtual double next_break([[maybe_unused]] double time) const {
    return std::numeric_limits<double>::infinity();
  }

  /// Appends the variables over which active forces have kinks, and their
  /// values at these positions of the bodies. Steps end where a variable passes
  /// a kink, so that narrow features behind it are not missed.
  /// @param during  a time in the step; variables do not change between breaks
  virtual void add_kinks(
      [[maybe_unused]] double during,
      [[maybe_unused]] std::span<const BodyMotion> bodies,
      [[maybe_unused]] std::vector<KinkedVariable>& to) const {}
};

}  // namespace multibody
