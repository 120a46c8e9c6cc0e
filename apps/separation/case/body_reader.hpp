#pragma once

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// Name, mass, inertia, shapes and directions of a body: the keys of [carrier]
/// and [[body]] that they share.
RigidBody read_rigid_body(const contact::TomlTable& table);

/// As above for [carrier]; a fixed carrier has neither mass nor inertia.
RigidBody read_carrier(const contact::TomlTable& table);

}  // namespace separation
