#include "libcontact/joint/spec.hpp"

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/half_angle/registry.hpp"

namespace contact {
namespace {

bool has_walls(const JointSpec& joint) {
  return !joint.inner.layers.empty() || !joint.outer.layers.empty() ||
         joint.outer.backing.kind() == Backing::Kind::held;
}

// Whether any law of the same name and options serves both.
bool are_alike(const JointSpec& a, const JointSpec& b) {
  return a.geometry.kind() == b.geometry.kind() && a.inner == b.inner &&
         a.outer == b.outer && a.loading == b.loading &&
         (!has_walls(a) || a.geometry.radius() == b.geometry.radius());
}

}  // namespace

ContactConditions JointSpec::conditions() const {
  ContactConditions result{.loading = loading};
  if (has_walls(*this)) {
    result.walls = LayeredPair(geometry.radius(), inner, outer);
  }
  return result;
}

std::string JointSpec::half_angle_law_name() const {
  if (!half_angle_law.empty()) return half_angle_law;
  if (!has_walls(*this)) return std::string(default_half_angle_law);
  return detail::half_angle_names(
             [](const auto& law) { return law.about.allows_walls; })
      .front();
}

std::string JointSpec::pressure_law_name() const {
  return pressure_law.empty() ? std::string(default_pressure_law)
                              : pressure_law;
}

JointContact JointSpec::contact() const {
  SharedLaws own;
  return contact(own);
}

JointContact JointSpec::contact(SharedLaws& laws) const {
  if (!friction) {
    throw Error(detail::needs(detail::message("joint \"{}\"", name),
                              "[friction], of the joint or of its materials"));
  }
  return {geometry,
          pair(),
          *friction,
          laws.half_angle(*this),
          laws.pressure(*this),
          conditions()};
}

std::unique_ptr<HalfAngleLaw> JointSpec::make_half_angle_law() const {
  return contact::make_half_angle_law(half_angle_law_name(), geometry.kind(),
                                      pair(), half_angle_options, conditions());
}

std::unique_ptr<PressureLaw> JointSpec::make_pressure_law() const {
  return contact::make_pressure_law(pressure_law_name(), geometry.kind(),
                                    pair(), conditions());
}

std::vector<std::string> JointSpec::validity_notes() const {
  std::vector<std::string> notes = geometry.validity_notes();
  for (std::string& note : make_half_angle_law()->validity_notes(pair())) {
    notes.push_back(std::move(note));
  }
  return notes;
}

std::shared_ptr<const HalfAngleLaw> SharedLaws::half_angle(
    const JointSpec& joint) {
  for (const auto& [other, law] : half_angle_) {
    if (are_alike(joint, other) &&
        joint.half_angle_law_name() == other.half_angle_law_name() &&
        joint.half_angle_options == other.half_angle_options) {
      return law;
    }
  }
  return half_angle_.emplace_back(joint, joint.make_half_angle_law()).second;
}

std::shared_ptr<const PressureLaw> SharedLaws::pressure(
    const JointSpec& joint) {
  for (const auto& [other, law] : pressure_) {
    if (are_alike(joint, other) &&
        joint.pressure_law_name() == other.pressure_law_name()) {
      return law;
    }
  }
  return pressure_.emplace_back(joint, joint.make_pressure_law()).second;
}

}  // namespace contact
