#pragma once

#include "libcontact/files/joint_file.hpp"
#include "libcontact/files/toml_reader.hpp"
#include "libcontact/joint/spec.hpp"

/// Joints as tables of TOML files, for files that have joints in them.
namespace contact {

/// A joint that is part of a larger file, which has joint_keys() among its own.
/// Paths are relative to the folder of the table's file.
JointSpec joint_from_table(const TomlTable& table);
/// A joint that is all of a file with joint_keys().
/// @param materials for a file without [materials]
JointSpec joint_of_file(const TomlTable& file,
                        const MaterialPair* materials = nullptr);
/// All keys that a joint may have.
KnownKeys joint_keys();

}  // namespace contact
