#pragma once

#include "angle/setup.hpp"

namespace CLI {
class App;
}

namespace hinge_angle {

/// Adds --joint and what describes a joint without a file.
void add_joint_options(CLI::App& app, Options& options);
/// Adds --load, --load-parameter and --x.
void add_load_options(CLI::App& app, Options& options);

}  // namespace hinge_angle
