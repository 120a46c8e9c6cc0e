#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "multibody_support/instant.hpp"

/// Cases in the format of data/reference/multibody (its README.md): one
/// instant of a carrier with bodies, as JSON.
namespace multibody {

/// Reads a case. The file's "kind" is "spherical" or "axes" for all bodies, or
/// "mixed": then each body has its own "kind", one of "spherical", "axis" and
/// "free". A body with "held": true does not turn in its joint. Forces and
/// friction moments that are left out are zero, gravity has to be there;
/// velocities and rotations that are given twice have to agree to 1e-6. Keys
/// that the format does not have are refused, but for those inside
/// "expected", which is not looked at.
/// @throws contact::Error "FILE: what is wrong"
Instant read_case(const std::string& file);

/// The same from parsed JSON.
/// @throws contact::Error; nlohmann::json::exception where a key is missing or
///   its value of another type
Instant instant_from_json(const nlohmann::json& json);

/// The result with the keys and in the frames of the format's "expected".
nlohmann::ordered_json to_json(const Instant& instant,
                               const InstantResult& result);

}  // namespace multibody
