#pragma once

#include "libcontact/files/toml_reader.hpp"
#include "libcontact/pair/material.hpp"

namespace contact {

/// Permission for rigid materials: youngs_modulus = inf.
enum class Rigid { allowed, refused };

/// The keys of material_keys() of a table.
Material material_from_table(const TomlTable& table,
                             Rigid rigid = Rigid::allowed);
KnownKeys material_keys();

}  // namespace contact
