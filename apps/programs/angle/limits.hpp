#pragma once

#include <cstddef>

#include "cli/joint/joint_options.hpp"
#include "libcontact/pressure/validity.hpp"

namespace hinge_angle {

/// Limits of a joint's contacts by one of its half-angle laws. For a pin
/// without a length no contact counts as short.
inline contact::ContactLimits limits_of(const cli::Joint& joint,
                                        std::size_t law = 0) {
  const contact::JointGeometry& given = joint.spec.geometry;
  return {*joint.laws[law].law, joint.pair,
          joint.has_length ? given
                           : contact::JointGeometry::pin(
                                 given.radius(), given.radial_clearance(),
                                 2 * given.radius())};
}

}  // namespace hinge_angle
