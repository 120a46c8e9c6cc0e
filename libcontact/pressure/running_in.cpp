#include "libcontact/pressure/running_in.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/highest.hpp"
#include "libcontact/half_angle/worn.hpp"
#include "libcontact/pressure/expansion.hpp"
#include "libcontact/pressure/profile.hpp"

namespace contact {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

}  // namespace

RunningInPressure::RunningInPressure(std::shared_ptr<const PressureLaw> law,
                                     double wear_number)
    : PressureLaw(law->joint_kind(), law->made_for()),
      law_(std::move(law)),
      worn_(joint_kind()),
      wear_number_(wear_number) {
  detail::require(detail::is_not_negative(wear_number), "running-in pressure",
                  "wear_number", wear_number, "0 or above and finite");
}

double RunningInPressure::worn_share(double wear_number,
                                     double pressed) noexcept {
  constexpr double exponent = 1.8;
  constexpr double half = 2.8;
  if (wear_number == 0) return 0;
  // Without load rounding decides its sign.
  if (pressed <= 0) return 1;
  return 1 / (1 + half * std::pow(pressed / wear_number, exponent));
}

double RunningInPressure::share(double half_angle) const noexcept {
  if (wear_number_ == 0) return 0;
  if (half_angle == right_angle) return 0;  // g is infinite
  return worn_share(
      wear_number_,
      WornHalfAngle::overlap(joint_kind(), half_angle) - wear_number_);
}

double RunningInPressure::largest_half_angle() const noexcept {
  if (wear_number_ == 0) return law_->largest_half_angle();
  return std::min(law_->largest_half_angle(), worn_.largest_half_angle());
}

double RunningInPressure::pressure(double theta,
                                   double half_angle) const noexcept {
  return mixed(share(half_angle), law_->pressure(theta, half_angle),
               worn_.pressure(theta, half_angle));
}

double RunningInPressure::slope(double theta,
                                double half_angle) const noexcept {
  return mixed(share(half_angle), law_->slope(theta, half_angle),
               worn_.slope(theta, half_angle));
}

void RunningInPressure::edge_slopes(double half_angle,
                                    std::span<const double> edge_variable,
                                    std::span<double> out) const noexcept {
  law_->edge_slopes(half_angle, edge_variable, out);
  const double s = share(half_angle);
  for (std::size_t i = 0; i < out.size(); ++i) {
    double worn = 0;
    worn_.edge_slopes(half_angle, edge_variable.subspan(i, 1), {&worn, 1});
    out[i] = mixed(s, out[i], worn);
  }
}

double RunningInPressure::peak(double half_angle) const noexcept {
  const detail::PressureProfile profile(*this, half_angle);
  if (profile.falls_outwards()) {
    return mixed(share(half_angle), law_->peak(half_angle),
                 worn_.peak(half_angle));
  }
  return profile.pressure(detail::highest(
      [&](double theta) { return profile.pressure(theta); }, half_angle));
}

double RunningInPressure::force_ratio(double half_angle) const noexcept {
  return mixed(share(half_angle), law_->force_ratio(half_angle),
               worn_.force_ratio(half_angle));
}

PressureExpansion RunningInPressure::expansion(
    double half_angle) const noexcept {
  PressureExpansion sum = detail::expansion_of(*law_, half_angle);
  if (sum.is_empty()) return sum;
  const PressureExpansion worn = detail::expansion_of(worn_, half_angle);
  const double s = share(half_angle);
  sum.cosine_share = mixed(s, sum.cosine_share, worn.cosine_share);
  sum.edge_pressure = mixed(s, sum.edge_pressure, worn.edge_pressure);
  for (double& coefficient : sum.coefficient) {
    coefficient = mixed(s, coefficient, 0);
  }
  for (double& coefficient : sum.logarithmic) {
    coefficient = mixed(s, coefficient, 0);
  }
  return sum;
}

}  // namespace contact
