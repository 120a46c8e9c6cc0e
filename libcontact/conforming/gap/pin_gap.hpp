#pragma once

#include <vector>

#include "libcontact/conforming/gap/signed_contact.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact::detail {

/// Contact of a pin in a hole over more than half of the circle, by the gap on
/// the part that is open: the dual of PinContact, whose unknown is the
/// pressure. Best where PinContact ends: exact at 180 deg, where the contact
/// closes all round.
///
/// Accuracy (conforming/gap_test.cpp): x, S, shift, stiffness and p(0) 1e-9,
/// for half-angles from 100 deg on and walls down to 0.02 radii.
class PinGap {
 public:
  /// Half-angles from which it is good, rad: 100 deg.
  static constexpr double smallest_half_angle = 1.7453292519943295;

  /// @param pair      layers may be none
  /// @param unknowns   [8, 64]; 0 for as many as the walls ask for
  /// @param harmonics  share of those that 1e-9 takes; what the rest leaves
  ///                   grows like its cube
  explicit PinGap(const LayeredPair& pair, int unknowns = 0,
                  double harmonics = 1);
  /// For tables, which are good to 1e-7: within 1e-8 of the other at a third
  /// of the cost.
  static PinGap coarse(const LayeredPair& pair) {
    return PinGap(pair, 0, 0.15);
  }

  /// @param opening  psi = pi - theta0, (0, pi - smallest_half_angle], rad
  SignedContact solve(double opening) const { return field(opening).contact; }
  /// The same with its series.
  GapField field(double opening) const;

  /// p(theta)/p_1; 0 outside the contact.
  /// @param theta  from the contact's centre, rad, [0, pi]
  double pressure(const GapField& field, double theta) const;
  /// p(0)/p_1, more accurate than pressure().
  double centre(const GapField& field) const;

  double mean_compliance() const { return mean_; }    ///< c_0
  double first_compliance() const { return first_; }  ///< c_1, may be NaN

 private:
  /// 1/c_n - n + beta, n >= 2, which falls like 1/n.
  double stiffness_rest(int n) const;
  double smooth(const GapField& field, double opposite) const;

  double beta_;
  double mean_;
  double first_;
  std::vector<double> correction_;  // Dc_n
  int unknowns_;
  double harmonics_;
};

}  // namespace contact::detail
