#pragma once

#include "multibody/constants.hpp"
#include "multibody/loading.hpp"

namespace multibody {

/// A body of its own: Euler's equations, load axes.
template <class T, class P>
class FreeLoad {
 public:
  explicit FreeLoad(const FreeConstants<P>& constants) : k_(constants) {}

  /// @param w  absolute angular velocity, load axes
  void set_motion(const Vec3<T>& w, const LoadForces<T>& forces) {
    acceleration_ =
        k_.inverse_inertia * (forces.moment - cross(w, k_.inertia * w));
  }
  const Vec3<T>& angular_acceleration() const { return acceleration_; }

 private:
  FreeConstants<P> k_;
  Vec3<T> acceleration_;
};

}  // namespace multibody
