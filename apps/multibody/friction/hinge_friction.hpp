// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "libcontact/joint/group.hpp"
#include "libcontact/joint/joint.hpp"

/// Friction in the hinge of a body.
namespace multibody {

/// Force from which friction is computed.
enum class FrictionEstimate {
  consistent,   ///< R_n, with R = R_n n + R_t: full friction
  traditional,  ///< R in place of R_n, the usual estimate: too much
};

/// A ball alone on a ball body (HingeKind::ball), or a pin on the axis of an
/// axis body (HingeKind::axis). The pin carries the radial force; parts without
/// friction carry the axial force and moments across the axis. A seat that ends
/// confines its ball, only with the consistent estimate.
struct JointFriction {
  contact::Joint joint;
  FrictionEstimate estimate = FrictionEstimate::consistent;
};

/// Several joints on the axis of an axis body (HingeKind::axis); positions
/// along the axis (z of the hinge axes) from the centre of the hinge. The
/// traditional estimate distributes the forces among the joints in the same
/// way, and computes each joint's friction from its whole force.
struct GroupFriction {
  contact::JointGroup group;
  FrictionEstimate estimate = FrictionEstimate::consistent;
};

/// std::monostate: an ideal hinge. It turns freely and never rests.
using HingeFriction =
    std::variant<std::monostate, JointFriction, GroupFriction>;

/// Contacts of its joints, in the order of the group.
std::vector<contact::JointContact> contacts(const HingeFriction& friction);

/// State of a hinge.
enum class HingeMode {
  sliding,   ///< turns, or is about to
  resting,   ///< relative velocity exactly 0, held by friction
  locked,    ///< held by a lock
  released,  ///< there is no hinge (any more)
  latched,   ///< held by a latch
};

/// All modes, in order.
inline constexpr std::array hinge_modes = {
    HingeMode::sliding, HingeMode::resting, HingeMode::locked,
    HingeMode::released, HingeMode::latched};

/// Held by a lock or a latch, not by friction or stops.
constexpr bool is_fixed(HingeMode mode) {
  return mode == HingeMode::locked || mode == HingeMode::latched;
}

/// "sliding", ...
const char* to_string(HingeMode mode);

}  // namespace multibody
