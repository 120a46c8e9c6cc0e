#pragma once

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case_names.hpp"

namespace separation {

/// One [[event]].
Event read_event(const contact::TomlTable& table, const CaseNames& names);

}  // namespace separation
