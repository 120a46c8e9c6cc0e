#include "joint/setup.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "cli/choice.hpp"
#include "cli/quantity.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/files/joint_file.hpp"

namespace hinge_joint {
namespace {

using contact::JointBody;
using contact::JointGeometry;
using contact::JointSpec;

// Far above any friction coefficient, adhesion or viscosity.
constexpr double largest = 1e30;
constexpr cli::Allowed strength{0, largest, ""};

JointSpec joint_from_file(const Options& options) {
  if (!options.joint.ends_with(".toml")) {
    throw contact::Error(fmt::format(
        "--joint {}: allowed ball, pin or a .toml file", options.joint));
  }
  for (const auto* text : {&options.pair, &options.radius, &options.clearance,
                           &options.length, &options.inner_body}) {
    if (!text->empty()) {
      throw contact::Error(fmt::format(
          "--joint {}: the file has materials and geometry; not with --pair, "
          "--radius, --clearance, --length, --inner-body",
          options.joint));
    }
  }
  return contact::read_joint(options.joint);
}

JointGeometry geometry_from_options(const Options& options, bool ball) {
  constexpr std::array<cli::Choice<JointBody>, 2> bodies = {
      {{"carrier", JointBody::carrier}, {"load", JointBody::body}}};
  const JointBody inner =
      options.inner_body.empty()
          ? JointBody::carrier
          : cli::choice("--inner-body", options.inner_body, bodies);
  if (options.length.empty() != ball) {
    throw contact::Error("--length: a pin needs it, a ball has none");
  }
  const double radius = cli::parse_length("--radius", options.radius);
  const double clearance = cli::parse_length("--clearance", options.clearance);
  if (ball) return JointGeometry::ball(radius, clearance, inner);
  return JointGeometry::pin(
      radius, clearance, cli::parse_length("--length", options.length), inner);
}

JointSpec joint_from_options(const Options& options) {
  if (options.pair.empty() || options.radius.empty() ||
      options.clearance.empty()) {
    throw contact::Error(fmt::format(
        "--joint {}: needs --pair, --radius and --clearance", options.joint));
  }
  const contact::MaterialPair pair = contact::read_material_pair(options.pair);
  return {.name = "",
          .geometry = geometry_from_options(options, options.joint == "ball"),
          .pair = pair.elastic,
          .friction = pair.friction,
          .half_angle_law = std::string(contact::default_half_angle_law),
          .half_angle_options = {},
          .pressure_law = std::string(contact::default_pressure_law)};
}

// "k0" or "k0,k1".
contact::ViscousLaw viscous_law(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto k0 = cli::parse_number(text.substr(0, comma));
  const auto k1 = comma == std::string::npos
                      ? std::optional<double>(0)
                      : cli::parse_number(text.substr(comma + 1));
  if (!k0 || !k1 || !strength.contains(*k0) || !strength.contains(*k1)) {
    throw contact::Error(
        fmt::format("--viscous {}: allowed k0 (Pa s/m) or k0,k1 (s/m), each {}",
                    text, strength.text()));
  }
  return contact::ViscousLaw(*k0, *k1);
}

contact::FrictionModel make_friction(const Options& options,
                                     const JointSpec& joint) {
  if (!options.viscous.empty()) {
    if (!options.friction.empty() || !options.adhesion.empty()) {
      throw contact::Error("--viscous: not with --friction or --adhesion");
    }
    return viscous_law(options.viscous);
  }
  if (options.friction.empty() && !joint.friction) {
    throw contact::Error(
        "needs --friction or --viscous: neither the joint nor its materials "
        "have one");
  }
  if (options.friction.empty() && options.adhesion.empty()) {
    return *joint.friction;
  }
  // A coefficient without an adhesion means none.
  const double adhesion = options.adhesion.empty()
                              ? 0
                              : cli::parse_value("--adhesion", options.adhesion,
                                                 {0, largest, "Pa"});
  if (!options.friction.empty()) {
    return contact::FrictionLaw(
        cli::parse_value("--friction", options.friction, strength), adhesion);
  }
  const auto* dry = std::get_if<contact::FrictionLaw>(&*joint.friction);
  if (dry == nullptr) {
    throw contact::Error(fmt::format(
        "--adhesion {}: the joint's friction is viscous: needs --friction too",
        options.adhesion));
  }
  return contact::FrictionLaw(dry->coefficient(), adhesion);
}

}  // namespace

Setup make_setup(const Options& options) {
  const bool named = options.joint == "ball" || options.joint == "pin";
  JointSpec joint =
      named ? joint_from_options(options) : joint_from_file(options);
  const auto friction = make_friction(options, joint);
  contact::ContactConditions& conditions = joint.conditions;
  conditions.loading = cli::parse_loading(options.loading, conditions.loading);
  const auto laws =
      cli::half_angle_laws(options.laws, {joint.half_angle_law}, conditions);
  const auto pressures =
      cli::pressure_laws(options.pressures, {joint.pressure_law}, conditions);
  cli::set_limit_angle(options.limit_angle, laws, joint.half_angle_options);

  const contact::JointKind kind = joint.geometry.kind();
  const auto half_angles = cli::make_half_angle_laws(
      laws, kind, joint.pair, joint.half_angle_options, conditions);
  const auto shapes =
      cli::make_pressure_laws(pressures, kind, joint.pair, conditions);
  Setup setup{joint.name, {}, cli::LawNotes(half_angles, joint.pair)};
  for (const cli::NamedLaw& law : half_angles) {
    for (const cli::NamedPressure& pressure : shapes) {
      NamedJoint& added = setup.joints.emplace_back(
          NamedJoint{law.name,
                     pressure.name,
                     AnyJoint({joint.geometry, joint.pair, friction, law.law,
                               pressure.law}),
                     {}});
      if (cli::JointApproach::of(*law.law)) {
        added.approach.emplace(law.law, joint.geometry, joint.pair,
                               joint.geometry.length());
      }
    }
  }
  return setup;
}

}  // namespace hinge_joint
