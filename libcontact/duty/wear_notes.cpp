#include "libcontact/duty/wear_map.hpp"

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/duty/wear_check.hpp"

namespace contact {

void detail::check_depth(double depth, double cycles,
                         const JointGeometry& geometry) {
  const double largest = geometry.radius();
  // False of NaN too, for wear beyond all numbers.
  if (depth <= largest) return;
  throw Error(
      must_be(message("the depth of the wear after {:.4g} cycles", cycles),
              message("at most {:.4g} mm, the radius", 1e3 * largest)));
}

std::string WearMap::coefficient_note(double coefficient) {
  constexpr double unit = 1e-9;  // 1 mm^3/(N m), m^2/N
  constexpr double least = 1e-10;
  constexpr double largest = 1e-3;
  const double k = coefficient / unit;
  // Rounding of the unit.
  constexpr double rounding = 1e-12;
  if (k == 0 || (k >= least * (1 - rounding) && k <= largest * (1 + rounding)))
    return {};
  return detail::message(
      "the wear coefficient {:.4g} mm^3/(N m), {:.4g} m^2/N, is outside the "
      "range of bearings, {:g} to {:g} mm^3/(N m)",
      k, coefficient, least, largest);
}

std::string WearMap::depth_note(double depth, const JointGeometry& geometry) {
  constexpr double share = 0.1;
  if (!(depth > share * geometry.radius())) return {};
  return detail::message(
      "wear {:.4g} mm deep is more than a tenth of the radius, {:.4g} mm: the "
      "surfaces no longer conform, and their contact is outside the theory",
      1e3 * depth, 1e3 * geometry.radius());
}

}  // namespace contact
