#pragma once

#include <string>

#include "separation/record.hpp"

namespace separation {

/// Draws angles, rates, reactions and (if there are any) clearances over time:
/// NAME_angles.EXT, NAME_rates.EXT, NAME_reactions.EXT, NAME_clearance.EXT for
/// the file name NAME.EXT.
/// @return "" or why there are no pictures
std::string draw_pictures(const Case& c, const Rows& rows,
                          const std::string& file);

}  // namespace separation
