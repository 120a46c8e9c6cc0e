#include "pressure/joint_approach.hpp"

namespace hinge_pressure {
namespace {

using contact::BallContact;
using contact::PinContact;

template <class Contact>
Contact make(const cli::Joint& joint) {
  const auto& [loading, walls] = joint.conditions;
  return walls ? Contact(*walls, loading) : Contact(joint.pair, loading);
}

std::variant<BallContact, PinContact> contact_of(const cli::Joint& joint) {
  if (joint.kind == contact::JointKind::ball) {
    return make<BallContact>(joint);
  }
  return make<PinContact>(joint);
}

}  // namespace

JointApproach::JointApproach(const cli::Joint& joint)
    : contact_(contact_of(joint)),
      length_unit_(joint.geometry->radial_clearance()),
      stiffness_unit_(joint.pair.effective_modulus() *
                      (joint.kind == contact::JointKind::ball
                           ? joint.geometry->radius()
                           : 1)) {}

JointApproach::Value JointApproach::operator()(double half_angle) const {
  const contact::ContactApproach value = std::visit(
      [&](const auto& contact) { return contact.approach(half_angle); },
      contact_);
  return {value.approach * length_unit_, value.stiffness * stiffness_unit_};
}

}  // namespace hinge_pressure
