#pragma once

#include <memory>
#include <span>
#include <string>

#include "libcontact/pressure/law.hpp"
#include "libcontact/pressure/worn.hpp"

namespace contact {

/// The pressure of a joint whose seat or hole wears, the partner of
/// WornHalfAngle: at the half-angle theta0 of the worn joint
///
///     p = (1 - s) p[law] + s p[worn],  s = x^1.8/(2.8 + x^1.8),
///     x = v/(g(theta0) - v),
///
/// with the law of the joint before wear and WornPressure. x compares the worn
/// depth with the elastic one, so that the pressure changes from the law at v =
/// 0 to the worn one. Both carry the load, and so does p; friction integrals
/// mix likewise.
///
/// Accuracy: s is a fit to pins and balls that wear step by step, unworn
/// half-angles 10 to 40 deg, and within 0.02 of them. docs/how-to/duty.md has
/// the error of the peak that is left. Within 1e-14 of the two laws
/// (pressure/running_in_test.cpp).
class RunningInPressure final : public PressureLaw {
 public:
  /// @param law          of the joint before wear
  /// @param wear_number  v, [0, infinity)
  /// @throws Error if v is out of range.
  RunningInPressure(std::shared_ptr<const PressureLaw> law, double wear_number);

  /// s of v and g(theta0) - v; 1 where that is not above 0.
  static double worn_share(double wear_number, double pressed) noexcept;
  /// s at theta0.
  double share(double half_angle) const noexcept;
  /// (1 - s) of_law + s of_worn; a part without a share may be infinite.
  static double mixed(double s, double of_law, double of_worn) noexcept {
    if (s == 0) return of_law;
    return s == 1 ? of_worn : (1 - s) * of_law + s * of_worn;
  }
  const PressureLaw& law() const { return *law_; }
  const WornPressure& worn() const { return worn_; }

  std::string name() const override { return law_->name() + "_worn"; }
  double pressure(double theta, double half_angle) const noexcept override;
  double slope(double theta, double half_angle) const noexcept override;
  void edge_slopes(double half_angle, std::span<const double> edge_variable,
                   std::span<double> out) const noexcept override;
  double peak(double half_angle) const noexcept override;
  double force_ratio(double half_angle) const noexcept override;
  /// Limit of the law; with wear at most 90 deg.
  double largest_half_angle() const noexcept override;

 private:
  PressureExpansion expansion(double half_angle) const noexcept override;

  std::shared_ptr<const PressureLaw> law_;
  WornPressure worn_;
  double wear_number_;
};

}  // namespace contact
