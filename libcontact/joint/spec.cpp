#include "libcontact/joint/spec.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/joint/thermal_growth.hpp"

namespace contact {
namespace {

// Limit for crystals: they grow by some 2 % from cold to where they melt, and a
// quarter of the way there their moduli and coefficients are no longer
// constant.
constexpr double largest_free_strain = 0.005;

std::string text_of(const ThermalGrowth& growth) {
  const auto& [t, reference, inner, outer, strain] = growth;
  const auto celsius = [](double kelvin) { return kelvin - 273.15; };
  constexpr double um = 1e-6;
  return detail::message(
      "radial clearance {:.4g} um at {:.4g} C; ball or pin at {:.4g} C grows "
      "by "
      "{:.4g} um, seat or hole at {:.4g} C by {:.4g} um: {:.4g} um",
      reference / um, celsius(t.reference), celsius(t.inner), inner / um,
      celsius(t.outer), outer / um, (reference + outer - inner) / um);
}

void check(const Temperatures& t) {
  const auto require = [](std::string_view name, double kelvin) {
    detail::require(
        kelvin >= Temperatures::coldest && kelvin <= Temperatures::hottest,
        "temperatures", name, kelvin,
        detail::message("{} to {} K", Temperatures::coldest,
                        Temperatures::hottest));
  };
  require("inner", t.inner);
  require("outer", t.outer);
  require("reference", t.reference);
}

bool has_walls(const JointSpec& joint) {
  return !joint.inner.layers.empty() || !joint.outer.layers.empty() ||
         joint.outer.backing.kind() == Backing::Kind::held;
}

// True if two joints can share a law.
template <class Law>
bool serves(const Law& law, const JointSpec& joint,
            const ContactConditions& conditions, bool is_allowed) {
  if (law.joint_kind() != joint.geometry.kind()) return false;
  const auto& made_for = law.made_for();
  return made_for ? made_for->fits(joint.pair(), conditions) : is_allowed;
}

}  // namespace

std::vector<std::string> ThermalGrowth::validity_notes() const {
  if (!(largest_strain > largest_free_strain)) return {};
  return {detail::message(
      "a free thermal strain of {:.3g} exceeds {}: expansion is assumed "
      "linear, and Young's moduli independent of the temperature",
      largest_strain, largest_free_strain)};
}

JointSpec JointSpec::at(Temperatures to) const {
  using Side = detail::LayerCompliance::Side;
  check(to);
  if (geometry.kind() == JointKind::ball) to.axial = AxialGrowth::free;
  const auto growth = [&](Side side, const LayeredBody& body, double kelvin) {
    return detail::free_growth(geometry.kind(), side, body, geometry.radius(),
                               kelvin - to.reference, to.axial);
  };
  const double reference = thermal_growth ? thermal_growth->reference_clearance
                                          : geometry.radial_clearance();
  const double in = growth(Side::inner, inner, to.inner);
  const double out = growth(Side::outer, outer, to.outer);
  JointSpec warm = *this;
  warm.geometry = geometry.with_clearance(reference + out - in);
  const double strain =
      std::max(detail::largest_free_strain(inner, to.inner - to.reference),
               detail::largest_free_strain(outer, to.outer - to.reference));
  warm.thermal_growth = {to, reference, in, out, strain};
  return warm;
}

JointSpec JointSpec::without_relief() const {
  JointSpec other = *this;
  other.relief = Relief::none();
  return other;
}

bool JointSpec::is_endless() const {
  return !geometry.seat() && relief.kind() == Relief::Kind::none;
}

JointSpec JointSpec::endless() const { return without_seat().without_relief(); }

JointSpec JointSpec::without_seat() const {
  if (!geometry.seat()) return *this;
  JointSpec endless = *this;
  endless.geometry = geometry.without_seat();
  endless.bearing.reset();
  return endless;
}

ContactConditions JointSpec::conditions() const {
  ContactConditions result{
      .loading = loading,
      .clearance = clearance_of(geometry.radial_clearance())};
  if (has_walls(*this)) {
    result.walls = LayeredPair(geometry.radius(), inner, outer);
  }
  return result;
}

std::string JointSpec::half_angle_law_name() const {
  if (!half_angle_law.empty()) return half_angle_law;
  if (geometry.seat()) return "exact";
  const ContactConditions asked = conditions();
  if (!asked.walls && asked.clearance != Clearance::interference) {
    return std::string(default_half_angle_law);
  }
  // The first that knows walls and interference; it is for all joints, and
  // takes long.
  return detail::names_of(
             detail::half_angle_entries(),
             [&](const auto& law) { return law.about.allows(asked); })
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
  JointContact result(geometry, pair(), *friction, laws.half_angle(*this),
                      laws.pressure(*this), conditions());
  for (std::string& note : own_notes()) {
    result.add_validity_note(std::move(note));
  }
  return result;
}

std::unique_ptr<HalfAngleLaw> JointSpec::make_half_angle_law() const {
  return contact::make_half_angle_law(half_angle_law_name(), geometry.kind(),
                                      pair(), half_angle_options, conditions());
}

std::unique_ptr<PressureLaw> JointSpec::make_pressure_law() const {
  return contact::make_pressure_law(pressure_law_name(), geometry.kind(),
                                    pair(), conditions());
}

std::vector<std::string> JointSpec::clearance_notes() const {
  std::vector<std::string> notes;
  if (fit) notes.push_back(to_string(*fit));
  if (bearing) notes.push_back(to_string(*bearing));
  if (thermal_growth) notes.push_back(text_of(*thermal_growth));
  return notes;
}

std::vector<std::string> JointSpec::own_notes() const {
  std::vector<std::string> notes = relief.notes();
  if (thermal_growth) {
    std::ranges::copy(thermal_growth->validity_notes(),
                      std::back_inserter(notes));
  }
  return notes;
}

std::vector<std::string> JointSpec::validity_notes() const {
  std::vector<std::string> notes = geometry.validity_notes();
  std::ranges::copy(own_notes(), std::back_inserter(notes));
  for (std::string& note : make_half_angle_law()->validity_notes(pair())) {
    notes.push_back(std::move(note));
  }
  return notes;
}

std::shared_ptr<const HalfAngleLaw> SharedLaws::half_angle(
    const JointSpec& joint) {
  const std::string name = joint.half_angle_law_name();
  const ContactConditions conditions = joint.conditions();
  const bool is_allowed = half_angle_law_allows(name, conditions);
  for (const auto& [its_name, options, law] : half_angle_) {
    if (its_name == name && options == joint.half_angle_options &&
        serves(*law, joint, conditions, is_allowed)) {
      return law;
    }
  }
  half_angle_.push_back(
      {name, joint.half_angle_options, joint.make_half_angle_law()});
  return half_angle_.back().law;
}

std::shared_ptr<const PressureLaw> SharedLaws::pressure(
    const JointSpec& joint) {
  const std::string name = joint.pressure_law_name();
  const ContactConditions conditions = joint.conditions();
  const bool is_allowed = pressure_law_allows(name, conditions);
  for (const auto& [its_name, law] : pressure_) {
    if (its_name == name && serves(*law, joint, conditions, is_allowed)) {
      return law;
    }
  }
  pressure_.push_back({name, joint.make_pressure_law()});
  return pressure_.back().law;
}

}  // namespace contact
