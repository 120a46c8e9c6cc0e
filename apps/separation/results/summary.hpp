// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "separation/results/run.hpp"

namespace separation {

/// An event and the bodies for which it has not occurred.
struct Missed {
  std::string event;
  std::vector<std::string> bodies;
};
std::vector<Missed> missed_events(const Case& c, const Outcome& outcome);

/// Summary of a run as JSON (keys:
/// libcontact/docs/reference/separation_output.md). Angles in degrees, all else
/// in SI units; infinity is the text "inf" or "-inf".
nlohmann::ordered_json summary(const Case& c, const Outcome& outcome);

}  // namespace separation
