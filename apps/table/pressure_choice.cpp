#include "table/pressure_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "libcontact/base/error.hpp"
#include "libcontact/files/joint_file.hpp"

namespace hinge_table {
namespace {

struct Materials {
  std::string option;
  contact::ElasticPair pair;
  // Of a joint file.
  std::string pressure_law = {};
  contact::ContactConditions conditions = {};
  std::string name = {};
};

std::optional<Materials> materials_of(const Options& options) {
  if (!options.joint.empty()) {
    const contact::JointSpec joint = contact::read_joint(options.joint);
    if (joint.geometry.kind() != contact::JointKind::ball) {
      throw contact::Error(
          fmt::format("--joint {}: a pin joint: allowed ball", options.joint));
    }
    return Materials{"--joint " + options.joint, joint.pair, joint.pressure_law,
                     joint.conditions, joint.name};
  }
  if (!options.pair.empty()) {
    return Materials{"--pair " + options.pair,
                     contact::read_material_pair(options.pair).elastic};
  }
  if (!options.modulus_ratio.empty()) {
    return Materials{
        "--modulus-ratio " + options.modulus_ratio,
        cli::pair_of_modulus_ratio(options.modulus_ratio, options.poisson1,
                                   options.poisson2)};
  }
  return {};
}

// Options that change nothing in the table. A joint may at least name a
// pressure that is not the usual one.
void refuse_idle(const Options& options,
                 const std::optional<Materials>& materials,
                 const std::string& pressure) {
  if (!options.loading.empty() && pressure != "exact") {
    throw contact::Error(
        fmt::format("--loading {}: allowed with --pressure exact; this is {}",
                    options.loading, pressure));
  }
  if (!materials || pressure == "mixture" || pressure == "exact") return;
  const bool named = options.pressure.empty() &&
                     !materials->pressure_law.empty() &&
                     pressure != contact::default_pressure_law;
  if (named) return;
  throw contact::Error(
      fmt::format("{}: the pressure {} is the same for all materials: allowed "
                  "with --pressure mixture or exact",
                  materials->option, pressure));
}

}  // namespace

PressureChoice chosen_pressure(const Options& options) {
  const std::optional<Materials> materials = materials_of(options);
  std::string name = options.pressure;
  if (name.empty() && materials) name = materials->pressure_law;
  if (name.empty()) name = contact::default_pressure_law;
  if (!materials && (name == "mixture" || name == "exact")) {
    throw contact::Error(
        fmt::format("--pressure {}: depends on the materials: needs --joint, "
                    "--pair or --modulus-ratio",
                    name));
  }
  auto conditions =
      materials ? materials->conditions : contact::ContactConditions{};
  conditions.loading = cli::parse_loading(options.loading, conditions.loading);
  // The other laws do not look at the pair.
  cli::NamedPressure pressure = cli::make_pressure_law(
      name, contact::JointKind::ball,
      materials ? materials->pair
                : contact::ElasticPair::from_modulus_ratio(1, 0.3, 0.3),
      conditions);
  refuse_idle(options, materials, name);
  return {std::move(pressure), materials ? materials->name : ""};
}

}  // namespace hinge_table
