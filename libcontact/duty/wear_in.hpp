#pragma once

#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/joint/contact.hpp"

namespace contact {

/// A joint after some cycles of wear of its seat or hole.
struct WornState {
  double cycles = 0;
  double volume = 0;       ///< worn off the seat or hole, m^3
  double wear_number = 0;  ///< v: volume over pi rho^2 eps or 2 rho eps l
  /// eps (1/cos theta0 - 1), m, the deepest overlap of the undeformed shapes:
  /// the deepest wear, up to 8 % too much, once v is above 2 g(theta0 without
  /// wear); before, elastic for the most part.
  double penetration = 0;
  bool worn_in = false;  ///< whether the pressure is WornPressure
  // Of one cycle then; the largest are of its rows.
  double energy = 0;         ///< J
  double mean_moment = 0;    ///< N m
  double half_angle = 0;     ///< largest, rad
  double peak_pressure = 0;  ///< largest, Pa
  double pv = 0;             ///< largest, W/m^2
};

/// What wear does to a joint, with the geometry that it changes: blocks of
/// cycles in which v grows by at most 10 % of g(theta0), see WornHalfAngle. The
/// pressure is the joint's own until v is above g(theta0 without wear), then
/// WornPressure. Of g over the cycle the mean with the weight of p v.
///
/// @param contact      before wear
/// @param coefficient  k of the seat or hole, m^2/N, >= 0
/// @param cycles       N, >= 0
/// @return the joint at the beginning of each block and, last, after N cycles
/// @throws Error if an argument is out of range, the half-angle comes above 90
///         deg, or the laws have no value at some time of the cycle.
std::vector<WornState> wear_in(const DutyCycle& cycle,
                               const JointContact& contact, double coefficient,
                               double cycles);

}  // namespace contact
