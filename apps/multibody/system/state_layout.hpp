#pragma once

#include <vector>

#include "multibody/system/hinges/kinds.hpp"

namespace multibody {

/// Mode of a joint.
enum class JointMode {
  turning,   ///< turns, or is about to; given friction moment
  held,      ///< locked or at rest; its moment is a reaction
  released,  ///< there is no joint (any more)
};

/// Layout of the numbers of a state: the carrier's first, then body by body.
///   carrier:            position 3 and velocity 3 of the centre of mass,
///                       inertial axes; quaternion 4, carrier axes to inertial
///                       ones; angular velocity 3, carrier axes
///   ball joint:    quaternion 4 (link axes to carrier axes), relative
///                       angular velocity 3 (link axes)
///   axis:               angle, rate
///   released:           as the carrier, for the body
/// A held joint keeps its numbers.
class StateLayout {
 public:
  static constexpr int position = 0;
  static constexpr int velocity = 3;
  static constexpr int rotation = 6;
  static constexpr int angular_velocity = 10;
  static constexpr int body_size = 13;

  StateLayout() = default;
  /// Numbers of one body.
  static constexpr int link_size(HingeKind kind, JointMode mode) {
    return mode == JointMode::released ? body_size
                                       : hinge_traits(kind).state_size;
  }
  /// One kind and one mode for each body.
  StateLayout(const std::vector<HingeKind>& kinds,
              const std::vector<JointMode>& modes);
  StateLayout(const System& system, const std::vector<JointMode>& modes);
  int size() const { return size_; }
  int offset(int body) const { return offsets_[body]; }

 private:
  std::vector<int> offsets_;
  int size_ = body_size;
};

}  // namespace multibody
