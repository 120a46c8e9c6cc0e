#include "pressure/joint_approach.hpp"

namespace hinge_pressure {
namespace {

using contact::BallContact;
using contact::PinContact;

template <class Contact>
Contact make(const hinge_angle::Setup& setup) {
  const auto& [loading, walls] = setup.conditions;
  return walls ? Contact(*walls, loading) : Contact(setup.pair, loading);
}

std::variant<BallContact, PinContact> contact_of(
    const hinge_angle::Setup& setup) {
  if (setup.kind == contact::JointKind::ball) {
    return make<BallContact>(setup);
  }
  return make<PinContact>(setup);
}

}  // namespace

JointApproach::JointApproach(const hinge_angle::Setup& setup)
    : contact_(contact_of(setup)),
      length_unit_(setup.geometry->radial_clearance()),
      stiffness_unit_(setup.pair.effective_modulus() *
                      (setup.kind == contact::JointKind::ball
                           ? setup.geometry->radius()
                           : 1)) {}

JointApproach::Value JointApproach::operator()(double half_angle) const {
  const contact::ContactApproach value = std::visit(
      [&](const auto& contact) { return contact.approach(half_angle); },
      contact_);
  return {value.approach * length_unit_, value.stiffness * stiffness_unit_};
}

}  // namespace hinge_pressure
