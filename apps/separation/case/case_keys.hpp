#pragma once

#include <vector>

#include "libcontact/files/toml_reader.hpp"

namespace separation {

/// All keys that a case file may have (README.md of this folder).
std::vector<contact::KnownKey> case_keys();

}  // namespace separation
