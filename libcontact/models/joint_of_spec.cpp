#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/finite_pin/slices_model.hpp"
#include "libcontact/joint/contact_model.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/spec.hpp"
#include "libcontact/seat/seat_model.hpp"

// The contact model that a spec asks for.
namespace contact {
namespace {

using detail::needs;

constexpr const char* confined = "a joint in a seat that ends";

void check(const JointSpec& joint) {
  if (joint.friction &&
      std::holds_alternative<FrictionStress>(*joint.friction)) {
    throw Error(needs(confined,
                      "dry or viscous friction, or without_seat (left_out = "
                      "true in its [seat])"));
  }
  for (const std::string& law : {joint.half_angle_law, joint.pressure_law}) {
    if (!law.empty() && law != "exact") {
      throw Error(needs(confined, "the laws exact, or without_seat"));
    }
  }
}

// Grids depend on bodies, size and seat alone.
JointSpec without_friction(JointSpec joint) {
  joint.name = {};
  joint.friction = {};
  joint.relief = Relief::none();
  joint.half_angle_law = joint.pressure_law = {};
  joint.half_angle_options = {};
  return joint;
}

bool has_relief(const JointSpec& joint) {
  return joint.relief.kind() != Relief::Kind::none;
}

// The contact without end. A relief that the joint has is none of its notes;
// one that no slices have is, with the reason.
JointContact endless_contact(const JointSpec& joint, SharedLaws& laws) {
  if (!has_relief(joint)) return joint.contact(laws);
  JointContact contact = joint.without_relief().contact(laws);
  if (const std::string why = FinitePin::refusal(joint); !why.empty()) {
    contact.add_validity_note("the relief of the ends is ignored: " + why);
  }
  return contact;
}

std::shared_ptr<const detail::ContactModel> tilted_model(
    const JointSpec& joint, const JointContact& contact) {
  if (!FinitePin::refusal(joint).empty()) return nullptr;
  return std::make_shared<const detail::SlicesModel>(joint, contact);
}

std::shared_ptr<const detail::ContactModel> seat_model(const JointSpec& joint,
                                                       SharedLaws& laws) {
  if (!joint.geometry.seat()) return nullptr;
  check(joint);
  JointSpec endless = joint.without_seat();
  endless.half_angle_law = joint.half_angle_law_name();
  return std::make_shared<const detail::SeatModel>(
      joint, laws.seat(joint), Joint(endless.contact(laws)));
}

}  // namespace

std::shared_ptr<const detail::SeatGrids> SharedLaws::seat(
    const JointSpec& joint) {
  const JointSpec of = without_friction(joint);
  for (const Seat& seat : seats_) {
    if (seat.of == of) return seat.grids;
  }
  std::shared_ptr<const detail::SeatGrids> grids;
  try {
    grids = std::make_shared<const detail::SeatGrids>(of);
  } catch (const Error& error) {
    throw Error(std::string(error.what()) + ", or without_seat");
  }
  seats_.push_back({of, grids});
  return grids;
}

Joint::Joint(const JointSpec& spec, SharedLaws& laws)
    : contact_(endless_contact(spec, laws)),
      model_(seat_model(spec, laws)),
      tilted_(tilted_model(spec, contact_)) {
  if (has_relief(spec) && tilted_) model_ = tilted_;
}

Joint::Joint(const JointSpec& spec)
    : Joint([&] {
        SharedLaws own;
        return Joint(spec, own);
      }()) {}

}  // namespace contact
