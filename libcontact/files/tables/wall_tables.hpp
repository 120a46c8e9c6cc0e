#pragma once

#include "libcontact/files/toml_reader.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact {

/// The ball or pin with its [[coating]], if there are any.
/// @param radius  of the ball or pin, m
/// @param core    [materials.inner]
LayeredBody coated_body(const TomlTable& joint, double radius,
                        const Material& core);
/// The seat or hole with its [wall], if there is one.
/// @param outer  [materials.outer]: also of a first layer that names no
/// material
LayeredBody wall_from_table(const TomlTable& joint, double radius,
                            const Material& outer);
/// plane_state = "stress" of pins: materials whose plane strain is the plane
/// stress of those that the file has, E (1 + 2 nu)/(1 + nu)^2 and
/// nu/(1 + nu), in all layers and backings.
void take_plane_state(const TomlTable& joint, JointKind kind,
                      LayeredBody& inner, LayeredBody& outer);
/// wall and coating.
KnownKeys wall_keys();

}  // namespace contact
