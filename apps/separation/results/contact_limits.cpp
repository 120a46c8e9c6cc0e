#include "separation/results/contact_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "libcontact/pressure/validity.hpp"

namespace separation {
namespace {

// Calls what(joint, limits, largest contact) for all joints.
template <class Function>
void for_each_joint(const Case& c, const Recorder::Memory& memory,
                    const Function& what) {
  for (std::size_t b = 0; b < c.bodies.size(); ++b) {
    const auto& joints = c.bodies[b].hinge.joints;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const JointPeaks& peaks = memory.bodies[b].joints[j];
      const contact::JointContact& contact = joints[j].contact;
      what(joints[j],
           contact::ContactLimits(contact.half_angle_law(), contact.pair()),
           contact::LargestContact{peaks.half_angle, peaks.pressure});
    }
  }
}

}  // namespace

std::vector<std::string> contact_notes(const Case& c,
                                       const Recorder::Memory& memory) {
  std::set<std::string> notes;
  for_each_joint(
      c, memory,
      [&](const auto& joint, const auto& limits, const auto& largest) {
        for (const std::string& note : limits.notes(largest)) {
          notes.insert(fmt::format("joint {}: {}", joint.joint.name, note));
        }
      });
  return {notes.begin(), notes.end()};
}

std::optional<double> pressure_over_limit(const Case& c,
                                          const Recorder::Memory& memory) {
  std::optional<double> most;
  for_each_joint(
      c, memory,
      [&](const auto& /*joint*/, const auto& limits, const auto& largest) {
        most = std::max(most.value_or(0),
                        largest.peak_pressure / limits.peak_pressure());
      });
  return most;
}

}  // namespace separation
