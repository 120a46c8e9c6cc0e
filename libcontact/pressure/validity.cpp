#include "libcontact/pressure/validity.hpp"

#include <algorithm>

#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/fitted.hpp"

namespace contact {
namespace {

constexpr double megapascal = 1e6;

std::string peak_text(double peak, double limit) {
  return detail::message("peak pressure {:.4g} MPa is above {:.4g} MPa, ",
                         peak / megapascal, limit / megapascal);
}

}  // namespace

std::vector<std::string> contact_notes(JointKind kind, const ElasticPair& pair,
                                       double half_angle,
                                       double peak_pressure) {
  std::vector<std::string> notes;
  const double linear =
      largest_pressure_share *
      std::min(pair.inner().youngs_modulus, pair.outer().youngs_modulus);
  if (peak_pressure > linear) {
    notes.push_back(peak_text(peak_pressure, linear) +
                    detail::message("{:g} % of the smaller Young's modulus: "
                                    "linear elasticity does not hold",
                                    100 * largest_pressure_share));
  }
  for (const auto& [material, body] :
       {std::pair{&pair.inner(), "inner"}, std::pair{&pair.outer(), "outer"}}) {
    if (!(peak_pressure > material->limit_pressure)) continue;
    notes.push_back(
        peak_text(peak_pressure, material->limit_pressure) +
        detail::message("the limit pressure of the {} body{}", body,
                        material->name.empty() ? "" : ", " + material->name));
  }
  constexpr double fitted_error = 1e-3;
  const double limit = FittedLaw(kind, pair).limit_half_angle();
  if (half_angle > limit * (1 + fitted_error)) {
    notes.push_back(
        detail::message("half-angle {:.4g} deg is beyond {:.4g} deg, the limit "
                        "half-angle of these materials",
                        half_angle / degree, limit / degree));
  }
  return notes;
}

}  // namespace contact
