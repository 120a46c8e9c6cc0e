#pragma once

#include <string>

namespace multibody {

/// The bytes of a file or pipe.
/// @throws contact::Error "FILE: cannot be read: REASON"
std::string file_text(const std::string& file);

}  // namespace multibody
