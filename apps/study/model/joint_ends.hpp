#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "libcontact/joint/spec.hpp"
#include "libcontact/seat/joint.hpp"
#include "study/model/model.hpp"

/// Joints whose contact ends: what [load] of a study says of them, and their
/// numbers, named as hinge-joint's columns.
namespace study {

/// Keys of [load] beside the reaction.
struct EndedLoad {
  bool in_seat = false;  ///< the contact of a ball is confined to its [seat]
  /// Swing of the reaction to both sides of its angle, rad; 0: it stands still.
  double swing = 0;
  bool is_tilted = false;
  double tilt = 0;   ///< slope of a pin in the plane of the reaction, rad
  double twist = 0;  ///< slope across it, rad
  std::optional<double> load_at = {};  ///< place of the reaction along a pin, m

  bool is_pin() const { return is_tilted || load_at; }
};

/// @throws contact::Error of keys that do not go together, or with the joint
EndedLoad read_ended_load(const contact::TomlTable& load,
                          const contact::JointGeometry& geometry);

/// A reaction on a body that turns about z, and the angle between them.
struct Turning {
  double reaction;  ///< N
  double beta;      ///< rad
  double rate;      ///< rad/s

  Eigen::Vector3d force() const { return force_at(beta); }
  Eigen::Vector3d force_at(double angle) const {
    return reaction * Eigen::Vector3d(std::sin(angle), 0, std::cos(angle));
  }
  Eigen::Vector3d angular_velocity() const { return {0, 0, rate}; }
};

/// As hinge-joint --in-seat; with a swing the worst of a cycle too, as
/// hinge-duty --in-seat has it.
/// @param seat  of the joint
Result run_in_seat(const contact::JointSpec& joint,
                   const contact::SeatJoint& seat, const EndedLoad& load,
                   const Turning& turning, const Effort& effort);

/// As hinge-joint --tilt or --load-at.
Result run_pin_that_ends(const contact::JointSpec& joint, const EndedLoad& load,
                         const Turning& turning, const Effort& effort);

}  // namespace study
