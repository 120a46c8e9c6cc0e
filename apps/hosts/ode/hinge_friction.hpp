// SPDX-License-Identifier: MIT
#pragma once

#include <ode/ode.h>

#include <string>
#include <vector>

#include "hosts/joint_handle.hpp"

namespace contact_hosts::ode {

/// Friction of libcontact in hinges and balls of an ODE world: ODE's solver
/// (dWorldStep) holds, libcontact says how much.
///
///     HingeFriction friction(world);
///     friction.add(hip, "hip.toml");
///     while (...) { friction.update(dt); dWorldStep(world, dt); }
///
/// Dry friction does not depend on |Dw|: a motor of speed 0 with the largest
/// moment |M_t| is this friction. A hinge uses its own motor; a ball gets an
/// angular motor along M_t, and, where a step would stop it, along three axes:
/// a ball at rest holds up to sqrt(3) |M_t| between them. Reactions are those
/// of the step before; in the first step there are none, and no friction.
/// Hinges rest to rounding, not exactly. Viscous friction, which depends on
/// |Dw|, is refused. The axis of a [seat] is in the axes of the dBody that
/// has it; a load that the seat does not carry makes update() throw.
class HingeFriction {
 public:
  explicit HingeFriction(dWorldID world) : world_(world) {}

  /// Friction of a joint file in a hinge or ball, whose first body is the
  /// joint's body.
  /// @throws std::runtime_error for another joint, and if the file is not good,
  ///         of another kind or viscous
  void add(dJointID joint, const std::string& file);

  /// Before each dWorldStep().
  /// @param step  that will be made, s
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
