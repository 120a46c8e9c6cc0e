// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace contact {

/// How far the surfaces of a pin and its hole draw apart towards the ends: a
/// further clearance e(z) >= 0, z along the axis from the middle of the
/// contact. A value.
class Relief {
 public:
  /// Part of the profile: curvature (z - centre)^2.
  struct Piece {
    double from, to;   ///< z, m
    double centre;     ///< m
    double curvature;  ///< 1/m, >= 0
    double at(double z) const {
      return curvature * (z - centre) * (z - centre);
    }
  };

  /// Straight surfaces.
  static Relief none() { return {Kind::none, 0, 0}; }
  /// depth (2 z/l)^2 along the whole length l: a barrel.
  /// @param depth  at the ends, m, (0, infinity)
  /// @throws Error if it is out of range
  static Relief barrel(double depth);
  /// depth ((|z| - l/2 + length)/length)^2 over the length at each end.
  /// @param depth   at the ends, m, (0, infinity)
  /// @param length  m, (0, infinity); at most half of the joint's
  /// @throws Error if an argument is out of range
  static Relief ends(double depth, double length);

  /// In order, from -l/2 to l/2.
  /// @param length  l of the joint, m
  /// @throws Error if it is less than two lengths of relief
  std::vector<Piece> pieces(double length) const;

  /// Effects that a level, endless contact leaves out: one sentence, or none.
  std::vector<std::string> notes() const;

  enum class Kind { none, barrel, ends };
  Kind kind() const { return kind_; }
  double depth() const { return depth_; }    ///< m
  double length() const { return length_; }  ///< length of the ends, m; else 0

  friend bool operator==(const Relief&, const Relief&) = default;

 private:
  Relief(Kind kind, double depth, double length)
      : kind_(kind), depth_(depth), length_(length) {}

  Kind kind_;
  double depth_;
  double length_;
};

}  // namespace contact
