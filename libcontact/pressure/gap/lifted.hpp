#pragma once

#include <memory>
#include <span>

#include "libcontact/conforming/gap/signed_contact.hpp"
#include "libcontact/half_angle/opening_series.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact::detail {

/// The pressure of contacts that interference keeps closed over most of the
/// seat or hole: from a half-angle above 100 deg to 180 deg, where they close
/// all round. The gap's series (PinGap, BallGap) as an OpeningSeries, t
/// as in ClosingTable. All over p_1, the pressure's first harmonic.
///
/// Accuracy (pressure/interference_test.cpp): S and p(0) 1e-7, for walls below
/// 0.1 radii 5e-6; p elsewhere 1e-6 of the peak.
class LiftedPressure {
 public:
  /// @param pair     layers may be none; c_0 > 0
  /// @param largest  psi, (0, 80 deg]
  LiftedPressure(JointKind kind, const LayeredPair& pair, double largest);
  ~LiftedPressure();

  /// @param opening  psi, [0, largest]
  double mean(double opening) const;    ///< p_0/p_1
  double centre(double opening) const;  ///< p(0)/p_1
  /// @param theta  from the contact's centre, rad, [0, pi]
  double pressure(double theta, double opening) const;
  /// For a ball: p_n/p_1, n < out.size().
  void harmonics(double opening, std::span<double> out) const;

 private:
  struct Gap;
  GapField field(double opening) const;

  std::unique_ptr<const Gap> gap_;
  OpeningSeries series_;
};

}  // namespace contact::detail
