#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace multibody {

/// Parses JSON. Beside syntax errors, numbers beyond double, keys that are
/// there twice in one object, and nesting deeper than 64 are refused.
/// @throws contact::Error "SOURCE:LINE:COLUMN: what is wrong"; for keys
///   "SOURCE: key: ..."
nlohmann::json parse_json(const std::string& text, const std::string& source);

}  // namespace multibody
