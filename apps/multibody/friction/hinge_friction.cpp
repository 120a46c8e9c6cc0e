#include "multibody/friction/hinge_friction.hpp"

namespace multibody {

std::vector<contact::JointContact> contacts(const HingeFriction& friction) {
  std::vector<contact::JointContact> all;
  if (const auto* one = std::get_if<JointFriction>(&friction)) {
    all.push_back(one->joint.contact());
  } else if (const auto* group = std::get_if<GroupFriction>(&friction)) {
    for (const contact::JointGroup::Member& joint : group->group.joints()) {
      all.push_back(joint.joint.contact());
    }
  }
  return all;
}

const char* to_string(HingeMode mode) {
  switch (mode) {
    case HingeMode::sliding:
      return "sliding";
    case HingeMode::resting:
      return "resting";
    case HingeMode::locked:
      return "locked";
    case HingeMode::released:
      return "released";
    case HingeMode::latched:
      return "latched";
  }
  return "";
}

}  // namespace multibody
