#include "libcontact/duty/worn_sliding.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/friction/special.hpp"

namespace contact {

double worn_in_sliding_coefficient(double half_angle) {
  if (half_angle == 0) return 1;
  if (half_angle > std::numbers::pi / 2) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const FrictionTriple area = sliding_friction_integrals(half_angle).area;
  const double s = std::sin(half_angle);
  return 2 * std::numbers::pi * s * s /
         (area.sliding + std::cos(half_angle) * area.force);
}

}  // namespace contact
