#include "cli/joint/friction_options.hpp"

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"

namespace cli {
namespace {

using contact::Dimension;

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

}  // namespace

void add_friction_options(Program& program, FrictionOptions& options) {
  program.add("Friction",
              {{"--friction", &options.friction, "NUMBER", "f0 of f = f0 + A/p",
                "", "--viscous"},
               {"--adhesion", &options.adhesion, "NUMBER",
                "A of f = f0 + A/p, Pa; default 0", "", "--viscous"},
               {"--viscous", &options.viscous, "NUMBERS",
                "k0, Pa s/m, or k0,k1 (s/m): friction stress (k0 + k1 p) v"}});
}

double parse_adhesion(const std::string& text) {
  return parse_quantity("--adhesion", text, Dimension::stress,
                        {0, largest, "Pa"});
}

contact::FrictionModel make_friction(
    const FrictionOptions& options,
    const std::optional<contact::FrictionModel>& of_joint,
    const JointOptions& joint) {
  if (!options.viscous.empty()) return viscous_law(options.viscous);
  if (options.friction.empty() && !of_joint) {
    refuse_without(given("--joint", joint.joint()),
                   "--friction or --viscous: neither the joint nor "
                   "its materials have one");
  }
  if (options.friction.empty() && options.adhesion.empty()) return *of_joint;
  // A coefficient without an adhesion means none.
  const double adhesion =
      options.adhesion.empty() ? 0 : parse_adhesion(options.adhesion);
  if (!options.friction.empty()) {
    return contact::FrictionLaw(
        parse_value("--friction", options.friction, strength), adhesion);
  }
  const auto* dry = std::get_if<contact::FrictionLaw>(&*of_joint);
  if (dry == nullptr) {
    refuse_without(given("--adhesion", options.adhesion),
                   "--friction: the joint's friction is not dry");
  }
  return contact::FrictionLaw(dry->coefficient(), adhesion);
}

}  // namespace cli
