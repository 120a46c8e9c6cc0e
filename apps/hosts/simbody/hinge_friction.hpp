// SPDX-License-Identifier: MIT
#pragma once

#include <Simbody.h>

#include <string>

#include "hosts/joint_handle.hpp"

namespace contact_hosts::simbody {

/// How friction moments and the reactions that they cause are made consistent.
enum class Fit {
  /// Repeats the accelerations until the moments' error is below `tolerance`.
  converged,
  /// Uses the reactions of the previous evaluation. It needs no more
  /// accelerations, but has an error of the order of joint radius over distance
  /// of the masses, and integrators take shorter steps.
  lagged,
};

struct Options {
  Fit fit = Fit::converged;
  /// Error of the moments relative to the largest one. Must not exceed what the
  /// integrator resolves.
  double tolerance = 1e-8;
  /// A ball slower than this has come to rest, rad/s. Choose several times the
  /// integrator's accuracy: with a smaller value the last motion can drown in
  /// errors of that size, and the ball creeps on in steps of microseconds.
  double stop_speed = 1e-7;
};

/// Friction of libcontact in Ball, Gimbal and Pin mobilizers of a Simbody
/// system.
///
///     HingeFriction friction(system, forces);
///     friction.add(hip, "hip.toml");
///     State state = system.realizeTopology();
///     ... angles and rates ...
///     friction.settle(state);  // hinges without a rate that hold
///
/// A sliding hinge has the moments of contact_joint_solve(). When a hinge comes
/// to rest, which an event finds, it is locked: its rate is exactly 0 and its
/// angles stay bit-identical. It is released by another event when the held
/// moment exceeds the limit (contact_joint_at_rest()) by 1e-10, for balls by
/// 1e-8. Reactions are computed by Simbody. The axis of a [seat] is in the axes
/// of the body with the seat; a load that the seat does not carry throws an
/// exception.
///
/// Limits: one State at a time. Mobilizers are locked and unlocked: one that
/// others lock is rejected, latch() locks it instead. In a loop at most as many
/// hinges may have friction as it has degrees of freedom; a loop locked twice
/// has indeterminate reactions and is rejected. A Gimbal must stay away from
/// gimbal lock. Opening contacts are not detected. Constraints, and force
/// subsystems added after `forces`, cost a copy of the State for each
/// evaluation.
class HingeFriction {
 public:
  /// Call before system.realizeTopology().
  HingeFriction(SimTK::MultibodySystem& system,
                SimTK::GeneralForceSubsystem& forces, Options options = {});

  /// Adds the friction of a joint file between a body and its parent.
  /// @param body  of a Ball, Gimbal or Pin mobilizer
  /// @throws std::runtime_error for another mobilizer, and if the file is wrong
  ///   or describes another kind
  void add(const SimTK::MobilizedBody& body, const std::string& file);

  /// Call at the start: locks hinges with zero rate that friction holds.
  void settle(SimTK::State& state) const;

  /// Locks a body of add() for good, as a latch does, for example from an event
  /// handler. The impulse removes its rates and keeps the momentum. Hinges at
  /// rest are ideal in that instant, locked hinges hold. The hinge has no
  /// friction any more. Hinges latched one after the other end as if latched
  /// together.
  /// @return the impulse on the body about its mobilizer, Ground, N m s
  SimTK::Vec3 latch(SimTK::State& state,
                    const SimTK::MobilizedBody& body) const;

  /// Last solution of the i-th hinge added, while it slides. Its reactions are
  /// accurate to a hundred times the error of the moments. In Ground; with a
  /// [seat] in the axes of the body with the seat.
  const contact_solution& hinge(int i) const;
  /// Number of accelerations computed for friction.
  long evaluations() const;
  /// M_t . Dw summed over all hinges, W; the state must be realized to
  /// Dynamics.
  double power(const SimTK::State& state) const;

 private:
  class Friction;
  class Event;
  SimTK::MultibodySystem& system_;
  Friction* friction_;
};

}  // namespace contact_hosts::simbody
