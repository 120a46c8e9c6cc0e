#pragma once

#include <string>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/joint/contact.hpp"

namespace contact {

/// Wear coefficients k of the two bodies, m^2/N, >= 0.
struct WearCoefficients {
  double seat;       ///< of the seat or hole
  double inner = 0;  ///< of the ball or pin
};

/// A joint that wears.
struct WearIn {
  /// A joint after some cycles of wear of its seat or hole.
  struct State {
    double cycles = 0;
    double volume = 0;  ///< worn off the seat or hole, m^3
    /// v: volume over pi rho^2 eps or 2 rho eps l; NaN without clearance.
    double wear_number = 0;
    /// Mean radial clearance round a pin, m; NaN of a ball.
    double clearance = 0;
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

  /// At the beginning of each block of cycles and, last, after all of them.
  std::vector<State> states;
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
/// wide and the peak too low: noted where JointCycle::contact_spread() is above
/// 0.3 of the half-angle before wear, the mean with the weight of p v.
///
/// A pin without clearance or with interference wears as PinWear has it, from
/// closed to lifted to clearance: its hole by its own pressure, the pin, which
/// turns, by the mean one. penetration is then the depth of the wear at the
/// middle, R_n that before wear. A load that changes is taken in 8 levels. The
/// wear of a ball or pin with a clearance changes nothing.
///
/// @param contact  before wear
/// @param k        of both bodies
/// @param cycles   N, >= 0
/// @throws Error if an argument is out of range, JointCycle::contact_spread()
/// is above that
///         half-angle, the half-angle comes above 90 deg (as WearMap), the
///         wear is deeper than the radius, or the laws have no value at some
///         time of the cycle.
WearIn wear_in(const DutyCycle& cycle, const JointContact& contact,
               const WearCoefficients& k, double cycles);

}  // namespace contact
