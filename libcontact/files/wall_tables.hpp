#pragma once

#include <optional>
#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact {

/// [wall] and [[coating]] of a joint; none if it has neither.
/// @param radius  of the ball or pin, m
/// @param pair    [materials]: the inner body is the core of a coated one, the
///                outer one the first layer of a wall that names no material
std::optional<LayeredPair> walls_from_table(const TomlTable& joint,
                                            double radius,
                                            const ElasticPair& pair);
/// wall and coating.
KnownKeys wall_keys();

}  // namespace contact
