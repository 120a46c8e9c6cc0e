#pragma once

#include <variant>

#include "cli/joint_options.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"

namespace hinge_pressure {

/// How far a load presses a ball or pin into the outer body: the exact
/// solution in SI units. Each half-angle is a solution of its own
/// (docs/speed.md, "half-angle at a load" is some ten of them).
class JointApproach {
 public:
  /// @param joint  has a geometry
  explicit JointApproach(const cli::Joint& joint);

  /// From first touch of the unloaded bodies.
  struct Value {
    double approach;   ///< m
    double stiffness;  ///< d load/d approach, N/m; of a pin (N/m)/m
  };
  /// NaN where there is none: without load, loaded through the back, and for a
  /// pin in an infinite hole, where it grows with the distance without end.
  Value operator()(double half_angle) const;

 private:
  std::variant<contact::BallContact, contact::PinContact> contact_;
  double length_unit_;     // the clearance, m
  double stiffness_unit_;  // rho E, N/m; E of a pin, Pa
};

}  // namespace hinge_pressure
