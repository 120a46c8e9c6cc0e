#include "libcontact/joint/thrust_face.hpp"

#include <cmath>
#include <numbers>

#include "libcontact/base/check.hpp"
#include "libcontact/base/text.hpp"

namespace contact {

ThrustFace::ThrustFace(double inner_radius, double outer_radius,
                       FrictionLaw friction)
    : inner_radius_(inner_radius),
      outer_radius_(outer_radius),
      friction_(friction) {
  constexpr const char* place = "thrust face";
  detail::require(detail::is_above_zero(outer_radius), place, "outer_radius",
                  outer_radius, "above 0 m and finite");
  detail::require(
      inner_radius >= 0 && inner_radius < outer_radius, place, "inner_radius",
      inner_radius,
      detail::message("0 m or above, below outer_radius = {} m", outer_radius));
  // (ro^3 - ri^3)/(ro^2 - ri^2), without the difference.
  const double sum = inner_radius + outer_radius;
  const double cubes = sum * sum - inner_radius * outer_radius;
  arm_ = 2.0 / 3 * cubes / sum;
  adhesion_moment_ = friction_.adhesion() * 2 * std::numbers::pi / 3 * cubes *
                     (outer_radius - inner_radius);
}

double ThrustFace::moment(double force) const noexcept {
  if (force == 0) return 0;
  return friction_.coefficient() * std::abs(force) * arm_ + adhesion_moment_;
}

}  // namespace contact
