#pragma once

#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case_names.hpp"

namespace separation {

/// Reads one [[force]]: a force for each body that it names and each place of
/// its pattern, whose names are numbered then.
std::vector<Force> read_forces(const contact::TomlTable& table,
                               const CaseNames& names);
/// The one in place `copy` among these, from 0.
Force read_force(const contact::TomlTable& table, const CaseNames& names,
                 int copy);

/// Throws where engines may burn as much as their body has.
void check_propellant(const contact::TomlTable& file, const Case& c);

}  // namespace separation
