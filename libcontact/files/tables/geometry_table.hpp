#pragma once

#include <optional>

#include "libcontact/files/toml_reader.hpp"
#include "libcontact/joint/spec.hpp"

/// Sizes of joints: [geometry], and the temperatures that change them.
namespace contact {

/// hole and shaft, with a diameter.
/// @param table  [geometry]
std::optional<Fit> fit_from_table(const TomlTable& table);
/// designation, with a clearance group.
/// @param table  [geometry]
std::optional<SphericalBearing> bearing_from_table(const TomlTable& table);
/// @param joint  what [geometry], `table`, is in
JointGeometry geometry_from_table(
    const TomlTable& joint, const TomlTable& table,
    const std::optional<Fit>& fit,
    const std::optional<SphericalBearing>& bearing);
/// [relief] of a pin.
Relief relief_from_table(const TomlTable& file, const JointGeometry& geometry);
/// The joint at the temperatures of its file.
JointSpec at_temperatures(const TomlTable& table, const JointSpec& joint);
/// Keys of [geometry] and [relief], and temperatures.
KnownKeys geometry_keys();

}  // namespace contact
