#include "joint/setup.hpp"

#include <optional>

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace hinge_joint {
namespace {

using cli::given;
using contact::Dimension;

// Far above any friction coefficient, adhesion or viscosity.
constexpr double largest = 1e30;
constexpr cli::Allowed strength{0, largest, ""};

// "k0" or "k0,k1".
contact::ViscousLaw viscous_law(const std::string& text) {
  const auto parts = cli::split(text, ",");
  std::optional<double> k0;
  std::optional<double> k1 = 0;
  if (parts.size() <= 2) {
    k0 = cli::read_quantity("--viscous", parts[0], Dimension::viscous_constant);
  }
  if (parts.size() == 2) {
    k1 = cli::read_quantity("--viscous", parts[1], Dimension::inverse_velocity);
  }
  if (!k0 || !k1 || !strength.contains(*k0) || !strength.contains(*k1)) {
    cli::refuse("--viscous", text,
                "k0 (Pa s/m) or k0,k1 (s/m), each " + strength.text());
  }
  return contact::ViscousLaw(*k0, *k1);
}

// Dry friction whose f0 is to be found.
contact::FrictionLaw adhesion_alone(
    const Options& options,
    const std::optional<contact::FrictionModel>& of_joint) {
  if (!options.adhesion.empty()) {
    return contact::FrictionLaw(
        0,
        cli::parse_value("--adhesion", options.adhesion, {0, largest, "Pa"}));
  }
  if (!of_joint) return contact::FrictionLaw(0);
  const auto* dry = std::get_if<contact::FrictionLaw>(&*of_joint);
  if (dry == nullptr) {
    cli::refuse_without("--measured-moment",
                        "--adhesion: the joint's friction is viscous");
  }
  return contact::FrictionLaw(0, dry->adhesion());
}

contact::FrictionModel make_friction(
    const Options& options,
    const std::optional<contact::FrictionModel>& of_joint) {
  if (!options.viscous.empty()) return viscous_law(options.viscous);
  if (!options.measured_moment.empty()) {
    return adhesion_alone(options, of_joint);
  }
  if (options.friction.empty() && !of_joint) {
    cli::refuse_without(given("--joint", options.joint.joint),
                        "--friction or --viscous: neither the joint nor "
                        "its materials have one");
  }
  if (options.friction.empty() && options.adhesion.empty()) return *of_joint;
  // A coefficient without an adhesion means none.
  const double adhesion =
      options.adhesion.empty()
          ? 0
          : cli::parse_quantity("--adhesion", options.adhesion,
                                Dimension::stress, {0, largest, "Pa"});
  if (!options.friction.empty()) {
    return contact::FrictionLaw(
        cli::parse_value("--friction", options.friction, strength), adhesion);
  }
  const auto* dry = std::get_if<contact::FrictionLaw>(&*of_joint);
  if (dry == nullptr) {
    cli::refuse_without(given("--adhesion", options.adhesion),
                        "--friction: the joint's friction is viscous");
  }
  return contact::FrictionLaw(dry->coefficient(), adhesion);
}

}  // namespace

Setup make_setup(const Options& options) {
  Setup setup{.given = make_joints(options.joint), .joints = {}};
  for (const cli::Joint& joint : setup.given) {
    if (joint.kind != setup.given[0].kind) {
      throw contact::Error(contact::detail::must_be(
          "the joints of --joint and --set", "all balls or all pins"));
    }
    const contact::FrictionModel friction =
        make_friction(options, joint.friction);
    for (const cli::NamedLaw& law : joint.laws) {
      for (const cli::NamedPressure& pressure : joint.pressures) {
        NamedJoint& added = setup.joints.emplace_back(
            NamedJoint{law.name,
                       pressure.name,
                       contact::Joint({*joint.geometry, joint.pair, friction,
                                       law.law, pressure.law}),
                       {},
                       joint.differences,
                       options.pv});
        if (cli::JointApproach::of(*law.law)) {
          added.approach.emplace(law.law, joint);
        }
      }
    }
  }
  return setup;
}

}  // namespace hinge_joint
