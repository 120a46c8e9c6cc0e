#include "programs/angle/play.hpp"

#include <string>

#include "cli/refuse.hpp"
#include "libcontact/base/constants.hpp"

namespace hinge_angle {

using contact::Dimension;

cli::Joint sized_joint(cli::JointOptions options, const char* for_option) {
  options.laws = {"exact"};
  cli::Joint joint = make_joint(options);
  if (!joint.has_size) {
    cli::refuse_without(for_option, "--radius and --clearance");
  }
  if (joint.is_pin() && !joint.has_length) {
    cli::refuse_without(std::string(for_option) + " of a pin", "--length");
  }
  return joint;
}

void add_play_options(cli::Program& program, PlayOptions& o) {
  using cli::number;
  using contact::detail::infinity;
  program.add(
      "Play",
      {{"--force-law", &o.force_law, "",
        "print the force of a joint with play over the penetration", "",
        "--law --limit-angle --inverse --load-parameter --x --jobs"},
       {"--penetration", &o.penetration, "VALUES",
        "penetrations from first touch, m; without it and --load 400 in equal "
        "ratios",
        "--force-law", "--load"},
       {"--impact", &o.impact, "", "print the impacts of a joint with play",
        "--mass; --speed; --restitution",
        "--force-law --law --limit-angle --inverse --load --load-parameter --x "
        "--compare --plot --jobs"},
       {"--mass",
        number("--mass", o.mass, Dimension::mass, {0, infinity, "kg"}), "MASS",
        "impacting mass; of two bodies m1 m2/(m1 + m2)", "--impact"},
       {"--speed", &o.speed, "VALUES", "speed of approach at first touch, m/s",
        "--impact"},
       {"--restitution",
        number("--restitution", o.restitution, Dimension::number, {0, 1, ""}),
        "E", "ratio of separation speed to touch speed", "--impact"},
       {"--reference-speed",
        number("--reference-speed", o.reference_speed, Dimension::velocity,
               {0, infinity, "m/s"}),
        "SPEED", "speed at which the restitution is E; default: at every speed",
        "--impact"},
       {"--density",
        number("--density", o.density, Dimension::number,
               {0, infinity, "kg/m^3"}),
        "DENSITY", "kg/m^3, for the check that elasticity is quasi-static",
        "--impact"}});
}

}  // namespace hinge_angle
