// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/joint/contact.hpp"

namespace contact {

/// Wear coefficients k of the two bodies, m^2/N, >= 0.
struct WearCoefficients {
  double seat;       ///< k of the seat or hole
  double inner = 0;  ///< k of the ball or pin
};

/// Wear of a seat or hole, as it is passed on from run to run.
struct WornSeat {
  /// Depths of wear, m; empty if nothing has worn. For a hole at even points of
  /// the circle from X towards Y, in the axes of its body; for a seat at the
  /// cells of a grid about a pole in these axes, latitude after latitude of one
  /// longitude after the other.
  std::vector<double> depths = {};
  Eigen::Vector3d pole = {0, 0, 1};
  double reach = 0;   ///< reach of the grid from its pole, rad
  double cycles = 0;  ///< in which it went
};

/// How many depths a WornSeat has: 360, of a ball as many as cells of 4 deg.
std::size_t worn_points(JointKind kind, const WornSeat& seat);

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
    // Values of one cycle in this state; the largest are taken over its rows.
    double energy = 0;         ///< J
    double mean_moment = 0;    ///< N m
    double half_angle = 0;     ///< largest, rad
    double peak_pressure = 0;  ///< largest, Pa
    double pv = 0;             ///< largest, W/m^2
  };

  /// At the beginning of each block of cycles and, last, after all of them.
  std::vector<State> states;
  /// The seat or hole after all cycles; without depths where the load stands
  /// still, as no points are worn then.
  WornSeat worn;
  /// Notes for the user: sentences without a full stop.
  std::vector<std::string> notes;
};

/// Wear of a joint on a duty cycle, with the geometry that it changes.
///
/// **Where the load stands still in the seat** (JointCycle::contact_spread() at
/// most 0.05 of the half-angle before wear, the mean with the weight of p v):
/// blocks of cycles in which v grows by at most 10 % of g(theta0), see
/// WornHalfAngle and RunningInPressure. The mean of g over the cycle has the
/// weight of p v. Where a ball does not mostly spin, the half-angle is within
/// 1.1 deg of joints that wear step by step and the peak within 6 %; of a ball
/// whose v is above 4 g(theta0 without wear) the peak is up to 17 % too high,
/// for WornPressure takes all places to slide alike (duty/wear_in_test.cpp).
/// The wear of the ball or pin changes nothing.
///
/// **Where it moves** the depth of the wear is one more gap at each point, and
/// the contact is solved there by elasticity alone, at places of the cycle,
/// block after block (docs/explanation/wear.md). Accuracy:
/// duty/moving_wear_test.cpp. penetration is the deepest wear, v follows from
/// the volume, largest values are taken over 36 instants (balls: 24), R_n and
/// its direction are the values before wear. The wear of the pin changes
/// nothing.
///
/// A pin without clearance or with interference is stepped too, from closed to
/// lifted to clearance: its hole by its own pressure, the pin, which turns, by
/// the mean one.
///
/// @param contact  before wear
/// @param k        of both bodies
/// @param cycles   N, >= 0
/// @param before   what is gone already; with it, an empty one too, the joint
///                 is stepped, whatever its load does
/// @param progress  called at each of the `states` with its cycles; an
///                  exception ends the computation
/// @throws Error if an argument is out of range, the half-angle of a load that
///         stands still comes above 90 deg (as WearMap), the wear is deeper
///         than the radius, or the laws have no value at some time of the
///         cycle.
WearIn wear_in(const DutyCycle& cycle, const JointContact& contact,
               const WearCoefficients& k, double cycles,
               const WornSeat* before = nullptr,
               const std::function<void(double)>& progress = {});

}  // namespace contact
