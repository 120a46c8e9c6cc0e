#pragma once

#include <string>
#include <vector>

#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"

namespace contact {

/// Share of the smaller Young's modulus up to which linear elasticity is
/// taken to hold: strains of some 5 %.
inline constexpr double largest_pressure_share = 0.05;

/// Where the largest contact of some loads leaves the theory or what its
/// materials bear, a sentence each; none if it does not:
/// - a peak above largest_pressure_share of the smaller Young's modulus,
/// - a peak above the limit_pressure of a material,
/// - a half-angle beyond the limit half-angle of the pair, by more than what
///   FittedLaw may be wrong by (0.1 %), as laws of the paper may give it.
///
/// @param pair           of the surfaces, moduli in Pa
/// @param half_angle     theta0, rad; NaN for none
/// @param peak_pressure  Pa; NaN for none
std::vector<std::string> contact_notes(JointKind kind, const ElasticPair& pair,
                                       double half_angle, double peak_pressure);

/// The largest half-angle and peak of some contacts, for contact_notes().
struct LargestContact {
  double half_angle = 0;     ///< theta0, rad
  double peak_pressure = 0;  ///< Pa

  /// NaN is not larger than anything.
  void add(double other_half_angle, double other_peak_pressure) {
    if (other_half_angle > half_angle) half_angle = other_half_angle;
    if (other_peak_pressure > peak_pressure) {
      peak_pressure = other_peak_pressure;
    }
  }
  void add(const LargestContact& other) {
    add(other.half_angle, other.peak_pressure);
  }
};

}  // namespace contact
