#pragma once

#include <Eigen/Core>
#include <optional>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/joint/spec.hpp"
#include "study/model/model.hpp"

/// What [load] of the study of a joint says.
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
  bool is_tilted = false;
  double tilt = 0;   ///< slope of a pin in the plane of the reaction, rad
  double twist = 0;  ///< slope across it, rad
  std::optional<double> load_at = {};  ///< place of the reaction along a pin, m

  /// The joint under it.
  contact::JointSpec of(const contact::JointSpec& joint) const {
    return without_seat ? joint.without_seat() : joint;
  }
  bool is_of_pin() const { return is_tilted || load_at; }
  Eigen::Vector3d angular_velocity() const { return {0, 0, rate}; }
  /// The reaction turned in its plane with z, away from z, by an angle, rad.
  Eigen::Vector3d swung(double angle) const;
};

/// @throws contact::Error of keys that do not go together, or with the joint
Load read_load(const contact::TomlTable& load,
               const contact::JointGeometry& geometry);

/// The load in the axes of the seat, which it swings in.
contact::DutyCycle swinging(const Load& load,
                            const contact::JointGeometry& geometry);

/// As hinge-joint --tilt or --load-at.
Result run_pin_that_ends(const contact::JointSpec& joint, const Load& load,
                         const Effort& effort);

}  // namespace study
