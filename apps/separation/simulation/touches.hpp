#pragma once

#include <vector>

#include "multibody/motion/motion.hpp"
#include "separation/clearance/clearance.hpp"
#include "separation/simulation/case_forces.hpp"

namespace separation {

/// Distances of some pairs of a case's bodies.
Clearance clearance_of(const Case& c, const std::vector<WatchedPair>& pairs);

/// Events of a case that come when bodies come near each other.
class Touches {
 public:
  /// @param c  has to outlive this object
  explicit Touches(const Case& c);

  /// The pairs of an event for one of its bodies (from 0): its own, or all if
  /// it has none.
  std::vector<int> pairs_of(int event, int body) const;
  /// Rises above 0 when a pair of an event comes as near as the event says.
  /// Before they are watched they count as near, and after that as far: neither
  /// is a crossing.
  double condition(int event, int pair, const History& history,
                   const multibody::MotionSample& sample) const;
  /// A bound of its rate, m/s.
  double speed(int event, int pair,
               const multibody::MotionSample& sample) const;
  /// How fast the two approach each other, m/s.
  double approach(int event, int pair,
                  const multibody::MotionSample& sample) const;

 private:
  const Case& case_;
  std::vector<Clearance> of_events_;
};

}  // namespace separation
