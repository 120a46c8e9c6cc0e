#include "angle/setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cli/quantity.hpp"
#include "libcontact/error.hpp"
#include "libcontact/joint_file.hpp"
#include "libcontact/units.hpp"

namespace hinge_angle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Setup setup_from_file(const Options& options) {
  if (!options.joint.ends_with(".toml")) {
    throw contact::Error(fmt::format(
        "--joint {}: allowed sphere, cylinder or a .toml file", options.joint));
  }
  if (!options.pair.empty() || !options.modulus_ratio.empty()) {
    throw contact::Error(
        fmt::format("--joint {}: the file has the materials; not with --pair "
                    "or --modulus-ratio",
                    options.joint));
  }
  const contact::Joint joint = contact::read_joint(options.joint);
  return {joint.geometry.kind(),  joint.pair,
          joint.geometry,         joint.half_angle_options,
          {joint.half_angle_law}, joint.pressure_law};
}

Setup dimensionless_setup(const Options& options, contact::JointKind kind) {
  constexpr cli::Allowed poisson{0, 0.5, ""};
  return {kind, contact::ElasticPair::from_modulus_ratio(
                    cli::parse_value("--modulus-ratio", options.modulus_ratio,
                                     {0, infinity, ""}),
                    cli::parse_value("--poisson1", options.poisson1, poisson),
                    cli::parse_value("--poisson2", options.poisson2, poisson))};
}

Setup setup_from_pair(const Options& options, contact::JointKind kind) {
  Setup setup{kind, contact::read_material_pair(options.pair).elastic};
  if (options.radius.empty()) return setup;
  const double radius = cli::parse_length("--radius", options.radius);
  const double clearance = cli::parse_length("--clearance", options.clearance);
  // Loads of a pin are per unit length, so its length does not matter.
  setup.geometry = kind == contact::JointKind::spherical
                       ? contact::JointGeometry::ball(radius, clearance)
                       : contact::JointGeometry::pin(radius, clearance, 1);
  return setup;
}

Setup setup_of_joint(const Options& options) {
  if (options.joint != "sphere" && options.joint != "cylinder") {
    return setup_from_file(options);
  }
  const contact::JointKind kind = options.joint == "sphere"
                                      ? contact::JointKind::spherical
                                      : contact::JointKind::cylindrical;
  if (!options.modulus_ratio.empty()) {
    return dimensionless_setup(options, kind);
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
  auto& limit = setup.half_angle_options;
  if (!options.limit_angle.empty()) {
    limit.limit_half_angle.reset();
    limit.linear_limit = options.limit_angle == "linear";
    if (options.limit_angle != "linear" && options.limit_angle != "formula") {
      limit.limit_half_angle =
          cli::parse_value("--limit-angle", options.limit_angle,
                           {0, 180, "deg"}) *
          contact::degree;
    }
  }
  if (!options.laws.empty()) {
    cli::refuse_repetition("--law", options.laws);
    setup.half_angle_laws = options.laws;
  } else if (options.compare) {
    setup.half_angle_laws = {"all"};
  }
  if (setup.half_angle_laws == std::vector<std::string>{"all"}) {
    setup.half_angle_laws = contact::half_angle_law_names();
    std::erase(setup.half_angle_laws, "paper");  // one of the others
  }
  if (!options.limit_angle.empty() &&
      std::none_of(setup.half_angle_laws.begin(), setup.half_angle_laws.end(),
                   contact::takes_half_angle_options)) {
    throw contact::Error(
        fmt::format("--limit-angle {}: allowed with the laws arctan, tanh, "
                    "blend and paper; none of them is asked for",
                    options.limit_angle));
  }
  if (!options.pressure.empty()) setup.pressure_law = options.pressure;
  return setup;
}

}  // namespace hinge_angle
