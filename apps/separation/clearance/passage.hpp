#pragma once

#include <functional>

#include "separation/clearance/clearance.hpp"

namespace separation {

/// Not less than this is the distance of two solids between two looks, m.
///
/// They come no nearer than their speed allows (Lipschitz), and two planes that
/// prove a distance go on to prove one, by their rate and the accelerations,
/// until they meet. How large speeds and accelerations are in between follows
/// from the velocities at both looks, and as much more as these differ: steps
/// are smooth.
double least_between(const Clearance::SolidLook& from,
                     const Clearance::SolidLook& to);

/// Looks for the smallest distance of two solids between two looks, and for the
/// times at which they begin and cease to touch: halves the way until no part
/// can have a distance that is smaller than known by `accuracy`.
/// @param look   takes note of what it sees
/// @param known  the smallest distance seen by all looks so far
/// @param accuracy  m; `look` may raise it where distances hardly change, which
///               no halving tells from those that will
void search_passage(
    const std::function<Clearance::SolidLook(double time)>& look,
    const Clearance::SolidLook& from, const Clearance::SolidLook& to,
    const double& known, const double& accuracy);

}  // namespace separation
