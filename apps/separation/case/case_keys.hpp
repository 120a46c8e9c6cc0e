#pragma once

#include "libcontact/files/toml_reader.hpp"

namespace separation {

/// All keys that a case file may have (README.md of this folder).
contact::KnownKeys case_keys();

}  // namespace separation
