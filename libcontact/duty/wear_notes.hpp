#pragma once

#include <string>

#include "libcontact/pair/joint_geometry.hpp"

/// What is said of wear that is hardly that of a bearing.
namespace contact {

/// @param coefficient  k, m^2/N
/// @return a sentence if k is not 0 and outside 1e-10 to 1e-3 mm^3/(N m); ""
///         otherwise. Of dry liners 7e-8 to 5.5e-6 are published
///         (docs/bearing_design.md).
std::string wear_coefficient_note(double coefficient);

/// @param depth  of the wear, m
/// @return a sentence if it is above a tenth of the radius, where seat and ball
///         or hole and pin no longer fit; "" otherwise
std::string wear_depth_note(double depth, const JointGeometry& geometry);

}  // namespace contact
