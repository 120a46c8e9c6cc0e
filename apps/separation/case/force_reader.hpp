#pragma once

#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case_names.hpp"

namespace separation {

/// Reads one [[force]]: a force for each body that it names.
std::vector<Force> read_forces(const contact::TomlTable& table,
                               const CaseNames& names);
/// Force on the body in place `copy` among these, from 0.
Force read_force(const contact::TomlTable& table, const CaseNames& names,
                 int copy);

}  // namespace separation
