#include "angle/setup.hpp"

#include <fmt/format.h>

#include "cli/laws.hpp"
#include "cli/quantity.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/files/joint_file.hpp"

namespace hinge_angle {
namespace {

Setup setup_from_file(const Options& options) {
  if (!options.joint.ends_with(".toml")) {
    throw contact::Error(fmt::format(
        "--joint {}: allowed ball, pin or a .toml file", options.joint));
  }
  if (!options.pair.empty() || !options.modulus_ratio.empty()) {
    throw contact::Error(
        fmt::format("--joint {}: the file has the materials; not with --pair "
                    "or --modulus-ratio",
                    options.joint));
  }
  const contact::JointSpec joint = contact::read_joint(options.joint);
  return {.kind = joint.geometry.kind(),
          .pair = joint.pair,
          .geometry = joint.geometry,
          .half_angle_options = joint.half_angle_options,
          .half_angle_laws = {joint.half_angle_law},
          .pressure_law = joint.pressure_law,
          .conditions = joint.conditions,
          .name = joint.name};
}

Setup setup_from_pair(const Options& options, contact::JointKind kind) {
  const contact::MaterialPair pair = contact::read_material_pair(options.pair);
  Setup setup{.kind = kind,
              .pair = pair.elastic,
              .name = to_string(kind) + " joint, " + pair.name};
  if (options.radius.empty()) return setup;
  const double radius = cli::parse_length("--radius", options.radius);
  const double clearance = cli::parse_length("--clearance", options.clearance);
  // Loads of a pin are per unit length, so its length does not matter.
  setup.geometry = kind == contact::JointKind::ball
                       ? contact::JointGeometry::ball(radius, clearance)
                       : contact::JointGeometry::pin(radius, clearance, 1);
  return setup;
}

Setup setup_of_joint(const Options& options) {
  if (options.joint != "ball" && options.joint != "pin") {
    return setup_from_file(options);
  }
  const contact::JointKind kind = options.joint == "ball"
                                      ? contact::JointKind::ball
                                      : contact::JointKind::pin;
  if (!options.modulus_ratio.empty()) {
    return {kind,
            cli::pair_of_modulus_ratio(options.modulus_ratio, options.poisson1,
                                       options.poisson2)};
  }
  if (options.pair.empty()) {
    throw contact::Error(fmt::format(
        "--joint {}: needs --pair or --modulus-ratio", options.joint));
  }
  return setup_from_pair(options, kind);
}

}  // namespace

Setup make_setup(const Options& options) {
  Setup setup = setup_of_joint(options);
  setup.tolerance =
      cli::parse_value("--tolerance", options.tolerance, {0, 100, "%"});
  contact::ContactConditions& conditions = setup.conditions;
  conditions.loading = cli::parse_loading(options.loading, conditions.loading);
  if (options.compare && !options.pressure.empty()) {
    throw contact::Error(
        fmt::format("--pressure {}: not with --compare, which has no pressures",
                    options.pressure));
  }
  if (options.compare && options.output.jobs != 1) {
    throw contact::Error("--jobs: not with --compare, which takes one thread");
  }
  if (options.compare && (conditions.loading.is_back() || conditions.walls)) {
    throw contact::Error(
        fmt::format("--compare: the laws are of a force at the centre and an "
                    "infinite outer body: not with {}",
                    to_string(conditions)));
  }
  setup.half_angle_laws = cli::half_angle_laws(
      options.laws.empty() && options.compare ? std::vector<std::string>{"all"}
                                              : options.laws,
      setup.half_angle_laws, conditions);
  cli::set_limit_angle(options.limit_angle, setup.half_angle_laws,
                       setup.half_angle_options);
  if (!options.pressure.empty()) setup.pressure_law = options.pressure;
  return setup;
}

}  // namespace hinge_angle
