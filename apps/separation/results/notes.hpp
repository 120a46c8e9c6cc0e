// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "separation/results/run.hpp"

/// Notes on a case and its run, for every program and language.
namespace separation {

/// Sources of the joints' clearances, fits and temperatures, each once.
std::vector<std::string> clearance_notes(const Case& c);
/// Joints outside the range of the theory, once for each reason.
std::vector<std::string> joint_notes(const Case& c);
/// Joints whose largest contact exceeds the range of the theory or the limits
/// of its materials, once for each reason: contact::ContactLimits::notes().
std::vector<std::string> contact_notes(const Case& c,
                                       const Recorder::Memory& memory);
/// The largest ratio of a joint's peak pressure to
/// contact::ContactLimits::peak_pressure(); none without joints.
std::optional<double> pressure_over_limit(const Case& c,
                                          const Recorder::Memory& memory);
/// Unintended results of a run: events that did not occur, forces without
/// effect, contacts beyond the theory, overlaps, a drifting energy, friction
/// that may not be the only one that fits.
std::vector<std::string> run_notes(const Case& c, const Outcome& outcome);

}  // namespace separation
