#include "libcontact/pressure/hertz.hpp"

#include <cmath>
#include <numbers>

namespace contact {

double hertz_peak_over_nominal(JointKind kind, double half_angle) noexcept {
  const double sine = std::sin(half_angle);
  return kind == JointKind::ball ? 1.5 / (sine * sine)
                                 : 4 / std::numbers::pi / sine;
}

double hertz_peak_pressure(const JointGeometry& geometry, double load,
                           double half_angle) noexcept {
  return hertz_peak_over_nominal(geometry.kind(), half_angle) *
         geometry.pressure_unit(load) /
         (geometry.kind() == JointKind::ball ? std::numbers::pi : 2);
}

}  // namespace contact
