#pragma once

#include <optional>
#include <string>

#include "cli/program.hpp"
#include "programs/angle/input.hpp"

namespace hinge_angle {

/// The options of joints with play.
struct PlayOptions {
  bool force_law = false;
  std::string penetration;
  bool impact = false;
  double mass = 0;                        ///< kg
  std::string speed;                      ///< sweep, m/s
  double restitution = 0;                 ///< e
  std::optional<double> reference_speed;  ///< m/s; none: each impact's
  double density = 0;                     ///< kg/m^3; 0: not known
};

/// The joint given by the options; its size must be known.
/// @param for_option  the option that needs the size, for messages
/// @throws contact::Error without a size
cli::Joint sized_joint(cli::JointOptions options, const char* for_option);

/// Adds --force-law, --impact and their options.
void add_play_options(cli::Program& program, PlayOptions& options);

/// --force-law: a table of force, stiffness, energy and half-angle over the
/// penetration; with `compare` the penetrations of the exact and of published
/// laws.
cli::ExitStatus run_force_law(const PlayOptions& options,
                              const cli::JointOptions& joint,
                              const LoadOptions& load, bool compare,
                              const cli::OutputOptions& output);

/// --impact: a row for each speed.
cli::ExitStatus run_impact(const PlayOptions& options,
                           const cli::JointOptions& joint,
                           const cli::OutputOptions& output);

}  // namespace hinge_angle
