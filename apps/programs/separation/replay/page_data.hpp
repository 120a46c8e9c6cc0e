#pragma once

#include <string>

#include "programs/separation/replay/replay.hpp"

namespace separation {

/// Data for a page's script: JSON, safe inside a script element.
/// @param every  shows one row in `every`
std::string page_data(const Replay& replay, int every);

}  // namespace separation
