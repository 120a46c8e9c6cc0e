#include "libcontact/base/units.hpp"

#include <cmath>

namespace contact {

SineCosine detail::sine_cosine_deg(double angle_deg) {
  int quadrant = 0;
  // remquo is exact: |rest| <= 45 degrees carries every digit of the input.
  const double rest = std::remquo(angle_deg, 90.0, &quadrant);
  const double s = std::sin(rest * degree);
  const double c = std::cos(rest * degree);
  // The + 0.0 turns -0 into +0.
  switch (quadrant & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s + 0.0};
    case 2:
      return {-s + 0.0, -c};
    default:
      return {-c, s};
  }
}

}  // namespace contact
