#pragma once

#include "libcontact/pressure/law.hpp"

/// Pressures that start from the edge like a square root, as exact ones do.
namespace contact {

/// p = peak sqrt(1 - tan^2(theta/2)/tan^2(theta0/2)), for
/// 0 <= theta0 <= 175 deg. Hertz' pressure as theta0 -> 0.
///
/// With h = sin(theta0/2), c = cos(theta0/2), q = tan(theta0/4) and
/// M_n = ∫ x^2/(1 - h^2 x^2)^n dx over [0, 1]:
///
/// | | ball | pin |
/// |---|---|---|
/// | 1/peak | 8 pi h^2 c^2 (2 c^2 M_3 - M_2) | 2 pi q c |
/// | S | M_2/(2 c^2 M_3 - M_2) | 1/c |
///
/// Accuracy: relative error at most 1e-14 for theta0 from 1e-150 rad to
/// 150 deg (pressure/cosine_test.cpp, against quadrature in high precision).
class SqrtTanPressure final : public PressureLaw {
 public:
  explicit SqrtTanPressure(JointKind kind) : PressureLaw(kind) {}

  std::string name() const override { return "sqrt_tan"; }
  double pressure(double theta, double half_angle) const noexcept override;
  double slope(double theta, double half_angle) const noexcept override;
  void edge_slopes(double half_angle, std::span<const double> edge_variable,
                   std::span<double> out) const noexcept override;
  double peak(double half_angle) const noexcept override;
  double force_ratio(double half_angle) const noexcept override;
  double largest_half_angle() const noexcept override;

 private:
  PressureExpansion expansion(double half_angle) const noexcept override;
};

/// p = peak sqrt(1 - (theta/theta0)^2), for 0 <= theta0 <= 175 deg. Hertz'
/// pressure as theta0 -> 0.
///
/// With Struve's function H_1 and Bessel's J_1:
///
/// | | ball | pin |
/// |---|---|---|
/// | 1/peak | (pi^2/4) H_1(2 theta0) | pi J_1(theta0) |
/// | S | 4 H_1(theta0)/H_1(2 theta0) | theta0/(2 J_1(theta0)) |
///
/// Accuracy: relative error at most 1e-14 for theta0 from 1e-150 rad to
/// 150 deg (pressure/cosine_test.cpp, against quadrature in high precision).
class SqrtThetaPressure final : public PressureLaw {
 public:
  explicit SqrtThetaPressure(JointKind kind) : PressureLaw(kind) {}

  std::string name() const override { return "sqrt_theta"; }
  double pressure(double theta, double half_angle) const noexcept override;
  double slope(double theta, double half_angle) const noexcept override;
  void edge_slopes(double half_angle, std::span<const double> edge_variable,
                   std::span<double> out) const noexcept override;
  double peak(double half_angle) const noexcept override;
  double force_ratio(double half_angle) const noexcept override;
  double largest_half_angle() const noexcept override;

 private:
  PressureExpansion expansion(double half_angle) const noexcept override;
};

}  // namespace contact
