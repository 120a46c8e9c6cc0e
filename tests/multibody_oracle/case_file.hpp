#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "multibody_support/instant.hpp"

/// Cases in the JSON formats of data/reference/multibody and, for bodies on
/// bodies, data/reference/trees (see their README.md): one instant of a carrier
/// with bodies.
namespace multibody {

/// An instant read from a file.
struct CaseInstant : Instant {
  // NOLINTNEXTLINE: any instant, in the format of stars
  CaseInstant(Instant instant = {}) : Instant(std::move(instant)) {}
  bool is_tree = false;  ///< the file has the format of trees
};

/// Reads a case; its "schema" names the format. In a star the file's "kind" is
/// "spherical" or "axes" for all bodies, or "mixed": then each body has its own
/// "kind", one of "spherical", "axis" and "free". A body with "held": true does
/// not turn in its joint. Omitted forces and friction moments are zero; gravity
/// is required. Velocities and rotations given twice must agree to 1e-6.
/// Unknown keys are rejected, except inside "expected", which is not read.
/// @throws contact::Error "FILE: fault"
CaseInstant read_case(const std::string& file);

/// As above, from parsed JSON.
/// @throws contact::Error; nlohmann::json::exception if a key is missing or its
///   value has another type
CaseInstant instant_from_json(const nlohmann::json& json);

/// The result with the keys and in the frames of the format's "expected".
nlohmann::ordered_json to_json(const CaseInstant& instant,
                               const InstantResult& result);

}  // namespace multibody
