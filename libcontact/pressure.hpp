#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"
#include "libcontact/pressure_expansion.hpp"

/// Contact pressure p(theta), theta = angle from the centre of the contact.
///
/// Every pressure here is in JointGeometry::pressure_unit(): R_n/rho^2 for a
/// ball, P/rho for a pin; so it depends on the half-angle theta0 alone.
namespace contact {

/// A pressure law for one kind of joint. Const functions that do not allocate
/// and do not throw; NaN gives NaN.
///
/// Every law is normalised to carry the load,
///
///     ball:  2 pi ∫ p cos t sin t dt = 1,  0 <= t <= theta0          (3.2)
///     pin:        ∫ p cos t dt = 1,  -theta0 <= t <= theta0
///
/// and vanishes at the edge. The variable in which all laws are smooth
/// up to the edge is the edge variable
///
///     x = sqrt(1 - tan^2(theta/2)/tan^2(theta0/2)),
///
/// 0 at the edge and 1 at the centre.
class PressureLaw {
 public:
  virtual ~PressureLaw() = default;

  /// Name by which make_pressure_law() makes it.
  virtual std::string name() const = 0;

  /// p(theta), pressure units; 0 outside the contact.
  /// @param theta       angle from the contact's centre, rad; even in it
  /// @param half_angle  theta0, rad, [0, largest_half_angle()]; NaN outside
  virtual double pressure(double theta, double half_angle) const noexcept = 0;

  /// -dp/dtheta, pressure units per rad, >= 0 for theta in [0, theta0]; odd in
  /// theta, 0 outside the contact. Infinite at the edge where the law starts
  /// like a square root.
  virtual double slope(double theta, double half_angle) const noexcept = 0;

  /// dp/dx of the edge variable at many points of one contact; finite.
  /// @param half_angle  theta0, rad, (0, largest_half_angle()]
  /// @param edge_variable  x, [0, 1]
  /// @param out         as many slopes
  virtual void edge_slopes(double half_angle,
                           std::span<const double> edge_variable,
                           std::span<double> out) const noexcept = 0;

  /// p as the friction integrals take it, for every half-angle; NaN beyond
  /// largest_half_angle() and where theta0 is NaN.
  virtual PressureExpansion expansion(double half_angle) const noexcept = 0;

  /// p(0), the largest pressure; infinite at theta0 = 0.
  virtual double peak(double half_angle) const noexcept = 0;

  /// S = ∫ p dS / R_n (ball), ∫ p rho dt / P (pin): how much larger the sum of
  /// pressures is than the force they carry; 1 at theta0 = 0.
  virtual double force_ratio(double half_angle) const noexcept = 0;

  /// Largest theta0 for which the law is defined, rad.
  virtual double largest_half_angle() const noexcept = 0;

  /// Mean of p over the contact: S over its area in units of rho^2,
  /// 4 pi sin^2(theta0/2) (ball) or 2 theta0 (pin). Infinite at theta0 = 0.
  double mean(double half_angle) const noexcept;

  JointKind joint_kind() const noexcept { return kind_; }

 protected:
  explicit PressureLaw(JointKind kind) : kind_(kind) {}

  bool has(double half_angle) const noexcept {
    return half_angle >= 0 && half_angle <= largest_half_angle();
  }

 private:
  JointKind kind_;
};

/// p = p0 (cos theta - cos theta0) (3.3), for 0 <= theta0 <= pi.
///
/// p0 is the amplitude; the peak pressure is p0 (1 - cos theta0), 263 times
/// less at theta0 = 5 deg (the paper calls p0 the peak).
/// With h = sin(theta0/2), c = cos theta0, s = sin theta0:
///
/// | | ball | pin |
/// |---|---|---|
/// | 1/p0 = I_n | (pi/3)(1 - c)^2 (2 + c) | theta0 - s c |
/// | peak | 3/(2 pi h^2 (2 + c)) | 2 h^2/(theta0 - s c) |
/// | S | 3/(2 + c) | 2 (s - theta0 c)/(theta0 - s c) |
///
/// Accuracy: relative error at most 1e-15 for theta0 from 1e-150 rad to
/// 170 deg, 2e-15 for pressure(), at any theta inside (pressure_test.cpp,
/// against the formulas in high precision). slope() overflows to infinity
/// below 1e-102 rad.
class CosinePressure final : public PressureLaw {
 public:
  explicit CosinePressure(JointKind kind) : PressureLaw(kind) {}

  std::string name() const override { return "cosine"; }
  double pressure(double theta, double half_angle) const noexcept override;
  double slope(double theta, double half_angle) const noexcept override;
  void edge_slopes(double half_angle, std::span<const double> edge_variable,
                   std::span<double> out) const noexcept override;
  PressureExpansion expansion(double half_angle) const noexcept override;
  double peak(double half_angle) const noexcept override;
  double force_ratio(double half_angle) const noexcept override;
  double largest_half_angle() const noexcept override;
};

/// I_n of the cosine pressure: the force that p0 = 1 carries, in units of
/// rho^2 (ball) or rho (pin).
///
///     ball: (pi/3)(1 - c)^2 (2 + c),  (pi/4) theta0^4 as theta0 -> 0 (3.4)
///     pin:  theta0 - sin theta0 cos theta0,  (2/3) theta0^3
///
/// @param half_angle  theta0, rad, [0, pi]; NaN outside
/// @return relative error at most 1e-15 (pressure_test.cpp) while the result
///         is a normal number.
double cosine_normal_integral(JointKind kind, double half_angle);

/// The law of joints and programs that name none.
inline constexpr std::string_view default_pressure_law = "cosine";

/// Names that make_pressure_law() knows: cosine, sqrt_tan, sqrt_theta,
/// mixture, exact.
const std::vector<std::string>& pressure_law_names();

/// Whether the law of this name may be taken for this loading of the inner
/// body. Through the back all but mixture, which is fitted to contacts under
/// a force at the centre; cosine, sqrt_tan and sqrt_theta are plain shapes,
/// the same for any pair and loading.
bool pressure_law_allows(std::string_view name, const InnerLoading& loading);

/// A law by its name.
/// @param pair  elastic constants, which mixture and exact depend on
/// @param loading  how the inner body is loaded, on which exact depends
/// @throws Error if the name is not known or the law is not for this loading.
std::unique_ptr<PressureLaw> make_pressure_law(
    std::string_view name, JointKind kind, const ElasticPair& pair,
    const InnerLoading& loading = InnerLoading::centre());

}  // namespace contact
