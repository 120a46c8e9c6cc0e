#pragma once

#include <string>
#include <vector>

#include "separation/results/record.hpp"

namespace separation {

/// Names of the pictures that draw_pictures() draws for a case, with or without
/// clearances.
std::vector<std::string> picture_names(const Case& c, bool clearance,
                                       const std::string& file);

/// Draws angles, rates, reactions and, if there are any, clearances over time.
/// For the file name NAME.EXT it writes NAME_angles.EXT, NAME_rates.EXT,
/// NAME_reactions.EXT and NAME_clearance.EXT.
/// @return "" or the reason why there are no pictures
std::string draw_pictures(const Case& c, const Rows& rows, bool clearance,
                          const std::string& file);

}  // namespace separation
