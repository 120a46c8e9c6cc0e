#include "programs/angle/input.hpp"

#include <utility>

#include "cli/program.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/constants.hpp"

namespace hinge_angle {

using contact::Dimension;

void add_load_options(cli::Program& program, LoadOptions& o) {
  program.add("Load",
              {{"--load", &o.load, "VALUES",
                "load in N or with a unit; N/m of a pin without a length", "",
                "--load-parameter --x"},
               {"--load-parameter", &o.load_parameter, "VALUES", "mu or lambda",
                "", "--x"},
               {"--x", &o.x, "VALUES", "cbrt(mu) or 2 sqrt(lambda)"}});
}

namespace {

using contact::detail::infinity;

// Reads --load; its unit may tell whether it is a force or, for a pin, a force
// per length.
Input load_input(const std::string& text, const cli::Joint& joint) {
  if (!joint.has_size) {
    cli::refuse_without("--load",
                        "--radius and --clearance; for a joint without a size "
                        "use --load-parameter or --x");
  }
  const bool pin = joint.is_pin();
  const auto unit =
      cli::unit_dimension(text, {Dimension::force, Dimension::line_force});
  if (pin && unit == Dimension::force && !joint.has_length) {
    cli::refuse_without(cli::given("--load", text), "--length");
  }
  const bool per_length =
      pin && (unit ? unit == Dimension::line_force : !joint.has_length);
  // Without a length the load is per length.
  return {per_length && joint.has_length ? LoadVariable::line_load
                                         : LoadVariable::load,
          false,
          cli::Sweep("--load", text, {0, infinity, per_length ? "N/m" : "N"},
                     per_length ? Dimension::line_force : Dimension::force)};
}

// Load parameters of a joint without clearance are infinite or negative.
void check_clearance(const LoadOptions& options, const cli::Joint& joint) {
  if (!joint.has_size || joint.spec.geometry.radial_clearance() > 0) return;
  for (const auto& [flag, given] :
       {std::pair("--load-parameter", &options.load_parameter),
        {"--x", &options.x}}) {
    if (!given->empty()) {
      cli::refuse_without(
          flag, "a clearance above 0; for a joint without one use --load");
    }
  }
}

}  // namespace

Input make_input(const LoadOptions& options, const cli::Joint& joint) {
  if (!options.theta0.empty()) {
    // Curves are drawn over the load where there is one.
    return {joint.has_size ? LoadVariable::load : LoadVariable::load_parameter,
            true,
            cli::Sweep("--theta0", options.theta0, {0, 180, "deg"},
                       Dimension::angle)};
  }
  check_clearance(options, joint);
  if (!options.load_parameter.empty()) {
    return {LoadVariable::load_parameter, false,
            cli::Sweep("--load-parameter", options.load_parameter,
                       {0, infinity, ""})};
  }
  if (!options.x.empty()) {
    return {LoadVariable::x, false,
            cli::Sweep("--x", options.x, {0, infinity, ""})};
  }
  if (options.load.empty()) {
    cli::refuse_without("a load",
                        "one of --load, --load-parameter, --x (see --help)");
  }
  return load_input(options.load, joint);
}

}  // namespace hinge_angle
