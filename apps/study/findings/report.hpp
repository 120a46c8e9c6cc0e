#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "study/findings/findings.hpp"

namespace study {

/// What a study says, for programs; NaN is null.
nlohmann::ordered_json to_json(const Study& study, const Findings& findings);

/// The same for people: Markdown.
/// @param command  that begins the one for a single run
std::string to_text(const Study& study, const Findings& findings,
                    const std::string& command);

/// "clearance.smallest_m at least 0.05"
std::string to_string(const Requirement& requirement);

}  // namespace study
