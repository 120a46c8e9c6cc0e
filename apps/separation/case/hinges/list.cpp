#include <algorithm>
#include <numbers>

#include "separation/case/hinges/hinge_type.hpp"

namespace separation {

// Each has a file of its own beside this one.
HingeType ball_hinge();
HingeType axis_hinge();

const std::vector<HingeType>& hinge_types() {
  static const auto& types =
      *new std::vector<HingeType>{ball_hinge(), axis_hinge()};
  return types;
}

const HingeType& hinge_type(const Hinge& hinge) {
  return *std::ranges::find(hinge_types(), hinge.kind, &HingeType::kind);
}

void check_angles(const contact::TomlTable& table, const Hinge& hinge,
                  double low, double high, const std::string& where) {
  if (hinge_type(hinge).counts_turns) return;
  // 180 deg but for the rounding of units.
  constexpr double most = std::numbers::pi * (1 + 1e-15);
  if (low >= 0 && high <= most) return;
  table.must_be("angle", "0 deg to 180 deg on " + where +
                             ": it is the angle between two directions");
}

bool is_ball(const HingeJoint& joint) {
  return joint.joint.geometry.kind() == contact::JointKind::ball;
}

}  // namespace separation
