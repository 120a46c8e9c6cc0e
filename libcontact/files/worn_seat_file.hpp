// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "libcontact/duty/wear_in.hpp"

namespace contact {

/// A worn seat or hole as a TOML file: kind, radius, radial_clearance, cycles,
/// depth of every point (WornSeat), of a ball pole and reach. Numbers are
/// written with all their digits.
std::string worn_seat_text(const WornSeat& seat, const JointGeometry& geometry);

/// @throws Error with one line that names file, line, key and value, if it
/// cannot be read or is not of a joint with this geometry: its kind, radius and
/// clearance, to 1e-9 of the radius.
WornSeat read_worn_seat(const std::filesystem::path& path,
                        const JointGeometry& geometry);

}  // namespace contact
