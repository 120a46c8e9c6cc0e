#pragma once

#include <functional>

#include "separation/clearance/clearance.hpp"

namespace separation {

/// Lower bound of the distance of two solids between two evaluations, m.
///
/// Their speed limits their approach (Lipschitz), and two planes that prove a
/// distance continue to prove one, by their rate and the accelerations, until
/// they meet. The velocities at both evaluations, plus their difference, bound
/// speeds and accelerations in between, because steps are smooth.
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
