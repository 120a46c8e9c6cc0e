// SPDX-License-Identifier: MIT
#pragma once

#include <Simbody.h>

#include <string>

#include "hosts/joint_handle.hpp"

namespace contact_hosts::simbody {

/// How friction and the reactions that it causes come to fit.
enum class Fit {
  /// By accelerations repeated until moments are wrong by `tolerance`.
  converged,
  /// Moments under the reactions of the evaluation before: without these
  /// accelerations, an error of the order of the joint's radius over the
  /// distance of the masses, and integrators take shorter steps.
  lagged,
};

struct Options {
  Fit fit = Fit::converged;
  /// Error of the moments over the largest. Not above what the integrator
  /// resolves.
  double tolerance = 1e-8;
  /// A ball below it has come to rest, rad/s. Several times the integrator's
  /// accuracy: with less its last motion may drown in errors of that size, so
  /// that it creeps on in steps of microseconds.
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
/// A sliding hinge has the moments of contact_joint_solve(). A hinge that comes
/// to rest, whose time events find, is locked: its rate is exactly 0, its
/// angles do not change by a bit, until the moment that it holds passes the
/// limit (contact_joint_at_rest()) by 1e-10, of balls 1e-8, which events find
/// too. Reactions are those of Simbody. The axis of a [seat] is in the axes
/// of the body that has it; a load that it does not carry throws an exception.
///
/// Where it ends: one State at a time; mobilizers are locked and unlocked: one
/// that others lock is refused, latch() is for that; in a loop no more hinges
/// may have friction than it has freedoms: a loop that is locked twice has no
/// reactions, and is refused; a Gimbal must stay off its gimbal lock; nothing
/// is known of contacts that open. Constraints, and subsystems of forces that
/// come after `forces`, cost a copy of the State for each evaluation.
class HingeFriction {
 public:
  /// Before system.realizeTopology().
  HingeFriction(SimTK::MultibodySystem& system,
                SimTK::GeneralForceSubsystem& forces, Options options = {});

  /// Friction of a joint file between a body and its parent.
  /// @param body  of a Ball, Gimbal or Pin mobilizer
  /// @throws std::runtime_error for another mobilizer, and if the file is not
  ///         good or of another kind
  void add(const SimTK::MobilizedBody& body, const std::string& file);

  /// At the start: locks hinges without a rate, as far as they hold.
  void settle(SimTK::State& state) const;

  /// Locks a body of add() for good, as a latch does, by an impulse that takes
  /// its rates and keeps the momentum: from a handler of events, for example.
  /// Hinges at rest are ideal in that instant, locked ones hold. There is no
  /// friction in it any more; several latched one after the other end as all at
  /// once.
  /// @return the impulse on the body about its mobilizer, Ground, N m s
  SimTK::Vec3 latch(SimTK::State& state,
                    const SimTK::MobilizedBody& body) const;

  /// Last solution of the i-th hinge added, while it slides: of reactions that
  /// were wrong by less than a hundred times what moments are now. In Ground,
  /// with a [seat] in the axes of the body that has it.
  const contact_solution& hinge(int i) const;
  /// Accelerations that friction asked for.
  long evaluations() const;
  /// M_t . Dw of all hinges, W; of a state realized to Dynamics.
  double power(const SimTK::State& state) const;

 private:
  class Friction;
  class Event;
  SimTK::MultibodySystem& system_;
  Friction* friction_;
};

}  // namespace contact_hosts::simbody
