// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

/// Contacts of balls in seats that end: docs/explanation/seats.md.
namespace contact {

/// A place on a seat. The longitude is counted about the seat's axis from the
/// plane of the load, on whose side it is 0; NaN where every one is alike.
struct SeatPlace {
  double polar_angle = std::numeric_limits<double>::quiet_NaN();  ///< rad
  double longitude = std::numeric_limits<double>::quiet_NaN();    ///< rad
};

/// State of a contact at a rim of its seat.
struct SeatRim {
  /// K = lim p sqrt(2 pi s), s the distance from the rim, at the longitude
  /// where it is largest, Pa m^(1/2); 0 if the contact does not reach it. The
  /// pressure at the rim itself is infinite in the model. NaN at a rim where
  /// the seat's body ends too (SideFace::free): the pressure there follows the
  /// corner, not a punch.
  double intensity = std::numeric_limits<double>::quiet_NaN();
  double longitude = std::numeric_limits<double>::quiet_NaN();  ///< 0 or pi
  /// How far the contact follows the rim to each side, rad; pi: all round.
  double half_arc = std::numeric_limits<double>::quiet_NaN();
  /// Largest pressure on the rim's rounding, Pa, and how far the contact goes
  /// on beyond the rim as drawn, m: SeatContact::rounded_rim() at K with
  /// SeatEdge::radius. NaN of a sharp rim and one that is not reached.
  double peak_pressure = std::numeric_limits<double>::quiet_NaN();
  double reach = std::numeric_limits<double>::quiet_NaN();
  /// From the contact's end to the rim in the plane of the load, rad; 0 if
  /// reached, infinite without a rim.
  double distance = std::numeric_limits<double>::quiet_NaN();
  double gap = std::numeric_limits<double>::quiet_NaN();  ///< the same, m
};

/// The contact of a ball in a seat that ends, under one load. All is NaN where
/// there is none.
struct RimContact {
  /// Whether it does not reach a rim: all is then from the exact laws of the
  /// seat without end.
  bool is_free = false;
  /// Shift of the ball's centre from concentric, m, in the axes of the force.
  Eigen::Vector3d shift =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Pressure where the load pierces the seat, Pa; NaN where there is no seat.
  double pressure_at_load = std::numeric_limits<double>::quiet_NaN();
  /// The largest pressure at the reported distance or more from every rim, Pa.
  /// NaN where it is below mean_pressure(): then the contact lies almost within
  /// that distance, and K alone tells of its pressure.
  double peak_pressure = std::numeric_limits<double>::quiet_NaN();
  SeatPlace peak_place = {};
  std::array<SeatRim, 2> rims = {};  ///< lower, upper
  /// Ends of the contact in the plane of the load, on its side, polar angles,
  /// rad; 0 or pi where it goes on over the pole. NaN if nothing is there.
  double lower_end = std::numeric_limits<double>::quiet_NaN();
  double upper_end = std::numeric_limits<double>::quiet_NaN();
  /// From the load to the contact's end across the plane of the load, rad; NaN
  /// where the load meets no seat, and from a table. To 1 deg
  /// (seat/seat_test.cpp).
  double half_width = std::numeric_limits<double>::quiet_NaN();
  /// S: the sum of the pressures without regard to their direction over |F|.
  double force_ratio = std::numeric_limits<double>::quiet_NaN();
  double area = std::numeric_limits<double>::quiet_NaN();  ///< m^2
  /// SeatContact::nominal_area(), m^2: what catalogues put beneath a load.
  double nominal_area = std::numeric_limits<double>::quiet_NaN();

  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< F on the seat, N

  double mean_pressure() const {  ///< S F/area, Pa
    return force_ratio * force.norm() / area;
  }
  /// Distance from the nearer rim, m.
  double gap() const { return std::min(rims[0].gap, rims[1].gap); }
  /// Whether it reaches a rim.
  bool is_at_rim() const {
    return std::ranges::any_of(rims, [](const SeatRim& rim) {
      return rim.intensity > 0 || rim.half_arc > 0;
    });
  }
  /// The larger K, Pa m^(1/2); above 0 at a rim, NaN at one without K.
  double intensity() const {
    const double k = std::max(rims[0].intensity, rims[1].intensity);
    const bool is_known = k > 0 || !is_at_rim();
    return is_known ? k : std::numeric_limits<double>::quiet_NaN();
  }
  /// The larger peak on a rounded rim, Pa; NaN if none is.
  double rim_pressure() const {
    return std::fmax(rims[0].peak_pressure, rims[1].peak_pressure);
  }
};

/// p v over a contact while its halves turn against each other.
struct ContactPv {
  double total = std::numeric_limits<double>::quiet_NaN();  ///< integral, W
  /// W/m^2; in a seat that ends at the reported distance or more from every
  /// rim, and NaN where it is below the mean over the contact.
  double largest = std::numeric_limits<double>::quiet_NaN();
  /// Unit vector from the joint's centre to where it is.
  Eigen::Vector3d place =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// How a table of the contacts that reach a rim is made.
struct RimTableOptions {
  double least_load;  ///< N, above 0
  double most_load;   ///< N, above least_load, finite
  /// Errors allowed, over the load: shift, as load, and friction at f0 = 1.
  double accuracy = 1e-3;
  int most_states = 1800;  ///< 10 to 20 s
  int checks = 100;
  /// Called with the share of most_states that is done, and the last with 1.
  std::function<void(double)> progress = {};
};

/// The largest errors of states of a table that were drawn at random, over the
/// load.
struct RimTableCheck {
  int states = 0;
  double load = 0;      ///< error of the shift, as load
  double friction = 0;  ///< sums of section "Friction" about a random axis
  double peak = 0;      ///< error of the largest pressure, over itself

  /// Over the load; NaN without a state, which says nothing.
  double error() const {
    return states > 0 ? std::max(load, friction)
                      : std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace contact
