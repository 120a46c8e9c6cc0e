#include "multibody/friction/hinge_friction.hpp"

namespace multibody {

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
  }
  return "";
}

}  // namespace multibody
