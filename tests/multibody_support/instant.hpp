#pragma once

#include <Eigen/Core>
#include <vector>

#include "multibody/system/state_layout.hpp"

/// One instant of a carrier with bodies in body axes, friction moments on an
/// axis in hinge axes: the form of cases and results. Motions use link axes.
namespace multibody {

/// A body at one instant, body axes.
struct BodyInstant {
  Body body;
  JointMode mode = JointMode::turning;
  /// C: body axes to carrier axes. On an axis C and the relative angular
  /// velocity follow from angle and rate, and are ignored here.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d relative_angular_velocity = Eigen::Vector3d::Zero();
  double angle = 0;                                        ///< axis only, rad
  double angle_rate = 0;                                   ///< axis only, rad/s
  Eigen::Vector3d active_force = Eigen::Vector3d::Zero();  ///< N
  Eigen::Vector3d active_moment_com = Eigen::Vector3d::Zero();  ///< N m
  /// On the body; on an axis in hinge axes; N m.
  Eigen::Vector3d friction_moment = Eigen::Vector3d::Zero();
};

/// Carrier and bodies at one instant.
struct Instant {
  Carrier carrier;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< inertial, m/s^2
  /// Carrier axes to inertial axes.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< inertial, m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< inertial, m/s
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d active_force = Eigen::Vector3d::Zero();
  Eigen::Vector3d active_moment_com = Eigen::Vector3d::Zero();
  std::vector<BodyInstant> bodies;
};

/// Accelerations and reaction of a body, body axes.
struct BodyResult {
  Eigen::Vector3d acceleration;          ///< centre of mass, m/s^2
  Eigen::Vector3d angular_acceleration;  ///< absolute, rad/s^2
  /// Derivative in link axes of the relative angular velocity; 0 for a released
  /// body.
  Eigen::Vector3d relative_angular_acceleration;
  double angle_acceleration;              ///< axis only
  Eigen::Vector3d reaction_force;         ///< N
  Eigen::Vector3d reaction_moment;        ///< about the hinge, N m
  Eigen::Vector3d reaction_moment_hinge;  ///< axis only: in hinge axes
};

/// Accelerations and reactions of an instant.
///
/// Accuracy: libcontact/docs/reference/accuracy.md, "Bodies on hinges".
struct InstantResult {
  Eigen::Vector3d acceleration;                ///< carrier axes, m/s^2
  Eigen::Vector3d acceleration_minus_gravity;  ///< V'_0
  Eigen::Vector3d angular_acceleration;        ///< rad/s^2
  std::vector<BodyResult> bodies;
};

/// @throws contact::Error, see System
InstantResult evaluate(const Instant& instant);

/// C = B_0 Rz(angle) B^T of a body on an axis, body axes.
Eigen::Matrix3d axis_rotation(const Body& body, double angle);

}  // namespace multibody
