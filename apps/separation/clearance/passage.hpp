#pragma once

#include <functional>

#include "separation/clearance/clearance.hpp"

namespace separation {

/// Lower bound of the distance of two solids between two evaluations, m.
///
/// Their speed limits their approach (Lipschitz), and two planes that prove the
/// distance of one evaluation prove one at the other and, by the accelerations
/// of b's points, in between. The velocities at both evaluations, plus their
/// difference, bound speeds and accelerations, because steps are smooth; a
/// rotation by h w changes accelerations by that share.
double least_between(const Clearance::SolidLook& from,
                     const Clearance::SolidLook& to);

/// Searches for the smallest distance of two solids between two evaluations,
/// and for the times at which they begin and cease to touch: halves the path
/// until no part can have a distance smaller than the known one by `accuracy`.
/// @param look   evaluates and records distances
/// @param known  the smallest distance evaluated so far
/// @param accuracy  m; `look` may raise it if distances hardly change, which
///               halving cannot detect
void search_passage(
    const std::function<Clearance::SolidLook(double time)>& look,
    const Clearance::SolidLook& from, const Clearance::SolidLook& to,
    const double& known, const double& accuracy);

}  // namespace separation
