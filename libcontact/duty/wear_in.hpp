#pragma once

#include <string>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/joint_cycle.hpp"
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
  /// s of RunningInPressure at the mean g of the cycle: 0 the joint's own
  /// pressure, 1 the worn one.
  double worn_share = 0;
  // Of one cycle then; the largest are of its rows.
  double energy = 0;         ///< J
  double mean_moment = 0;    ///< N m
  double half_angle = 0;     ///< largest, rad
  double peak_pressure = 0;  ///< largest, Pa
  double pv = 0;             ///< largest, W/m^2
};

/// How far the contact wanders over the seat or hole in a cycle: root mean
/// square of the angle between its centre and the middle of its places, in the
/// seat's axes and with the weight of p v, rad; 0 without p v.
double contact_spread(const JointCycle& cycle);

/// A joint that wears.
struct WearIn {
  /// At the beginning of each block of cycles and, last, after all of them.
  std::vector<WornState> states;
  /// What the user should know: sentences without a full stop.
  std::vector<std::string> notes;
};

/// What wear does to a joint, with the geometry that it changes: blocks of
/// cycles in which v grows by at most 10 % of g(theta0), see WornHalfAngle and
/// RunningInPressure. Of g over the cycle the mean with the weight of p v.
///
/// Where load and seat stand still against each other, and a ball does not
/// mostly spin, the half-angle is within 1.1 deg of joints that wear step by
/// step and the peak within 6 %; of a ball whose v is above 4 g(theta0 without
/// wear) the peak is up to 17 % too high, for WornPressure takes all places to
/// slide alike (duty/wear_in_test.cpp). A load that moves makes the contact too
/// wide and the peak too low: noted where contact_spread() is above 0.3 of the
/// half-angle before wear, the mean with the weight of p v.
///
/// @param contact      before wear
/// @param coefficient  k of the seat or hole, m^2/N, >= 0
/// @param cycles       N, >= 0
/// @throws Error if an argument is out of range, contact_spread() is above that
///         half-angle, the half-angle comes above 90 deg (check_wear()), the
///         wear is deeper than the radius, or the laws have no value at some
///         time of the cycle.
WearIn wear_in(const DutyCycle& cycle, const JointContact& contact,
               double coefficient, double cycles);

/// sigma_Y of a ball that turns about an axis across its load, a = 0, in a seat
/// that this has worn to a steady shape. p v is proportional to cos theta then,
/// p to cos theta/w with the slip w = |Dw x r|/|Dw|, and
///
///     sigma_Y = 2 pi sin^2 theta0/(J[1] + cos theta0 I[1]),  J, I of a = 0.
///
/// WornPressure leaves w out; its sigma_Y is up to 0.41 % too large.
///
/// @param half_angle  theta0, rad, [0, pi/2]; NaN outside
/// @return 1 at 0, 4/pi at pi/2; relative error at most 1e-11
///         (duty/wear_in_test.cpp).
double worn_in_sliding_coefficient(double half_angle);

}  // namespace contact
