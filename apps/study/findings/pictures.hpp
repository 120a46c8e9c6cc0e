#pragma once

#include <string>

#include "study/findings/findings.hpp"

namespace study {

/// Draws NAME_K.EXT, the histogram of the K-th requirement with its limit and
/// bounds, NAME_ranking.EXT, what drives it, and of a case NAME_clearance.EXT
/// and NAME_angles.EXT, between which values the first runs and the worst ones
/// were over the time.
/// @return "" or why there are no pictures
std::string draw_pictures(const Study& study, const Findings& findings,
                          const Journal& journal, const std::string& file);

}  // namespace study
