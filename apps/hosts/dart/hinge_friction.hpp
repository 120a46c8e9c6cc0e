// SPDX-License-Identifier: MIT
#pragma once

#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <string>
#include <vector>

#include "hosts/joint_handle.hpp"

namespace contact_hosts::dart {

/// Friction of libcontact in revolute and ball joints of DART: DART's solver
/// (World::step()) holds, libcontact says how much.
///
///     HingeFriction friction;
///     friction.add(hip, "hip.toml");
///     while (...) { friction.update(); world->step(); }
///
/// Dry friction does not depend on |Dw|: the Coulomb friction of a revolute
/// joint, set anew to |M_t| at each step, is this friction. A ball, for which
/// DART has one for each axis only, gets M_t as a force while it slides, and
/// three limits |M_t| where a step would stop it: at rest it holds up to
/// sqrt(3) |M_t| between the axes. Reactions are those of the step before; in
/// the first step there are none, and no friction. Hinges rest to rounding, not
/// exactly. Viscous friction, which depends on |Dw|, is refused. The axis
/// of a [seat] is in the axes of the BodyNode that has it; a load that the seat
/// does not carry makes update() throw.
class HingeFriction {
 public:
  /// Friction of a joint file in a joint.
  /// @throws std::runtime_error for another joint, and if the file is not good,
  ///         of another kind or viscous
  void add(::dart::dynamics::Joint* joint, const std::string& file);

  /// Before each World::step().
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
