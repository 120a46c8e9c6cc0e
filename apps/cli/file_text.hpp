#pragma once

#include <string>

namespace cli {

/// The bytes of a file or pipe.
/// @throws contact::Error "FILE: cannot be read: REASON"
std::string file_text(const std::string& file);

}  // namespace cli
