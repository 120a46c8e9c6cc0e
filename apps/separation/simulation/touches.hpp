#pragma once

#include <cstddef>
#include <span>
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

  /// Rises above 0 when the bodies of an event, of one of its bodies (from 0),
  /// come so near as it says. Before they are watched they count as near, and
  /// after that as far: neither is a crossing.
  double condition(int event, int body, const History& history,
                   const multibody::MotionSample& sample) const;
  /// A bound of its rate, m/s.
  double speed(int event, int body,
               const multibody::MotionSample& sample) const;
  /// How fast they approach each other when the event comes, m/s.
  double approach(int event, int body, const History& history,
                  const multibody::Motion& motion) const;

 private:
  // Of the pairs of an event those that it is about for a body.
  template <class Visit>
  void for_pairs(int event, int body, const Visit& visit) const;

  const Case& case_;
  std::vector<Clearance> of_events_;
};

}  // namespace separation
