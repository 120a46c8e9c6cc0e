// SPDX-License-Identifier: MIT
#pragma once

#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <string>
#include <vector>

#include "hosts/joint_handle.hpp"

namespace contact_hosts::dart {

/// Friction of libcontact in revolute and ball joints of DART. libcontact
/// computes the largest friction moment; DART's solver (World::step()) applies
/// it.
///
///     HingeFriction friction;
///     friction.add(hip, "hip.toml");
///     while (...) { friction.update(); world->step(); }
///
/// Dry friction does not depend on |Dw|, so the Coulomb friction of a revolute
/// joint, set to |M_t| before each step, represents it exactly. For a ball DART
/// has only one limit per axis. A sliding ball therefore gets M_t as an
/// external moment. Where a step would stop it, it gets the limit |M_t| on each
/// of three axes, so at rest it holds up to sqrt(3) |M_t| in directions between
/// the axes. Reactions come from the previous step; the first step has neither
/// reactions nor friction. Hinges come to rest to rounding, not exactly.
/// Viscous friction, which depends on |Dw|, is rejected. The axis of a [seat]
/// is in the axes of the BodyNode with the seat; update() throws for a load
/// that the seat does not carry.
class HingeFriction {
 public:
  /// Adds the friction of a joint file to a joint.
  /// @throws std::runtime_error for another kind of joint, and if the file is
  ///   wrong, describes another kind, or has viscous friction
  void add(::dart::dynamics::Joint* joint, const std::string& file);

  /// Call before each World::step().
  void update();

  /// |M_t| of the i-th hinge added, N m.
  double limit(std::size_t i) const { return hinges_.at(i).limit; }

 private:
  struct Hinge {
    ::dart::dynamics::Joint* joint;
    FrictionMoment contact;
    double limit;
  };
  static void rub(Hinge& h, const Eigen::Vector3d& moment);
  static Eigen::Matrix<double, 3, 3, Eigen::RowMajor> from_seat(const Hinge& h);
  std::vector<Hinge> hinges_;
};

}  // namespace contact_hosts::dart
