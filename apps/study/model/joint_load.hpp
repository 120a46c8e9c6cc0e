#pragma once

#include <Eigen/Core>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/files/toml_reader.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/joint.hpp"

/// The table [load] of the study of a joint.
namespace study {

/// A reaction on a body that turns about z.
struct Load {
  Eigen::Vector3d reaction;  ///< N
  double rate;               ///< rad/s
  bool without_seat = false;
  contact::LoadDirection direction;
  /// Swing of the reaction to both sides in its plane with z, rad; 0: it
  /// stands still.
  double swing = 0;
  /// How a pin is tilted, loaded off its middle or slides; the axis is z.
  contact::Placement placement;
  bool ends_pin = false;  ///< one is given

  Eigen::Vector3d angular_velocity() const { return {0, 0, rate}; }
  /// Refers to the load.
  contact::Joint::Slip slip() const& {
    return {.reaction = reaction,
            .angular_velocity = angular_velocity(),
            .axis = Eigen::Vector3d::UnitZ(),
            .placement = ends_pin ? &placement : nullptr};
  }
  /// The reaction turned in its plane with z, away from z, by an angle, rad.
  Eigen::Vector3d swung(double angle) const;
};

/// @throws contact::Error if keys do not fit each other or the joint
Load read_load(const contact::TomlTable& load,
               const contact::JointGeometry& geometry);

/// The cycle of a load that swings, in the axes of the seat.
contact::DutyCycle swinging(const Load& load,
                            const contact::JointGeometry& geometry);

}  // namespace study
