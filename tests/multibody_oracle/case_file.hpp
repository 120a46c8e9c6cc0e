#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "multibody_support/instant.hpp"

/// Cases in the formats of data/reference/multibody and, of bodies on bodies,
/// data/reference/trees (their README.md): one instant of a carrier with
/// bodies, as JSON.
namespace multibody {

/// An instant of a file.
struct CaseInstant : Instant {
  // NOLINTNEXTLINE: any instant, in the format of stars
  CaseInstant(Instant instant = {}) : Instant(std::move(instant)) {}
  bool is_tree = false;  ///< the file has the format of trees
};

/// Reads a case, its "schema" says which format. Of a star the file's "kind" is
/// "spherical" or "axes" for all bodies, or "mixed": then each body has its own
/// "kind", one of "spherical", "axis" and "free". A body with "held": true does
/// not turn in its joint. Forces and friction moments that are left out are
/// zero, gravity has to be there; velocities and rotations that are given twice
/// have to agree to 1e-6. Keys that the format does not have are refused, but
/// for those inside "expected", which is not looked at.
/// @throws contact::Error "FILE: what is wrong"
CaseInstant read_case(const std::string& file);

/// The same from parsed JSON.
/// @throws contact::Error; nlohmann::json::exception where a key is missing or
///   its value of another type
CaseInstant instant_from_json(const nlohmann::json& json);

/// The result with the keys and in the frames of the format's "expected".
nlohmann::ordered_json to_json(const CaseInstant& instant,
                               const InstantResult& result);

}  // namespace multibody
