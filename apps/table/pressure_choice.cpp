#include "table/pressure_choice.hpp"

#include <fmt/format.h>

#include <optional>

#include "cli/laws.hpp"
#include "libcontact/error.hpp"
#include "libcontact/joint_file.hpp"

namespace hinge_table {
namespace {

struct Materials {
  contact::ElasticPair pair;
  std::string pressure_law;  ///< of a joint file
};

std::optional<Materials> materials_of(const Options& options) {
  if (!options.joint.empty()) {
    const contact::Joint joint = contact::read_joint(options.joint);
    if (joint.geometry.kind() != contact::JointKind::spherical) {
      throw contact::Error(fmt::format(
          "--joint {}: a cylindrical joint: allowed spherical", options.joint));
    }
    return Materials{joint.pair, joint.pressure_law};
  }
  if (!options.pair.empty()) {
    return Materials{contact::read_material_pair(options.pair).elastic, {}};
  }
  if (!options.modulus_ratio.empty()) {
    return Materials{
        cli::pair_of_modulus_ratio(options.modulus_ratio, options.poisson1,
                                   options.poisson2),
        {}};
  }
  return {};
}

}  // namespace

std::shared_ptr<const contact::PressureLaw> chosen_pressure(
    const Options& options) {
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
  // The other laws do not look at the pair.
  return contact::make_pressure_law(
      name, contact::JointKind::spherical,
      materials ? materials->pair
                : contact::ElasticPair::from_modulus_ratio(1, 0.3, 0.3));
}

}  // namespace hinge_table
