#include "libcontact/joint/presliding/stiction.hpp"

#include <variant>

#include "libcontact/base/constants.hpp"

namespace contact {

double stiction_deformation(const JointContact& contact, double normal_force,
                            double half_angle) noexcept {
  const auto* dry = std::get_if<FrictionLaw>(&contact.friction());
  if (dry == nullptr || contact.has_interference()) return detail::nan;
  return dry->coefficient() * contact.shift(normal_force, half_angle);
}

}  // namespace contact
