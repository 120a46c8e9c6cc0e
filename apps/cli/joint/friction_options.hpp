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
/// Adds them and --viscous.
void add_friction_options(Program& program, FrictionOptions& options);

/// The friction of the options, else the joint's. Throws contact::Error if
/// there is none.
contact::FrictionModel make_friction(
    const FrictionOptions& options,
    const std::optional<contact::FrictionModel>& of_joint,
    const JointOptions& joint);

/// The joint's spec with this friction and the first of the laws that were
/// asked for, or its own: what a contact::Joint in its seat is made of.
contact::JointSpec asked_spec(const Joint& joint,
                              contact::FrictionModel friction,
                              const JointOptions& options);

/// The joint's dry friction, 0 if it has none, changed by the options.
/// @param needs  "X requires Y: ", the message where it is not dry
contact::FrictionLaw dry_friction(
    const FrictionOptions& options,
    const std::optional<contact::FrictionModel>& of_joint,
    std::string_view what, std::string_view needs);

}  // namespace cli
