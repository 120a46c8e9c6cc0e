#pragma once

#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "separation/case/case.hpp"

namespace separation {

/// The smallest ratio of driving to resisting moment on the path of a hinge.
struct TorqueMargin {
  double ratio = std::numeric_limits<double>::infinity();
  // At the smallest ratio:
  double angle = 0;  ///< rad
  /// Moments with their factors, N m.
  double driving = 0, friction = 0, other = 0;
  bool lacks_load = false;  ///< joints with friction carry none
};

/// The quasi-static torque margin of a body on an axis: all bodies are at rest,
/// with the hinge at each angle from MarginPath::from to `to`. Motors and
/// torsion springs of the hinge have their initial values, whenever they begin;
/// other forces count if they act at 0 s, and gravity counts. Driving moments
/// turn the body towards `to`, those of torsion springs of the hinge times
/// spring_factor. Resisting moments are the moments that turn it back, times
/// other_factor, and the friction of the joints under the reaction of the
/// position, in slow sliding, times friction_factor. Dampers and inertia are
/// ignored.
///
/// Joints without load have no friction: in orbit, at rest, joints with
/// clearance do not resist. margin_notes() says so.
///
/// Accuracy (separation/torque_margin_test.cpp): ratios to 1e-9, also between
/// the rows of tables and for a minimum inside the path.
/// @param body  with a margin (Hinge::margin)
/// @throws contact::Error if the joints have no friction moment
TorqueMargin torque_margin(const Case& c, int body, FrictionChoice friction);

/// Warnings of a margin, which follow "torque_margin of BODY": one below
/// MarginPath::required, no resisting moment, joints whose friction does not
/// count for want of a load.
std::vector<std::string> margin_notes(const MarginPath& path,
                                      const TorqueMargin& margin);

/// Torque margins of a run, computed on first use. Safe from several threads.
class TorqueMargins {
 public:
  TorqueMargin of(const Case& c, int body, FrictionChoice friction);

 private:
  std::mutex mutex_;
  std::map<int, TorqueMargin> known_;  // body to margin
};

}  // namespace separation
