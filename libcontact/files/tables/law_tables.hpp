#pragma once

#include "libcontact/files/toml_reader.hpp"
#include "libcontact/joint/spec.hpp"

/// [half_angle], [pressure] and [loading] of joints.
namespace contact {

/// Takes them, one after the other: they have to fit the walls and each other.
void read_laws(const TomlTable& table, JointSpec& joint);
/// Their keys.
KnownKeys law_keys();

}  // namespace contact
