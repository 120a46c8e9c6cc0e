#pragma once

#include "libcontact/files/toml_reader.hpp"

namespace separation {

/// All keys that a case file may have (libcontact/docs/reference/case_file.md).
contact::KnownKeys case_keys();

}  // namespace separation
