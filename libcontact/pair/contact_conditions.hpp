#pragma once

#include <optional>
#include <string>

#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact {

/// What decides on a contact beside the materials at its two surfaces. The
/// usual case, which every law knows: a force at the centre of the ball or pin,
/// both bodies homogeneous and the outer one infinite.
struct ContactConditions {
  InnerLoading loading = InnerLoading::centre();
  /// Walls and coatings. The materials at the surfaces are then those of
  /// walls->surfaces().
  std::optional<LayeredPair> walls = {};

  friend bool operator==(const ContactConditions&,
                         const ContactConditions&) = default;
};

/// For messages of laws that do not know them: "finite walls", or
/// "loading back:20".
inline std::string to_string(const ContactConditions& conditions) {
  return conditions.walls ? "finite walls"
                          : "loading " + to_string(conditions.loading);
}

}  // namespace contact
