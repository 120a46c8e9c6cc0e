// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"

namespace contact {

/// A force law of the literature at one force.
struct PublishedApproach {
  double penetration;  ///< delta, m
  double slope;        ///< dF/d delta, N/m
  /// The law has turned round (delta falls as the force grows, or is negative),
  /// or the clearance is none that it was fitted to.
  bool outside;
};

/// A force law of the clearance-joint literature. None knows a wall.
struct PublishedForceLaw {
  std::string_view name;    ///< "johnson"
  std::string_view source;  ///< "Johnson 1985"
  std::string_view note;    ///< its weakness
  std::function<PublishedApproach(double force)> at;
};

/// Returns the eight published laws for a pin, Hertz' for a ball:
/// docs/how-to/play.md. First sources are named; the formulas as collected in
/// `docs/reference/references.md#pereira-2011`.
std::vector<PublishedForceLaw> published_force_laws(
    const JointGeometry& geometry, const ElasticPair& pair);

}  // namespace contact
