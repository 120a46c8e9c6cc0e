#include "cli/joint/friction_options.hpp"

#include <algorithm>
#include <utility>

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/tables/friction_presets.hpp"

namespace cli {
namespace {

using contact::Dimension;
using contact::FrictionLaw;

// Far above any friction coefficient, adhesion or viscosity.
constexpr double largest = 1e30;
constexpr Allowed strength{0, largest, ""};

// "k0" or "k0,k1".
contact::ViscousLaw viscous_law(const std::string& text) {
  const auto parts = split(text, ",");
  std::optional<double> k0;
  std::optional<double> k1 = 0;
  if (parts.size() <= 2) {
    k0 = read_quantity("--viscous", parts[0], Dimension::viscous_constant);
  }
  if (parts.size() == 2) {
    k1 = read_quantity("--viscous", parts[1], Dimension::inverse_velocity);
  }
  if (!k0 || !k1 || !strength.contains(*k0) || !strength.contains(*k1)) {
    refuse("--viscous", text,
           "k0 (Pa s/m) or k0,k1 (s/m), each " + strength.text());
  }
  return contact::ViscousLaw(*k0, *k1);
}

// A number, or the middle of a published range.
double dry_coefficient(const std::string& text) {
  const auto all = contact::detail::friction_presets();
  const auto preset =
      std::ranges::find(all, text, &contact::detail::FrictionPreset::name);
  if (preset != all.end()) return preset->middle();
  if (parse_number(text)) {
    return parse_quantity("--friction", text, Dimension::number, strength);
  }
  std::vector<std::string> names;
  for (const auto& each : all) names.emplace_back(each.name);
  refuse("--friction", text,
         strength.rule(false) + contact::detail::did_you_mean(
                                    contact::detail::nearest(text, names)));
}

}  // namespace

std::vector<Option> dry_friction_rows(FrictionOptions& o) {
  const Reader read = [&o](const std::string& text) {
    o.coefficient = dry_coefficient(text);
  };
  return {
      {"--friction", read, "NUMBER|NAME",
       "f0 of f = f0 + A/p, or a preset: steel_steel_greased", "", "--viscous"},
      {"--adhesion",
       number("--adhesion", o.adhesion, Dimension::stress, {0, largest, "Pa"}),
       "NUMBER", "A of f = f0 + A/p, Pa; default 0", "", "--viscous"}};
}

void add_friction_options(Program& program, FrictionOptions& o) {
  program.add("Friction", dry_friction_rows(o));
  const Reader viscous = [&o](const std::string& text) {
    o.viscous = viscous_law(text);
  };
  program.add("Friction",
              {{"--viscous", viscous, "NUMBERS",
                "k0, Pa s/m, or k0,k1 (s/m): friction stress (k0 + k1 p) v"}});
}

FrictionLaw dry_friction(const FrictionOptions& options,
                         const std::optional<contact::FrictionModel>& of_joint,
                         std::string_view what, std::string_view needs) {
  const contact::FrictionModel model = of_joint.value_or(FrictionLaw(0));
  const auto* dry = std::get_if<FrictionLaw>(&model);
  if (dry == nullptr) refuse_without(what, needs);
  return FrictionLaw(options.coefficient.value_or(dry->coefficient()),
                     options.adhesion.value_or(dry->adhesion()));
}

contact::FrictionModel make_friction(
    const FrictionOptions& options,
    const std::optional<contact::FrictionModel>& of_joint,
    const JointOptions& joint) {
  if (options.viscous) return *options.viscous;
  // A coefficient given without an adhesion means an adhesion of 0.
  if (options.coefficient) {
    return FrictionLaw(*options.coefficient, options.adhesion.value_or(0));
  }
  if (!of_joint && joint.is_plain_bearing) {
    return FrictionLaw(dry_coefficient("steel_steel_greased"),
                       options.adhesion.value_or(0));
  }
  if (!of_joint) {
    refuse_without(given("--joint", joint.joint()),
                   "--friction or --viscous: neither the joint nor "
                   "its materials have one");
  }
  if (!options.adhesion) return *of_joint;
  return dry_friction(options, of_joint, "--adhesion",
                      "--friction: the joint's friction is not dry");
}

contact::JointSpec asked_spec(const Joint& joint,
                              contact::FrictionModel friction,
                              const JointOptions& options) {
  contact::JointSpec spec = joint.spec;
  spec.friction = std::move(friction);
  if (!options.laws.empty()) spec.half_angle_law = options.laws[0];
  if (!options.pressures.empty()) spec.pressure_law = options.pressures[0];
  spec.half_angle_law = spec.half_angle_law_name();
  spec.pressure_law = spec.pressure_law_name();
  return spec;
}

}  // namespace cli
