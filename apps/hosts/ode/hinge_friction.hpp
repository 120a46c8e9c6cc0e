// SPDX-License-Identifier: MIT
#pragma once

#include <ode/ode.h>

#include <string>
#include <vector>

#include "hosts/joint_handle.hpp"

namespace contact_hosts::ode {

/// Friction of libcontact in hinges and balls of an ODE world. libcontact
/// computes the largest friction moment; ODE's solver (dWorldStep) applies it.
///
///     HingeFriction friction(world);
///     friction.add(hip, "hip.toml");
///     while (...) { friction.update(dt); dWorldStep(world, dt); }
///
/// Dry friction does not depend on |Dw|, so a motor of speed 0 with the largest
/// moment |M_t| represents it exactly. A hinge uses its own motor. A ball gets
/// an angular motor along M_t and, where a step would stop it, along three
/// axes; at rest it therefore holds up to sqrt(3) |M_t| in directions between
/// them. Reactions come from the previous step; the first step has neither
/// reactions nor friction. Hinges come to rest to rounding, not exactly.
/// Viscous friction, which depends on |Dw|, is rejected. The axis of a [seat]
/// is in the axes of the dBody with the seat; update() throws for a load that
/// the seat does not carry.
class HingeFriction {
 public:
  explicit HingeFriction(dWorldID world) : world_(world) {}

  /// Adds the friction of a joint file to a hinge or ball whose first body is
  /// the joint's body.
  /// @throws std::runtime_error for another kind of joint, and if the file is
  ///   wrong, describes another kind, or has viscous friction
  void add(dJointID joint, const std::string& file);

  /// Call before each dWorldStep().
  /// @param step  length of this step, s
  void update(double step);

  /// |M_t| of the i-th hinge added, N m.
  double limit(std::size_t i) const { return hinges_.at(i).limit; }

 private:
  struct Hinge {
    dJointID joint;
    dJointID motor;  // for a ball
    FrictionMoment contact;
    dJointFeedback* feedback;
    double limit;
  };
  dWorldID world_;
  std::vector<Hinge> hinges_;
  std::vector<std::unique_ptr<dJointFeedback>> feedback_;
};

}  // namespace contact_hosts::ode
