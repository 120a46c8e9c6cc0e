// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "libcontact/pair/fit.hpp"

/// Sizes of spherical plain bearings by their designation.
namespace contact {

/// Groups of radial internal clearance: smaller than normal, normal, larger.
enum class ClearanceGroup { C2, CN, C3 };

/// A radial spherical plain bearing, steel on steel, of dimension series E or G
/// of ISO 12240-1: its ball, the width of its outer ring, and the clearance of
/// a group. Bores of 6 to 300 mm.
///
/// Numbers are those that a catalogue prints (pair/spherical_bearing_test.cpp,
/// against its tables of dimensions and another maker's clearances). Maker's
/// suffixes do not change them. Sizes of lined bearings are the same, their
/// clearances are not.
/// Source: `references.md#ina-238`, pages 31, 106 and 110.
class SphericalBearing {
 public:
  /// @param designation  series E: GE50, GE50E, GE50ES, GE50DO; series G:
  ///   GEH50ES, GE50FO, in small or capital letters, with blanks and suffixes
  ///   as in "GE 50 DO-2RS"
  /// @param taken        the one of the group's clearances that a joint has
  /// @throws Error for a designation that is not in the tables, one of a lined
  ///   series, whose size the message says, or with the suffix of another group
  explicit SphericalBearing(std::string_view designation,
                            ClearanceGroup group = ClearanceGroup::CN,
                            Fit::Clearance taken = Fit::Clearance::mean);

  /// As it was given.
  const std::string& designation() const { return designation_; }
  ClearanceGroup group() const { return group_; }
  Fit::Clearance taken() const { return taken_; }

  double ball_diameter() const;  ///< d_k, m
  double ring_width() const;     ///< C, of the outer ring along its axis, m
  /// Radial internal clearance, by which the ring can be moved from one side to
  /// the other, m: the diametral clearance of a joint.
  double clearance(Fit::Clearance which) const;

  /// For JointGeometry.
  double radius() const { return ball_diameter() / 2; }
  double radial_clearance() const { return clearance(taken_) / 2; }

  friend bool operator==(const SphericalBearing&,
                         const SphericalBearing&) = default;

 private:
  std::string designation_;
  ClearanceGroup group_;
  Fit::Clearance taken_;
  int size_;  // row of the table
};

/// "C2", "CN" or "C3".
std::string to_string(ClearanceGroup group);

/// "bearing GE50ES CN: ball of 66 mm, ring of 28 mm, diametral clearance 60 to
/// 120 um; mean 90 um taken".
std::string to_string(const SphericalBearing& bearing);

}  // namespace contact
