#pragma once

#include <optional>
#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "multibody/motion/motion_options.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// Keys of a [[body.hinge.stop]].
contact::KnownKeys stop_keys();

/// The stops of a [body.hinge], one on each side at most.
/// @param start  of its body, for the side on which it lives
/// @throws contact::Error of stops beyond which the body starts, or which leave
///   it no angle
std::vector<HingeStop> read_stops(const contact::TomlTable& table,
                                  const Hinge& hinge,
                                  const multibody::BodyStart& start);

/// Keys of a [body.hinge.torque_margin], and the way that it asks of: from the
/// start unless it says so.
contact::KnownKeys margin_keys();
std::optional<MarginPath> read_margin(const contact::TomlTable& table,
                                      const Hinge& hinge,
                                      const multibody::BodyStart& start);

}  // namespace separation
