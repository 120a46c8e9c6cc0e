#include "angle/options.hpp"

#include <CLI/CLI.hpp>

#include "cli/laws.hpp"

namespace hinge_angle {

void add_joint_options(CLI::App& app, Options& options) {
  app.add_option("--joint", options.joint, "ball, pin or a joint file")
      ->option_text("KIND|FILE")
      ->required()
      ->group("Joint");
  auto* pair = app.add_option("--pair", options.pair,
                              "materials of the two bodies, a TOML file")
                   ->option_text("FILE")
                   ->group("Joint");
  auto* radius = app.add_option("--radius", options.radius,
                                "of the ball or pin, m or with a unit")
                     ->option_text("LENGTH")
                     ->needs(pair)
                     ->group("Joint");
  auto* clearance = app.add_option("--clearance", options.clearance,
                                   "radial, m or with a unit")
                        ->option_text("LENGTH")
                        ->needs(radius)
                        ->group("Joint");
  radius->needs(clearance);
  auto* ratio = app.add_option("--modulus-ratio", options.modulus_ratio,
                               "E1/E2, 0 to inf")
                    ->option_text("NUMBER")
                    ->excludes(pair)
                    ->group("Joint");
  app.add_option("--poisson1", options.poisson1,
                 "of the ball or pin; default 0.3")
      ->option_text("NUMBER")
      ->needs(ratio)
      ->group("Joint");
  app.add_option("--poisson2", options.poisson2,
                 "of the seat or hole; default 0.3")
      ->option_text("NUMBER")
      ->needs(ratio)
      ->group("Joint");
  cli::add_loading_option(app, options.loading, "Joint");
}

void add_load_options(CLI::App& app, Options& options) {
  app.add_option("--load", options.load, "N, or N/m for a pin")
      ->option_text("VALUES")
      ->group("Load");
  app.add_option("--load-parameter", options.load_parameter, "mu or lambda")
      ->option_text("VALUES")
      ->group("Load");
  app.add_option("--x", options.x, "cbrt(mu) or 2 sqrt(lambda)")
      ->option_text("VALUES")
      ->group("Load");
}

}  // namespace hinge_angle
