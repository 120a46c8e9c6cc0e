#include "angle/input.hpp"

#include <CLI/CLI.hpp>

#include <limits>

#include "cli/program.hpp"
#include "cli/refuse.hpp"

namespace hinge_angle {

using contact::Dimension;

void add_load_options(CLI::App& app, LoadOptions& options) {
  app.option_defaults()->group("Load");
  app.add_option("--load", options.load, "N, or N/m for a pin")
      ->option_text("VALUES");
  app.add_option("--load-parameter", options.load_parameter, "mu or lambda")
      ->option_text("VALUES");
  app.add_option("--x", options.x, "cbrt(mu) or 2 sqrt(lambda)")
      ->option_text("VALUES");
  cli::exclude(app, "--load", {"--load-parameter", "--x"});
  cli::exclude(app, "--load-parameter", {"--x"});
}

Input make_input(const LoadOptions& options, const cli::Joint& joint) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto load = [&](LoadVariable variable, const char* option,
                        const std::string& values, const char* unit = "",
                        Dimension dimension = Dimension::number) {
    return Input{variable, false,
                 cli::Sweep(option, values, {0, infinity, unit}, dimension)};
  };
  if (!options.theta0.empty()) {
    // Curves are drawn over the load where there is one.
    return Input{
        joint.geometry ? LoadVariable::load : LoadVariable::load_parameter,
        true,
        cli::Sweep("--theta0", options.theta0, {0, 180, "deg"},
                   Dimension::angle)};
  }
  if (!options.load_parameter.empty()) {
    return load(LoadVariable::load_parameter, "--load-parameter",
                options.load_parameter);
  }
  if (!options.x.empty()) return load(LoadVariable::x, "--x", options.x);
  if (options.load.empty()) {
    cli::refuse_without("a load",
                        "one of --load, --load-parameter, --x (see --help)");
  }
  if (!joint.geometry) {
    cli::refuse_without("--load",
                        "--radius and --clearance; a dimensionless joint has "
                        "--load-parameter and --x");
  }
  const bool ball = joint.kind == contact::JointKind::ball;
  return load(LoadVariable::load, "--load", options.load, ball ? "N" : "N/m",
              ball ? Dimension::force : Dimension::line_force);
}

}  // namespace hinge_angle
