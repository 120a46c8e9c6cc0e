// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// Clearances of fits by ISO 286: a hole H7 on a shaft g6.
namespace contact {

/// A seat or hole and a ball or pin of one nominal size, with the clearances
/// that their tolerances leave.
///
/// The limits are tabulated ones, and every clearance is the
/// double nearest to its decimals (pair/pair_test.cpp, against published tables
/// and against the formulas that the standard rounds).
/// Source: standard tolerances and fundamental deviations of ISO 286-1, as
/// catalogues and books print them (data/README.md).
class Fit {
 public:
  /// Tolerance classes, each a letter and a grade from 5 to 9, and others by
  /// name.
  struct Classes {
    std::string_view letters;
    std::string_view others;  ///< with a space behind each
    std::string_view rule;    ///< for messages

    bool contains(std::string_view name) const {
      if (name.size() != 2) return false;
      return (letters.find(name[0]) != letters.npos && name[1] >= '5' &&
              name[1] <= '9') ||
             is_other(name);
    }
    bool is_other(std::string_view name) const {
      const auto at = others.find(name);
      return at != others.npos && at % 3 == 0;
    }
  };
  static constexpr Classes holes = {
      "EFGH", "", "E, F, G or H with a grade from 5 to 9, as H7"};
  static constexpr Classes shafts = {
      "defgh", "k5 k6 k7 m6 n6 p6 r6 s6 ",
      "d, e, f, g or h with a grade from 5 to 9, k5, k6, k7, m6, n6, p6, r6 or "
      "s6, as g6"};

  enum class Clearance { minimum, mean, maximum };

  /// @param hole      of the seat or hole, one of holes
  /// @param shaft     of the ball or pin, one of shafts
  /// @param diameter  nominal size, m, which that shaft has_size()
  /// @param taken     the one of the clearances that a joint is to have
  /// @throws Error if an argument is out of range.
  Fit(std::string_view hole, std::string_view shaft, double diameter,
      Clearance taken = Clearance::mean);

  /// The nominal sizes for which the limits of a shaft were found: 3 mm to
  /// this, m. 500 mm; of m6 to s6 180 mm, of k5 to k7 80 mm.
  static double largest_size(std::string_view shaft);
  static bool has_size(std::string_view shaft, double diameter);

  /// "H7/g6".
  const std::string& name() const { return name_; }
  /// Nominal size, m.
  double diameter() const { return diameter_; }
  /// Diametral clearance, m; 0 is the minimum of H on h, below 0 is
  /// interference.
  double clearance(Clearance which) const;
  /// The one that a joint is to have.
  Clearance taken() const { return taken_; }

  /// For JointGeometry: of a ball or pin in the middle of its tolerance: at
  /// most 1.5 % below half of the nominal size, for d9 above 3 mm.
  double radius() const;
  /// For JointGeometry: half of the clearance that is taken.
  double radial_clearance() const { return clearance(taken_) / 2; }

  friend bool operator==(const Fit&, const Fit&) = default;

 private:
  std::string name_;
  double diameter_;
  Clearance taken_;
  int minimum_um_;
  int maximum_um_;
  double shaft_um_;  // mean deviation of the shaft
};

/// "fit H7/g6 at 50 mm: diametral clearance 9 to 50 um; mean 29.5 um taken".
std::string to_string(const Fit& fit);

}  // namespace contact
