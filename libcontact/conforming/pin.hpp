#pragma once

#include <memory>

#include "libcontact/conforming/contact_pressure.hpp"
#include "libcontact/conforming/exact_results.hpp"
#include "libcontact/conforming/force_point.hpp"
#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/material.hpp"

namespace contact {

namespace detail {
struct SignedContact;
}

/// The elastic constants that PinContact needs.
struct PinConstants {
  double mean_share;       ///< c_0 + beta: w_2 = (1 + alpha)/2, and Dc_0
  double beta;             ///< Dundurs' beta
  double inner_share;      ///< w_1; for back loading only
  double inner_beta_part;  ///< k_1 = (1 - 2 nu_1)/(2 (1 - nu_1)); likewise
};

/// Exact contact of a pin in a hole, for any elastic pair: Chebyshev-Galerkin
/// solution of the Prandtl equation of docs/internals/conforming_methods.md.
/// One object per pair and loading; const functions that do not allocate and do
/// not throw.
///
/// Plane strain, no friction, first order in the clearance; the outer body is
/// infinite unless it is given its walls. The load parameter is
/// lambda = 2 P/(pi ebar rho1 E).
///
/// Accuracy (conforming/pin_test.cpp): with 16 unknowns the relative error of
/// 1/lambda, times lambda or 1 whichever is less, is below 1e-9 for
/// theta0 <= 120 deg and any pair; theta0 is within 1e-9 deg of the closed
/// form where that exists. The error falls as the sixth power of the number
/// of unknowns, for beta = 0 like tan(theta0/4)^(4 unknowns). With walls: 1e-6
/// of the load down to 0.003 radii of thickness (conforming/walls_test.cpp);
/// these contacts use the heap.
class PinContact {
 public:
  static constexpr int default_unknowns = 16;
  static constexpr int max_unknowns = 32;
  /// Limit for contacts with walls, whose edge may have a thin layer.
  static constexpr int max_walled_unknowns = 64;

  /// @param pair      elastic constants, pin inner
  /// @param loading   how the pin is loaded
  /// @param unknowns  truncation, [8, max_unknowns]
  /// @throws Error if unknowns is out of range.
  explicit PinContact(const ElasticPair& pair,
                      InnerLoading loading = InnerLoading::centre(),
                      int unknowns = default_unknowns);

  /// A pin or hole with layers. E in lambda belongs to the two surfaces.
  /// @param unknowns  truncation, [8, max_walled_unknowns]; 0 for as many as
  ///                  the thickness asks for
  /// @throws Error if unknowns is out of range, or for a coated pin that is
  ///               loaded through the back, or for thin layers that hardly
  ///               yield between stiff bodies (docs/how-to/walls_matter.md).
  explicit PinContact(const LayeredPair& pair,
                      InnerLoading loading = InnerLoading::centre(),
                      int unknowns = 0);

  /// By Dundurs' parameters of plane strain, loaded at the centre.
  /// @param outer_compliance_share  w_2 = (1 + alpha)/2, [0, 1]
  /// @param dundurs_beta            [-0.5, 0.5]
  /// @throws Error if an argument is out of range.
  static PinContact from_dundurs(double outer_compliance_share,
                                 double dundurs_beta,
                                 int unknowns = default_unknowns);

  /// 1/lambda: > 0 below the limit angle, 0 there, < 0 beyond.
  /// @param half_angle  theta0, rad, (0, largest()]; NaN outside
  double reciprocal_load(double half_angle) const noexcept;

  /// lambda at theta0 in (0, limit], with an estimate of its error; lambda = 0
  /// at theta0 = 0.
  ExactLoad load_parameter(double half_angle) const noexcept;

  /// theta0 at lambda in [0, infinity]. not_converged if theta0 exceeds
  /// largest().
  ExactHalfAngle half_angle(double load_parameter) const noexcept;

  /// theta0*, to which theta0 tends as the load grows.
  ExactHalfAngle limit_half_angle() const noexcept;

  /// Normal approach over the clearance, and stiffness in units of E, at
  /// theta0 in (0, largest()]; exact, by the solution at theta0 alone. NaN
  /// outside, if loaded through the back, without walls, and in a hole that is
  /// infinite behind its layers: it gives way without end.
  ContactApproach approach(double half_angle) const noexcept {
    return force_point(half_angle).approach;
  }

  /// The load, approach() and S at theta0, all by one solution; NaN where
  /// approach() is.
  ForcePoint force_point(double half_angle) const noexcept;

  /// The contact in quantities that do not end where the clearance does: for
  /// half-angles about the limit angle and beyond, which interference has.
  /// NaN outside (0, largest()], and if loaded through the back.
  detail::SignedContact signed_contact(double half_angle) const noexcept;

  /// Pressure at theta0 in (0, largest()], in units of P/rho. Beyond the
  /// limit angle it is the pressure of a pin with interference.
  ///
  /// Accuracy: 1e-7 of the peak for theta0 <= 120 deg
  /// (conforming/pin_test.cpp).
  /// @param terms  sines of the expansion: 12 (up to 120 deg), 32 or 64; 0 for
  ///               terms()
  ContactPressure pressure(double half_angle, int terms = 0) const noexcept;

  /// Sines of pressure() unless told otherwise: 32, or 64 for thin walls.
  int terms() const noexcept;

  /// Largest theta0 of this object, rad: 4 atan(10^(-2/unknowns)), where the
  /// truncation error tan(theta0/4)^(4 unknowns) is 1e-8 (147 deg for 16
  /// unknowns, 163 deg for 32), and less than pi - psi when loaded from the
  /// back.
  double largest() const noexcept { return largest_; }

 private:
  struct Wall;
  struct Yield;
  struct System;
  struct Solution;

  PinContact(PinConstants constants, InnerLoading loading, int unknowns,
             int most);
  System system(double half_angle) const noexcept;
  double reciprocal(double half_angle) const noexcept;
  Yield yield(double half_angle, const System& system,
              const Solution& solution) const noexcept;

  PinConstants constants_;
  InnerLoading loading_;
  int unknowns_;
  double largest_;
  std::shared_ptr<const Wall> wall_;  // none: infinite
};

}  // namespace contact
