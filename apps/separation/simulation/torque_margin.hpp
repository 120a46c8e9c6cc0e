#pragma once

#include <limits>
#include <map>
#include <mutex>

#include "separation/case/case.hpp"

namespace separation {

/// The smallest ratio of driving to resisting moment on the way of a hinge.
struct TorqueMargin {
  double ratio = std::numeric_limits<double>::infinity();
  double angle = 0;  ///< where that is, rad
};

/// The torque margin of a body on an axis, quasi-static: every body stands
/// still, the hinge at each angle from MarginPath::from to `to`. Motors and
/// torsion springs of the hinge count from their beginning, whenever that is;
/// of the other forces those that act at 0 s, and gravity. What turns the body
/// on drives it; what turns it back, times other_factor, and the friction of
/// the joints under the reaction of that position, in slow sliding, times
/// friction_factor, resist it. Dampers and inertia have no part in it.
///
/// Accuracy (separation/torque_margin_test.cpp): ratios to 1e-9, also between
/// the rows of tables and where the smallest is inside.
/// @param body  with a margin (Hinge::margin)
/// @throws contact::Error where the joints have no friction moment
TorqueMargin torque_margin(const Case& c, int body, FrictionChoice friction);

/// Those of a run, each computed when it is first asked for. Threads may ask.
class TorqueMargins {
 public:
  TorqueMargin of(const Case& c, int body, FrictionChoice friction);

 private:
  std::mutex mutex_;
  std::map<int, TorqueMargin> known_;  // of bodies
};

}  // namespace separation
