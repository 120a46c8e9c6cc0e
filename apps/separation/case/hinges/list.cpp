#include <algorithm>
#include <numbers>
#include <string>

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

std::string parent_key(const contact::TomlTable& hinge, std::string_view end) {
  const std::string of_parent = "parent_" + std::string(end);
  const std::string of_carrier = "carrier_" + std::string(end);
  if (!hinge.has("on")) {
    if (hinge.has(of_parent)) hinge.needs(of_parent, "on");
    return of_carrier;
  }
  if (hinge.has(of_carrier)) {
    hinge.must_be(of_carrier, of_parent + " beside on");
  }
  return of_parent;
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
