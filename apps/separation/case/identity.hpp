#pragma once

#include <string>

#include "separation/case/case.hpp"

namespace separation {

/// What two cases that move alike have in common: the numbers of the joints,
/// which may come from other files, and the content of the case's.
std::string identity(const Case& c);

}  // namespace separation
