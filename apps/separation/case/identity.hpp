#pragma once

#include <string>

#include "separation/case/case.hpp"

namespace separation {

/// Text that is equal for cases with the same motion: the numbers of the
/// joints, which may come from other files, and the content of the case file.
std::string identity(const Case& c);

}  // namespace separation
