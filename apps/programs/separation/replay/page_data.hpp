#pragma once

#include <string>

#include "programs/separation/replay/replay.hpp"

namespace separation {

/// Data of a page's script: JSON that a script element may hold.
/// @param every  of which rows one is shown
std::string page_data(const Replay& replay, int every);

}  // namespace separation
