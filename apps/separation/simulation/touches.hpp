#pragma once

#include <vector>

#include "multibody/motion/motion.hpp"
#include "separation/clearance/clearance.hpp"
#include "separation/simulation/case_forces.hpp"

namespace separation {

/// Distances of some pairs of a case's bodies.
Clearance clearance_of(const Case& c, const std::vector<WatchedPair>& pairs);

/// Events of a case that occur when bodies come near each other.
class Touches {
 public:
  /// @param c  must outlive this object
  explicit Touches(const Case& c);

  /// Pairs that an event watches for one of its bodies (from 0): its own pairs,
  /// or all pairs.
  std::vector<int> pairs_of(int event, int body) const;
  /// Rises above 0 when a pair comes as near as the distance of the event. It
  /// counts as near before the time window and as far after it, so that neither
  /// end of the window is a crossing.
  double condition(int event, int pair, const History& history,
                   const multibody::MotionSample& sample) const;
  /// A bound of the condition's rate, m/s.
  double speed(int event, int pair,
               const multibody::MotionSample& sample) const;
  /// Speed at which the two bodies approach each other, m/s.
  double approach(int event, int pair,
                  const multibody::MotionSample& sample) const;

 private:
  const Case& case_;
  std::vector<Clearance> of_events_;
};

}  // namespace separation
