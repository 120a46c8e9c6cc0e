#pragma once

#include <optional>
#include <span>
#include <vector>

#include "libcontact/conforming/gap/signed_contact.hpp"
#include "libcontact/conforming/kernel/ball_kernel.hpp"
#include "libcontact/conforming/kernel/ball_wall_kernel.hpp"
#include "libcontact/conforming/legendre_galerkin.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact::detail {

/// Contact of a ball in a complete seat over more than half of the sphere, by
/// the gap where it is open: what PinGap is for a pin. The unknown phi is the
/// Abel transform of the gap,
///
///     g(t') = ∫_t'^psi phi(f)/sqrt(2 (cos t' - cos f)) df,   t' = pi - t.
///
/// Accuracy (conforming/gap_test.cpp): x, S, shift, stiffness and p(0) 1e-9,
/// for half-angles from 100 deg on and walls down to 0.02 radii.
class BallGap {
 public:
  /// Half-angles from which it is good, rad: 100 deg.
  static constexpr double smallest_half_angle = 1.7453292519943295;

  /// @param pair      layers may be none
  /// @param unknowns  [8, 64]; 0 for as many as the walls ask for
  explicit BallGap(const LayeredPair& pair, int unknowns = 0);
  /// As PinGap has it: the same.
  static BallGap coarse(const LayeredPair& pair) { return BallGap(pair); }

  /// @param opening  psi = pi - theta0, (0, pi - smallest_half_angle], rad
  SignedContact solve(double opening) const { return field(opening).contact; }
  /// The same with its series.
  GapField field(double opening) const;

  /// p(theta)/p_1; 0 outside the contact.
  /// @param theta  from the contact's centre, rad, [0, pi]
  double pressure(const GapField& field, double theta) const;
  /// p(0)/p_1, more accurate than pressure().
  double centre(const GapField& field) const;
  /// p_n/p_1, n < out.size().
  void harmonics(const GapField& field, std::span<double> out) const;

  double mean_compliance() const { return mean_; }    ///< c_0
  double first_compliance() const { return first_; }  ///< c_1

 private:
  /// (n + 1/2) e_n = 1/c_n - (n + 1/2), n >= 2, which tends to rest_limit().
  double stiffness_rest(int n) const;
  double rest_limit() const;
  double smooth(const GapField& field, double opposite) const;
  void moments(const GapField& field, std::span<double> out) const;

  BallConstants constants_;
  double mean_;
  double first_;
  std::vector<double> correction_;  // Dc_n
  int unknowns_;
  BallKernel kernel_;
  std::optional<BallWallKernel> wall_kernel_;
  const LegendreGalerkin& galerkin_;
};

}  // namespace contact::detail
