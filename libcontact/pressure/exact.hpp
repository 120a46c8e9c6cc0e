#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libcontact/conforming/contact_pressure.hpp"
#include "libcontact/conforming/half_angle_variable.hpp"
#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/material.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/pressure/law.hpp"

namespace contact {

namespace detail {
class LiftedPressure;
}

/// The pressure of the exact conforming contact (PinContact, BallContact) of
/// one elastic pair, for any half-angle: the expansion of ContactPressure,
///
///     p = sum a_k sin((2k+1) phi) + x^3 ln x sum b_k x^(2k),  x = sin(phi),
///
/// with the a_k and b_k, times 2 sin(theta0/2) (pin) or its square (ball), as
/// Chebyshev series in theta0 (pin) or sqrt(theta0) (ball). The constructor
/// solves the contact at 28 half-angles or more, a millisecond or two for a
/// ball: joints that are alike share one, threads may.
///
/// Accuracy (pressure/family_test.cpp): within 5e-8 of the peak of the
/// solver's own pressure for theta0 <= 120 deg, 2e-7 up to the largest; S
/// within 1e-8 and 1e-7. The load is carried to 1e-12.
///
/// Half-angles beyond the pair's limit half-angle, which other half-angle laws
/// may ask for, belong to a ball or pin with interference. The largest is the
/// limit half-angle, or 120 deg where that is larger, or where the solver
/// ends if that is less. Beyond it, up to 180 deg, contacts of interference
/// have a table of their own (LiftedPressure, closing_half_angle()), which the
/// first of them makes by 24 or 48 solutions; any thread. Within 1e-6 of the
/// peak, S and p(0) 1e-7, below 0.1 radii of wall 5e-6
/// (pressure/interference_test.cpp). There peak() is p(0), also under rings
/// that are free outside, a slope costs a hundred pressures, and edge_slopes()
/// are NaN: friction is by harmonics.
class ExactPressure final : public PressureLaw {
 public:
  /// @param loading  how the inner body is loaded; the force at its centre
  ///                 unless told otherwise
  ExactPressure(JointKind kind, const ElasticPair& pair,
                InnerLoading loading = InnerLoading::centre());

  /// Pressure of a joint with walls: within 1e-6 of the peak of the solver's
  /// own pressure (pressure/walls_test.cpp). expansion() has the first 32 sines
  /// of 32 or 64; rings thinner than 0.045 radii that are free outside have
  /// none, they need all 64. The constructor solves the contact at 64
  /// half-angles.
  /// @throws Error for a coated inner body that is loaded through the back.
  ExactPressure(JointKind kind, const LayeredPair& pair,
                InnerLoading loading = InnerLoading::centre());

  std::string name() const override { return "exact"; }
  double pressure(double theta, double half_angle) const noexcept override;
  double slope(double theta, double half_angle) const noexcept override;
  void edge_slopes(double half_angle, std::span<const double> edge_variable,
                   std::span<double> out) const noexcept override;
  double peak(double half_angle) const noexcept override;
  double force_ratio(double half_angle) const noexcept override;
  double largest_half_angle() const noexcept override { return largest_; }
  double closing_half_angle() const noexcept override;
  ~ExactPressure() override;

  /// The whole pressure at one half-angle: cheaper than many pressure().
  ContactPressure contact(double half_angle) const noexcept;
  bool has_walls() const { return variable_->has_walls(); }

 private:
  void set_interference(const LayeredPair& pair, const InnerLoading& loading);
  const detail::LiftedPressure* lifted() const noexcept;
  /// Whether the other table has a half-angle.
  bool is_lifted(double half_angle) const noexcept {
    return half_angle > largest_ && half_angle <= std::numbers::pi && lifted();
  }
  bool harmonics(double half_angle,
                 std::span<double> out) const noexcept override;
  PressureExpansion expansion(double half_angle) const noexcept override;
  static constexpr int logarithms = ContactPressure::logarithms;
  // a_k, b_k, S and some more.
  static constexpr int max_width = 72;
  static_assert(max_width >= ContactPressure::max_terms + logarithms + 1);
  using Column = std::array<double, max_width>;
  /// Chebyshev series of several functions of theta0, one row a degree.
  class Series {
   public:
    Series() = default;
    /// @param values  of the functions, in columns, at the points of
    ///                chebyshev_half_angle()
    explicit Series(const Eigen::MatrixXd& values);
    /// At v in [-1, 1].
    Column evaluate(double v) const;

   private:
    static constexpr int most_rows = 96;
    int width_ = 0;
    std::vector<Column> rows_;
  };
  template <class Contact>
  void tabulate(const Contact& contact, double end, double thickness);
  template <class Contact>
  void tabulate(const Contact& contact, const LayeredPair& pair);
  void tabulate_expansion();
  /// Point i of Chebyshev's rule in the variable of the series.
  double chebyshev_half_angle(int i, int count) const noexcept;
  double chebyshev_variable(double half_angle) const noexcept;
  Column evaluate(double half_angle) const noexcept;
  double centre(double half_angle) const noexcept;
  double in_pressure_units(double value, double half_angle) const noexcept;

  double largest_;
  // Pair of the second table; none without interference.
  std::optional<LayeredPair> interference_;
  mutable std::once_flag lifted_asked_;
  mutable std::unique_ptr<const detail::LiftedPressure> lifted_;
  std::optional<detail::HalfAngleVariable> variable_;
  int terms_ = 0;
  int expansion_size_ = 1;  // terms that count; 0: more than there may be
  Series contact_;          // a_k, b_k, S
  Series expansion_;        // b_k, c_k of expansion()
};

}  // namespace contact
