#pragma once

#include <optional>
#include <string>

#include "cli/joint/joint_options.hpp"

/// Friction as programs take it from the command line.
namespace cli {

/// As it was written; "" for options that were not given.
struct FrictionOptions {
  std::string friction = {};
  std::string adhesion = {};
  std::string viscous = {};
};

/// Adds --friction, --adhesion and --viscous.
void add_friction_options(Program& program, FrictionOptions& options);

/// A of --adhesion, Pa.
double parse_adhesion(const std::string& text);

/// The friction of the options, else the joint's. Throws contact::Error if
/// there is none.
contact::FrictionModel make_friction(
    const FrictionOptions& options,
    const std::optional<contact::FrictionModel>& of_joint,
    const JointOptions& joint);

}  // namespace cli
