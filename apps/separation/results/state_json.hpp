#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "separation/results/run.hpp"

// Conversion of a run's state to JSON and back.
template <>
struct nlohmann::adl_serializer<Eigen::Vector3d> {
  static void to_json(json& j, const Eigen::Vector3d& v) {
    j = {v.x(), v.y(), v.z()};
  }
  static void from_json(const json& j, Eigen::Vector3d& v) {
    if (j.size() != 3) {
      throw contact::Error(contact::detail::must_be(
          "a vector of " + std::to_string(j.size()) + " numbers", "of 3"));
    }
    v = Eigen::Vector3d(j.at(0), j.at(1), j.at(2));
  }
};

namespace multibody {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MotionState, time, numbers, modes,
                                   directions, friction, straight_from, paces,
                                   hinge_angles, settle_times, rests_on, losses,
                                   step)
}  // namespace multibody

namespace separation {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(History, events, spent, touches, inputs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SimulationState, motion, history)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(JointPeaks, reaction, reaction_time,
                                   pressure, hidden, half_angle, moment,
                                   lower_gap, upper_gap, rim_time)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BodyRecord::Release, time, angle, rate,
                                   rates, velocity)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BodyRecord, peak_reaction,
                                   peak_reaction_time, peak_lock,
                                   peak_lock_time, work, rest_time, peak_stop,
                                   peak_stop_time, impacts, stop_impulses,
                                   largest_impulse, stop_loss, rest_on_stop,
                                   on_stop, peak_latch, peak_latch_time,
                                   latch_impulse, latch_loss, joints, release)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TipOffRecord, time, rates, velocity,
                                   attitude, across, mass)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Note, time, body, what, rate, impulse, loss,
                                   approach)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PairRecord, smallest, time, overlap_from,
                                   overlap_to)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ForceRecord, on, acted, fault, fault_time)
// Without rows and notes, which have a separate file.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Recorder::Memory, bodies, pairs, forces,
                                   tip_offs, modes, last_time, first_balance,
                                   largest_drift, largest_energy, begun)

/// CBOR between the format's name and a check sum. The name occurs twice, as
/// the first line and in the JSON, to distinguish damaged data from other data.
std::string packed(nlohmann::json j);
/// @param source  name of the bytes in messages
/// @throws contact::Error if they are other data, damaged, or of another
///   version
nlohmann::json unpacked(std::string_view bytes, const std::string& source);

/// @throws contact::Error if it is not the "identity" of j
void check_identity(const nlohmann::json& j, const std::string& identity,
                    const std::string& source);
/// Rejects data that are no state of a run.
[[noreturn]] void refuse_stranger(const std::string& source);

}  // namespace separation
