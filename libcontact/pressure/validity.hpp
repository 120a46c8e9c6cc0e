// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "libcontact/half_angle/law.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact {

/// The largest half-angle, peak and overlap with rims of some contacts.
struct LargestContact {
  double half_angle = 0;     ///< theta0, rad
  double peak_pressure = 0;  ///< Pa
  /// How far a contact goes beyond a rim of the seat that was left out,
  /// rim_overlap() of its solution, rad.
  double rim_overlap = 0;

  /// NaN is not larger than anything.
  void add(double other_half_angle, double other_peak_pressure,
           double other_rim_overlap = 0) {
    if (other_half_angle > half_angle) half_angle = other_half_angle;
    if (other_peak_pressure > peak_pressure) {
      peak_pressure = other_peak_pressure;
    }
    if (other_rim_overlap > rim_overlap) rim_overlap = other_rim_overlap;
  }
  void add(const LargestContact& other) {
    add(other.half_angle, other.peak_pressure, other.rim_overlap);
  }
};

/// How large the contacts of a joint may be before they leave the theory or
/// what its materials bear:
/// - a peak of 5 % of the smaller Young's modulus,
/// - a peak of the limit_pressure of a material,
/// - both of the layers under the surface, and of the body behind them, once
/// the
///   contact is as wide on each side as they are deep: the pressure that comes
///   down to them is less than the peak, and not computed,
/// - any contact on a liner that is taken without end (infinite_liner_notes()),
/// - the half-angle that the joint has at infinite load. Laws of the paper may
///   give more. The laws `exact` and `worn` have the limit of their walls and
///   loading; all others are for infinite bodies under a force at the centre,
///   whose limit is FittedLaw's. A note is made beyond the error of that law,
///   0.1 %,
/// - the half-angle at which a contact in the middle of a seat that ends
///   reaches a rim, and any contact that goes beyond a rim where its load
///   points,
/// - of pins the half-angle at which the contact is as wide as the pin is long:
///   what lies beneath yields along the axis too, unless it is a liner thinner
///   than half of that.
class ContactLimits {
 public:
  /// Limits of a joint with a clearance, in a seat without end.
  /// @param law   half-angle law of the joint
  /// @param pair  its surfaces, moduli in Pa
  ContactLimits(const HalfAngleLaw& law, const ElasticPair& pair);
  /// @param law       half-angle law of the joint
  /// @param pair      its surfaces, moduli in Pa
  /// @param geometry  the joint's: contacts of interference may be of any
  ///                  half-angle, and seats may end
  ContactLimits(const HalfAngleLaw& law, const ElasticPair& pair,
                const JointGeometry& geometry);

  /// The smallest limit of the peak pressure that the surfaces have, Pa.
  double peak_pressure() const;

  /// A sentence for each limit that a contact has passed: "peak pressure 30 MPa
  /// is above 20 MPa, the limit pressure of the outer body, polymer".
  std::vector<std::string> notes(const LargestContact& largest) const;
  /// The same without the number, alike for all contacts of the joint: "peak
  /// pressure above 20 MPa, the limit pressure of the outer body, polymer".
  std::vector<std::string> passed(const LargestContact& largest) const;

 private:
  /// Share of the smaller Young's modulus up to which linear elasticity is
  /// taken to hold: strains of some 5 %.
  static constexpr double largest_pressure_share = 0.05;

  struct Limit {
    double LargestContact::*of;
    double value;        ///< Pa or rad
    double unit;         ///< SI value of the unit in notes
    const char* what;    ///< "peak pressure"
    const char* number;  ///< " {:.4g} MPa is"
    std::string beyond;  ///< " above 20 MPa, the limit pressure of ..."
    /// Half-angle from which it counts, rad.
    double least_half_angle = 0;

    bool is_passed(const LargestContact& largest) const {
      return largest.*of > value && largest.half_angle >= least_half_angle;
    }
  };

  void add_pressures(const ElasticPair& pair);
  void add_layers(const LayeredPair& walls);
  void add_liners(const std::vector<std::string>& notes);
  void add_pressure(double limit, const std::string& what,
                    double least_half_angle = 0);
  void add_half_angle(const HalfAngleLaw& law, const ElasticPair& pair);
  void add_length(const LayeredPair& bodies, double length);

  std::vector<Limit> limits_;
};

}  // namespace contact
