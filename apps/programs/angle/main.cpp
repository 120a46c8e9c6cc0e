// hinge-angle: half-angle of the contact against load.

#include "cli/program.hpp"
#include "help/help.hpp"
#include "programs/angle/run.hpp"

namespace {

using hinge_angle::Options;

void add_options(cli::Program& program, Options& o) {
  add_joint_options(program, o.joint);
  add_load_options(program, o.load);
  program.add("Load", {{"--inverse", &o.inverse, "", "loads from half-angles",
                        "--theta0", "--load --load-parameter --x"},
                       {"--theta0", &o.load.theta0, "ANGLES",
                        "half-angles, deg, 0 to 180", "--inverse"}});
  add_law_options(program, o.joint, cli::Laws::several, cli::Laws::one);
  add_tilt_options(program, o.tilt, "--load",
                   "--inverse --load-parameter --x --compare --force-law "
                   "--impact --plot --jobs --law --limit-angle --pressure");
  add_play_options(program, o.play);
  program.add("Law", {{"--compare", &o.compare, "",
                       "compare each law with exact over the range of loads",
                       "", "--inverse --pressure --jobs"},
                      {"--tolerance",
                       cli::number("--tolerance", o.tolerance,
                                   contact::Dimension::number, {0, 100, "%"}),
                       "PERCENT",
                       "tolerance of --compare, percent of theta0; default 0.1",
                       "--compare"}});
  program.add_output(o.output);
  program.add_jobs(o.output);
  add_fileless_joint_options(program, o.joint);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program(
      "Half-angle of the contact of a ball or pin joint against load",
      "hinge-angle");
  Options options;
  add_options(program, options);
  return program.run(argc, argv, help,
                     [&] { return hinge_angle::run(options); });
}
