// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "libcontact/play/force_law.hpp"
#include "libcontact/play/hunt_crossley.hpp"

namespace contact {

/// One touch of a joint with play, from first touch to separation, without
/// forces other than the contact's.
struct Impact {
  double restitution;       ///< e
  double penetration;       ///< the largest, m
  double elastic_force;     ///< F there, N
  double peak_force;        ///< largest F (1 + a v), N: earlier
  double half_angle;        ///< at the largest penetration, rad
  double peak_pressure;     ///< largest of the impact, Pa: p (1 + a v)
  double compression_time;  ///< from touch to the largest penetration, s
  double restitution_time;  ///< from there to parting, s

  double duration() const { return compression_time + restitution_time; }
};

/// Impacts of one joint: docs/how-to/play.md.
///
/// Accuracy: penetration and force within 1e-10 of independent solutions
/// (play/impact_test.cpp), times within 1e-9 of an integrated motion
/// (play/motion_test.cpp).
class JointImpact {
 public:
  /// @throws Error as ForceLaw does.
  explicit JointImpact(const JointSpec& joint);

  const ForceLaw& force_law() const { return law_; }

  /// NaN where the energy exceeds the range of the force law, which notes()
  /// reports.
  /// @param mass   kg, > 0: of the two bodies m1 m2/(m1 + m2)
  /// @param speed  of approach at touch, m/s, > 0
  /// @throws Error if a number is out of range.
  Impact operator()(const HuntCrossley& damping, double mass,
                    double speed) const;

  /// Notes where an impact leaves the model, one sentence each: a peak pressure
  /// above the limit of the materials, a penetration beyond the force law, a
  /// duration below 10 times the travel of waves through the joint.
  /// @param density  of the bodies, kg/m^3; 0 if it is not known, which leaves
  ///                 out the waves
  std::vector<std::string> notes(const Impact& impact, double density) const;

 private:
  double time(const HuntCrossley& damping, double mass, double penetration,
              bool inwards) const;

  JointSpec joint_;
  ForceLaw law_;
  std::shared_ptr<const PressureLaw> pressure_;
};

}  // namespace contact
