#pragma once

#include <string>

#include "separation/simulation/simulation.hpp"

namespace separation {

/// Records of a run's steps: the reasons why they are short.
class Pace {
 public:
  /// After every step.
  void note(const Simulation& simulation);
  /// "the last step is 1e-08 s, the shortest 2e-09 s at t = 0.5 s; held by the
  /// hinge of "arm" (3e+04 deg/s); the fastest force is "damper" on "arm"
  /// (4e-07 s)"
  ///
  /// A step is held by the body whose motion, or whose hinge's, has the
  /// largest error against the tolerances (not known of rk4). The time of a
  /// force is about that in which it, alone, changes the motion of its body:
  /// sqrt(J/|M|) to turn it by 1 rad, and where it depends on the body's
  /// velocities and place m/|dF/dv|, J/|dM/dw|, sqrt(m/|dF/dx|),
  /// sqrt(J/|dM/dr|).
  std::string text(const Simulation& simulation) const;

 private:
  double shortest_ = History::not_yet;
  double shortest_time_ = 0;
};

}  // namespace separation
