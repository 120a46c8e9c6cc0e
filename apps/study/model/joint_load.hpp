#pragma once

#include <Eigen/Core>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/files/toml_reader.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/joint.hpp"

/// The table [load] of the study of a joint.
namespace study {

/// A reaction on a body that rotates about z.
struct Load {
  Eigen::Vector3d reaction;  ///< N
  double rate;               ///< rad/s
  bool without_seat = false;
  contact::LoadDirection direction;
  /// Amplitude of the reaction's swing in its plane with z, rad; 0: constant
  /// direction.
  double swing = 0;
  /// Tilt of a pin, its load's place, or its sliding; the axis is z.
  contact::Placement placement;
  bool ends_pin = false;  ///< true if a placement is given

  Eigen::Vector3d angular_velocity() const { return {0, 0, rate}; }
  /// Refers to this load, which must outlive the slip.
  contact::Joint::Slip slip() const& {
    return {.reaction = reaction,
            .angular_velocity = angular_velocity(),
            .axis = Eigen::Vector3d::UnitZ(),
            .placement = ends_pin ? &placement : nullptr};
  }
  /// The reaction, rotated away from z in its plane with z by an angle, rad.
  Eigen::Vector3d swung(double angle) const;
};

/// @throws contact::Error if keys conflict with each other or with the joint
Load read_load(const contact::TomlTable& load,
               const contact::JointGeometry& geometry);

/// The cycle of a swinging load, in the axes of the seat.
contact::DutyCycle swinging(const Load& load,
                            const contact::JointGeometry& geometry);

}  // namespace study
