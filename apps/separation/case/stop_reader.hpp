#pragma once

#include <optional>
#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "multibody/motion/motion_options.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// Keys of a [[body.hinge.stop]].
contact::KnownKeys stop_keys();

/// Reads the stops of a [body.hinge], at most one on each side.
/// @param start  initial state of its body, which decides the side
/// @throws contact::Error for stops beyond which the body starts, and stops
///   that leave no angle free
std::vector<HingeStop> read_stops(const contact::TomlTable& table,
                                  const Hinge& hinge,
                                  const multibody::BodyStart& start);

/// Keys of a [body.hinge.torque_margin], and its path, by default from the
/// start.
contact::KnownKeys margin_keys();
std::optional<MarginPath> read_margin(const contact::TomlTable& table,
                                      const Hinge& hinge,
                                      const multibody::BodyStart& start);

}  // namespace separation
