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

/// Exact contact of a ball in a seat, for any elastic pair: Legendre-Galerkin
/// solution of the Abel-transformed equation of
/// docs/internals/conforming_methods.md. One object per pair and loading;
/// copies share its tables. Const functions that do not allocate and do not
/// throw.
///
/// Axial symmetry, no friction, first order in the clearance; the outer body
/// is infinite unless it is given its walls. The load parameter is
/// mu = 3 R_n/(2 ebar rho1^2 E).
///
/// Accuracy (conforming/ball_test.cpp): with 16 unknowns the relative error of
/// 1/mu, times mu or 1 whichever is less, is below 1e-8 for theta0 <= 120 deg
/// and any pair, which is 1e-6 deg in theta0 at most; with 8 unknowns it is
/// below 1e-6. With walls: 1e-6 of the load down to 0.003 radii of thickness
/// (conforming/walls_test.cpp).
class BallContact {
 public:
  static constexpr int default_unknowns = 16;
  static constexpr int max_unknowns = 32;
  /// Limit for contacts with walls, whose edge may have a thin layer.
  static constexpr int max_walled_unknowns = 64;
  /// 175 deg.
  static constexpr double largest_half_angle = 3.0543261909900767;

  /// @param pair      elastic constants, ball inner
  /// @param loading   how the ball is loaded
  /// @param unknowns  truncation, [8, max_unknowns]
  /// @throws Error if unknowns is out of range.
  explicit BallContact(const ElasticPair& pair,
                       InnerLoading loading = InnerLoading::centre(),
                       int unknowns = default_unknowns);

  /// A ball or seat with layers. E in mu belongs to the two surfaces.
  /// @param unknowns  truncation, [8, max_walled_unknowns]; 0 for as many as
  ///                  the thickness asks for
  /// @throws Error if unknowns is out of range, or for a coated ball that is
  ///               loaded through the back, or for thin layers that hardly
  ///               yield between stiff bodies (docs/how-to/walls_matter.md).
  explicit BallContact(const LayeredPair& pair,
                       InnerLoading loading = InnerLoading::centre(),
                       int unknowns = 0);

  /// 1/mu: > 0 below the limit angle, 0 there, < 0 beyond.
  /// @param half_angle  theta0, rad, (0, largest()]; NaN outside
  double reciprocal_load(double half_angle) const noexcept;

  /// mu at theta0 in (0, limit], with an estimate of its error; mu = 0 at
  /// theta0 = 0.
  ExactLoad load_parameter(double half_angle) const noexcept;

  /// theta0 at mu in [0, infinity]. not_converged if theta0 exceeds
  /// largest().
  ExactHalfAngle half_angle(double load_parameter) const noexcept;

  /// theta0*, to which theta0 tends as the load grows.
  ExactHalfAngle limit_half_angle() const noexcept;

  /// Normal approach over the clearance, and stiffness in units of rho E, at
  /// theta0 in (0, largest()]; exact, by the solution at theta0 alone. NaN
  /// outside, and if loaded through the back.
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

  /// Pressure at theta0 in (0, largest()], in units of R_n/rho^2. Beyond the
  /// limit angle it is the pressure of a ball with interference.
  ///
  /// Accuracy: 5e-7 of the peak with 16 unknowns for theta0 <= 120 deg
  /// (conforming/ball_test.cpp).
  /// @param terms  sines of the expansion: 12 (up to 120 deg), 32 or 64; 0 for
  ///               terms()
  ContactPressure pressure(double half_angle, int terms = 0) const noexcept;

  /// Sines of pressure() unless told otherwise: 32, or 64 for thin walls.
  int terms() const noexcept;

  /// Largest theta0 of this object: largest_half_angle, and less than
  /// pi - psi when loaded from the back.
  double largest() const noexcept { return largest_; }

 private:
  struct Tables;
  struct Solution;
  struct Galerkin;

  void set_largest(InnerLoading loading);

  std::shared_ptr<const Tables> tables_;
  int unknowns_;
  double largest_;
};

}  // namespace contact
