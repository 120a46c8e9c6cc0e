#pragma once

#include <optional>

#include "libcontact/files/toml_reader.hpp"
#include "libcontact/pair/friction_law.hpp"

/// [friction] of joints and of material pairs.
namespace contact {

/// None if the table has no [friction].
std::optional<FrictionModel> friction_from_table(const TomlTable& table);
/// Its keys.
KnownKeys friction_keys();

}  // namespace contact
