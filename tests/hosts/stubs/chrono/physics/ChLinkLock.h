// Declarations of our own of what recipes/chrono.cpp uses of Chrono.
#pragma once

namespace chrono {

class ChVector3d {
 public:
  double x() const;
  double y() const;
  double z() const;
};
struct ChWrenchd {
  ChVector3d force, torque;
};
class ChLinkLockRevolute {
 public:
  ChWrenchd GetReaction2() const;
};

}  // namespace chrono
