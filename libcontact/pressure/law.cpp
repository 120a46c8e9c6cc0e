#include "libcontact/pressure/law.hpp"

#include <cmath>
#include <numbers>

#include "libcontact/pressure/expansion.hpp"

namespace contact {

PressureExpansion detail::expansion_of(const PressureLaw& law,
                                       double half_angle) noexcept {
  return law.expansion(half_angle);
}

PressureExpansion PressureLaw::expansion(double) const noexcept { return {}; }

bool detail::harmonics_of(const PressureLaw& law, double half_angle,
                          std::span<double> out) noexcept {
  return law.harmonics(half_angle, out);
}

bool PressureLaw::harmonics(double, std::span<double>) const noexcept {
  return false;
}

double PressureLaw::mean(double half_angle) const noexcept {
  const double force = force_ratio(half_angle);
  if (kind_ == JointKind::pin) return force / (2 * half_angle);
  const double h = std::sin(half_angle / 2);
  return force / (4 * std::numbers::pi) / h / h;
}

}  // namespace contact
