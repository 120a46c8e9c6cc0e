#pragma once

#include <optional>

#include "cli/joint/joint_options.hpp"

/// Friction as programs take it from the command line.
namespace cli {

struct FrictionOptions {
  std::optional<double> coefficient = {};
  std::optional<double> adhesion = {};  ///< Pa
  std::optional<contact::ViscousLaw> viscous = {};
};

/// --friction and --adhesion.
std::vector<Option> dry_friction_rows(FrictionOptions& options);
/// Adds these rows and --viscous.
void add_friction_options(Program& program, FrictionOptions& options);

/// The friction given by the options, else by the joint. Throws contact::Error
/// if neither gives one.
contact::FrictionModel make_friction(
    const FrictionOptions& options,
    const std::optional<contact::FrictionModel>& of_joint,
    const JointOptions& joint);

/// The joint's spec with this friction and the first law asked for, else the
/// joint's own law. A contact::Joint in its seat is made from it.
contact::JointSpec asked_spec(const Joint& joint,
                              contact::FrictionModel friction,
                              const JointOptions& options);

/// The joint's dry friction, 0 if it has none, changed by the options.
/// @param needs  "X requires Y: " begins the message if friction is not dry
contact::FrictionLaw dry_friction(
    const FrictionOptions& options,
    const std::optional<contact::FrictionModel>& of_joint,
    std::string_view what, std::string_view needs);

}  // namespace cli
