#pragma once

#include <optional>
#include <string>

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// Name, mass, inertia, shapes and directions of a body: the keys of [carrier]
/// and [[body]] that they share.
RigidBody read_rigid_body(const contact::TomlTable& table);

/// Whether an inertia is about no axis above another one, but for rounding.
bool is_below(const Eigen::Matrix3d& inertia, const Eigen::Matrix3d& other);

/// The keys `inertia` or `principal_inertia` after a prefix; none if both are
/// missing.
std::optional<Eigen::Matrix3d> read_inertia(const contact::TomlTable& table,
                                            const std::string& prefix = {});

/// The key that read_inertia() reads, for messages.
std::string inertia_key(const contact::TomlTable& table,
                        const std::string& prefix = {});

/// read_rigid_body() for [carrier]; a fixed one has neither mass nor inertia.
RigidBody read_carrier(const contact::TomlTable& table);

}  // namespace separation
