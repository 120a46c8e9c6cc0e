#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "programs/duty/body_wear.hpp"

namespace hinge_duty {

/// A joint of a run and its duty cycle.
struct JointDuty {
  const cli::Joint& joint;
  contact::JointSpec spec;  ///< spec of the cycle's joint
  contact::JointCycle cycle;
  bool ends = false;                              ///< true: solved by slices
  std::vector<BodyWear> wear = {};                ///< both bodies, or empty
  std::vector<contact::WearIn::State> worn = {};  ///< with --cycles
  contact::WornSeat worn_seat = {};               ///< after the cycles
  /// k as given, mm^3/(N m).
  std::optional<double> wear_seat = {};
  std::optional<double> wear_inner = {};

  std::optional<double> wear_coefficient(contact::JointBody body) const {
    return body == joint.spec.geometry.inner_body() ? wear_inner : wear_seat;
  }
};

/// True if one of the joints is in a seat that ends.
inline bool have_seat(const std::vector<JointDuty>& duties) {
  return std::ranges::any_of(duties, [](const JointDuty& duty) {
    return !duty.joint.is_pin() && !duty.cycle.joint().is_endless();
  });
}
/// True if one of the joints has a finite-length pin.
inline bool have_ends(const std::vector<JointDuty>& duties) {
  return std::ranges::any_of(duties, &JointDuty::ends);
}

}  // namespace hinge_duty
