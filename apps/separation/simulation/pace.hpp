// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "separation/simulation/simulation.hpp"

namespace separation {

/// Records of a run's steps: the reasons why they are short.
class Pace {
 public:
  /// Call after every step.
  void note(const Simulation& simulation);
  /// "the last step is 1e-08 s, the shortest 2e-09 s at t = 0.5 s; held by the
  /// hinge of "arm" (3e+04 deg/s); the fastest force is "damper" on "arm"
  /// (4e-07 s)"
  ///
  /// A step is limited by the body with the largest error of its motion or
  /// hinge relative to the tolerances (unknown for rk4). The time of a force is
  /// the time in which the force alone would change the motion of its body:
  /// sqrt(J/|M|) to turn it by 1 rad, and for forces that depend on the body's
  /// velocities and position m/|dF/dv|, J/|dM/dw|, sqrt(m/|dF/dx|),
  /// sqrt(J/|dM/dr|).
  std::string text(const Simulation& simulation) const;

 private:
  double shortest_ = History::not_yet;
  double shortest_time_ = 0;
};

}  // namespace separation
