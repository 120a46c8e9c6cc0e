// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>

#include "libcontact/pair/contact_conditions.hpp"
#include "libcontact/pair/joint_geometry.hpp"

/// Contact pressure p(theta), theta = angle from the centre of the contact.
///
/// Every pressure here is in JointGeometry::pressure_unit(): R_n/rho^2 for a
/// ball, P/rho for a pin; so it depends on the half-angle theta0 alone.
namespace contact {

class PressureLaw;
struct PressureExpansion;
namespace detail {
PressureExpansion expansion_of(const PressureLaw&, double half_angle) noexcept;
bool harmonics_of(const PressureLaw&, double half_angle,
                  std::span<double> out) noexcept;
}  // namespace detail

/// A pressure law for one kind of joint; one's own is a ShapedPressure
/// (shaped.hpp). Const functions that do not allocate
/// and do not throw; NaN gives NaN.
///
/// Every law is normalised to carry the load,
///
///     ball:  2 pi ∫ p cos t sin t dt = 1,  0 <= t <= theta0          (3.2)
///     pin:        ∫ p cos t dt = 1,  -theta0 <= t <= theta0
///
/// and all but the worn pressure vanish at the edge. The variable in which all
/// laws are smooth up to the edge is the edge variable
///
///     x = sqrt(1 - tan^2(theta/2)/tan^2(theta0/2)),
///
/// 0 at the edge and 1 at the centre.
class PressureLaw {
 public:
  virtual ~PressureLaw() = default;

  /// Name by which make_pressure_law() (factory.hpp) makes it.
  virtual std::string name() const = 0;

  /// p(theta), pressure units; 0 outside the contact.
  /// @param theta       angle from the contact's centre, rad; even in it
  /// @param half_angle  theta0, rad, [0, largest_half_angle()]; NaN outside
  virtual double pressure(double theta, double half_angle) const noexcept = 0;

  /// -dp/dtheta, pressure units per rad; odd in theta, 0 outside the contact.
  /// >= 0 for theta in [0, theta0], but where thin walls move the peak
  /// outwards. Infinite at the edge where the law starts like a square root.
  virtual double slope(double theta, double half_angle) const noexcept = 0;

  /// dp/dx of the edge variable at many points of one contact; finite. Over
  /// [0, 1] they add up to p(0) less the pressure at the edge.
  /// @param half_angle  theta0, rad, (0, largest_half_angle()]
  /// @param edge_variable  x, [0, 1]
  /// @param out         as many slopes
  virtual void edge_slopes(double half_angle,
                           std::span<const double> edge_variable,
                           std::span<double> out) const noexcept = 0;

  /// The largest pressure, p(0) but under thin walls; infinite at theta0 = 0.
  virtual double peak(double half_angle) const noexcept = 0;

  /// S = ∫ p dS / R_n (ball), ∫ p rho dt / P (pin): how much larger the sum of
  /// pressures is than the force they carry; 1 at theta0 = 0.
  virtual double force_ratio(double half_angle) const noexcept = 0;

  /// Largest theta0 for which the law is defined, rad.
  virtual double largest_half_angle() const noexcept = 0;

  /// Largest theta0 of joints with interference, rad: largest_half_angle(), or
  /// pi of a law that follows them until they close all round. Between the two
  /// it has pressure(), peak(), force_ratio() and friction integrals.
  virtual double closing_half_angle() const noexcept {
    return largest_half_angle();
  }

  /// Mean of p over the contact: S over its area in units of rho^2,
  /// 4 pi sin^2(theta0/2) (ball) or 2 theta0 (pin). Infinite at theta0 = 0.
  double mean(double half_angle) const noexcept;

  JointKind joint_kind() const noexcept { return kind_; }
  /// The joints that it is for; none if it is for all.
  const std::optional<MadeFor>& made_for() const noexcept { return made_for_; }

 protected:
  explicit PressureLaw(JointKind kind, std::optional<MadeFor> made_for = {})
      : kind_(kind), made_for_(std::move(made_for)) {}

  bool has(double half_angle) const noexcept {
    return half_angle >= 0 && half_angle <= largest_half_angle();
  }

 private:
  friend PressureExpansion detail::expansion_of(const PressureLaw&,
                                                double) noexcept;
  friend bool detail::harmonics_of(const PressureLaw&, double,
                                   std::span<double>) noexcept;
  /// p_n/p_1 of a ball, n < out.size(), where friction is by them; false
  /// elsewhere.
  virtual bool harmonics(double half_angle,
                         std::span<double> out) const noexcept;
  /// Expansion that makes the friction integrals of our own laws fast
  /// (pressure/expansion.hpp, which is not installed). Here there is none:
  /// friction follows from edge_slopes().
  virtual PressureExpansion expansion(double half_angle) const noexcept;

  JointKind kind_;
  std::optional<MadeFor> made_for_;
};

}  // namespace contact
