// hinge-pressure: contact pressure of a joint under load.

#include "cli/program.hpp"
#include "help/help.hpp"
#include "programs/pressure/run.hpp"

namespace {

using hinge_pressure::Options;

void add_options(cli::Program& program, Options& o) {
  add_joint_options(program, o.joint);
  hinge_angle::add_load_options(program, o.load);
  add_law_options(program, o.joint, cli::Laws::one, cli::Laws::several);
  program.add("Seat",
              {{"--direction", &o.direction, "ANGLES",
                "angle of the load from the axis of the [seat], deg, 0 to 180",
                "--load", "--load-parameter --x --summary --law --pressure"}});
  add_tilt_options(program, o.tilt, "--load",
                   "--load-parameter --x --summary --direction --law "
                   "--limit-angle --pressure");
  program.add(
      "Profile",
      {{"--summary", &o.summary, "",
        "peak, mean, area and S instead of profiles", "", "--points"},
       {"--points", cli::count("--points", o.points, 2, 1'000'000), "N",
        "rows from the centre to the edge, default 101; with --direction, "
        "--tilt and --load-at rows along each side of a map"}});
  program.add_output(o.output);
  add_fileless_joint_options(program, o.joint);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Contact pressure of a ball or pin joint under load",
                       "hinge-pressure");
  Options options;
  add_options(program, options);
  return program.run(argc, argv, help,
                     [&] { return hinge_pressure::run(options); });
}
