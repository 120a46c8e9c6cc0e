#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "libcontact/conforming/contact_pressure.hpp"
#include "libcontact/conforming/loading.hpp"
#include "libcontact/material.hpp"
#include "libcontact/pressure.hpp"

namespace contact {

/// The pressure of the exact conforming contact (PinContact, BallContact) of
/// one elastic pair, for any half-angle:
///
///     p = sum a_k sin((2k+1) phi),  x = sin(phi) the edge variable,
///
/// with the a_k, times 2 sin(theta0/2) (pin) or its square (ball), as
/// Chebyshev series in theta0 (pin) or sqrt(theta0) (ball). The constructor
/// solves the contact at 28 half-angles or more, some milliseconds for a ball:
/// make one law per joint. Threads may share one.
///
/// Accuracy (pressure_family_test.cpp), theta0 <= 120 deg: within 5e-6 of the
/// peak of the solver's own pressure, which the logarithm at the edge of
/// unlike materials costs (3e-8 for equal ones); S within 1e-7. The load is
/// carried to 2e-12.
///
/// Half-angles beyond the pair's limit half-angle, which other half-angle laws
/// may ask for, belong to a ball or pin with interference. The largest is
/// 120 deg, or the limit half-angle up to 150 deg where that is larger, or
/// where the solver ends if that is less.
class ExactPressure final : public PressureLaw {
 public:
  /// @param loading  how the inner body is loaded; the force at its centre
  ///                 unless told otherwise
  ExactPressure(JointKind kind, const ElasticPair& pair,
                InnerLoading loading = InnerLoading::centre());

  std::string name() const override { return "exact"; }
  double pressure(double theta, double half_angle) const noexcept override;
  double slope(double theta, double half_angle) const noexcept override;
  void edge_slopes(double half_angle, std::span<const double> edge_variable,
                   std::span<double> out) const noexcept override;
  PressureExpansion expansion(double half_angle) const noexcept override;
  double peak(double half_angle) const noexcept override;
  double force_ratio(double half_angle) const noexcept override;
  double largest_half_angle() const noexcept override { return largest_; }

  /// The whole pressure at one half-angle: cheaper than many pressure().
  ContactPressure contact(double half_angle) const noexcept;

 private:
  /// Terms of p in phi.
  static constexpr int terms = PressureExpansion::max_terms;
  /// The a_k, times 2 sin(theta0/2) or its square, and S.
  using Column = std::array<double, terms + 1>;

  template <class Contact>
  void tabulate(const Contact& contact);
  Column evaluate(double half_angle) const noexcept;
  template <std::size_t size>
  void chebyshev_sum(const std::vector<std::array<double, size>>& series,
                     double half_angle,
                     std::array<double, size>& sum) const noexcept;
  double in_pressure_units(double value, double half_angle) const noexcept;

  double largest_;
  int size_ = 0;  // terms that count
  std::vector<Column> series_;
  std::vector<std::array<double, terms>> polynomials_;  // of expansion()
};

}  // namespace contact
