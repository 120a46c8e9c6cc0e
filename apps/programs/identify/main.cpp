// hinge-identify: friction parameters of a joint from measured moments.

#include "cli/program.hpp"
#include "help/help.hpp"
#include "programs/identify/run.hpp"

namespace {

using contact::Dimension;
using hinge_identify::Options;

void add_data(cli::Program& program, Options& o) {
  program.add("Data",
              {{"--data", &o.data, "FILE",
                "CSV file of moments, - for standard input", "", "", true},
               {"--sigma-abs",
                cli::number("--sigma-abs", o.sigma_abs, Dimension::moment,
                            {0, 1e100, "N m"}),
                "NUMBER", "standard error of all moments, N m"},
               {"--sigma-rel",
                cli::number("--sigma-rel", o.sigma_rel, Dimension::number,
                            {0, 1e3, ""}),
                "NUMBER", "standard error over the moment"},
               {"--rate",
                cli::number("--rate", o.rate, Dimension::angular_velocity,
                            {0, 1e100, "rad/s"}),
                "NUMBER", "|Dw|, rad/s; default 1"}});
}

void add_fit(cli::Program& program, Options& o) {
  program.add(
      "Fit",
      {{"--fit", &o.fit, "LIST",
        "some of f0, A, clearance, drag, offset; default f0,A"},
       {"--huber", &o.huber, "", "reduce the weight of outliers (Huber's loss)",
        "", "--profile"},
       {"--profile", &o.profile, "", "add intervals by refitting"},
       {"--level",
        cli::number("--level", o.level, Dimension::number, {0.5, 0.9999, ""}),
        "NUMBER", "probability of intervals; default 0.95"}});
  program.add("Fit", dry_friction_rows(o.friction));
  program.describe("--friction", "f0, if not fitted");
  program.describe("--adhesion", "A, Pa, if not fitted");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Friction parameters of a joint from measured moments",
                       "hinge-identify");
  Options options;
  add_joint_options(program, options.joint);
  add_data(program, options);
  add_fit(program, options);
  add_law_options(program, options.joint, cli::Laws::one, cli::Laws::one);
  program.add("Output", {{"--residuals", &options.residuals, "FILE",
                          "CSV file of residuals, - for standard output"}});
  program.add_output(options.output);
  add_fileless_joint_options(program, options.joint);
  return program.run(argc, argv, help,
                     [&] { return hinge_identify::run(options); });
}
