// hinge-identify: friction parameters of a joint from measured moments.
#include <string>
#include <string_view>

#include "cli/program.hpp"
#include "programs/identify/run.hpp"

namespace {

using hinge_identify::Options;

constexpr std::string_view help = R"(
Finds f0 and A of the friction law f = f0 + A/p, and the radial clearance if it
is asked for, with which the joint has measured moments.

The joint is one of
  --joint FILE.toml           a joint file
  --joint ball --pair FILE.toml --radius R --clearance EPS
  --joint pin --pair FILE.toml --radius R --clearance EPS --length L
)";

constexpr std::string_view data_help = R"(
--data is a CSV file with a line for each state that slides; columns
  R_N,b_deg                  R and its angle from Dw (a pin: R_N alone), or
  R_x_N,R_y_N,R_z_N,w_x_rad_per_s,w_y_rad_per_s,w_z_rad_per_s
  torque_N_m                 moment that turns the joint, -M_t . Dw/|Dw|, or
  M_t_x_N_m,M_t_y_N_m,M_t_z_N_m   friction moment on the body
  sigma_N_m                  standard error of the moment (of each component);
                             without it sqrt(A^2 + (R M)^2) of --sigma-abs A
                             and --sigma-rel R. Their ratios alone count.
  rate_rad_per_s             |Dw| beside R_N, if it is to be looked at
Other columns are left alone; a bad line is refused.

Vary the load, tenfold if it can be had: only mean pressures that differ tell f0
from A. Standard errors are from the scatter of the data; intervals are those of
Student's t; --profile adds intervals by refitting, which a fitted clearance
needs. --huber keeps wrong data off (limit 1.345). A friction coefficient of a
catalogue is a moment: hinge-joint --measured-moment makes f0 of it.

The table has a row for each parameter and for what says how well it is known:
value, standard_error, low, high, profile_low, profile_high, meaning.
--residuals: datum, component (about_rate, x, y, z), R_N, b_deg, rate_rad_per_s,
measured_N_m, sigma_N_m, fit_N_m, fit_error_N_m (standard error of the fit),
residual ((fit - measured)/sigma), weight (Huber's).
--plot draws the data with the fit and its band over the load, and the residuals
over load, direction and rate.

Examples:
  hinge-identify --joint data/duty/torque_rig.toml --data data/duty/torque_rig.csv --format markdown
  hinge-identify --joint data/duty/torque_rig.toml --data data/duty/torque_rig.csv --fit f0,A,clearance --profile
  hinge-identify --joint data/duty/torque_rig.toml --data data/duty/torque_rig.csv --huber --residuals residuals.csv
  printf 'R_N,torque_N_m\n1e3,2.6\n4e3,9.6\n1e4,23\n' | hinge-identify --joint data/joints/pin_joint.toml --data - --sigma-rel 0.01

)";

void add_data(cli::Program& program, Options& o) {
  program.add(
      "Data",
      {{"--data", &o.data, "FILE", "CSV file of moments, - for standard input",
        "", "", true},
       {"--sigma-abs", &o.sigma_abs, "NUMBER", "standard error of all, N m"},
       {"--sigma-rel", &o.sigma_rel, "NUMBER",
        "standard error over the moment"},
       {"--rate", &o.rate, "NUMBER", "|Dw|, rad/s; default 1"}});
}

void add_fit(cli::Program& program, Options& o) {
  program.add(
      "Fit",
      {{"--fit", &o.fit, "LIST", "some of f0, A, clearance; default f0,A"},
       {"--friction", &o.friction, "NUMBER", "f0, if it is not fitted"},
       {"--adhesion", &o.adhesion, "NUMBER", "A, Pa, if it is not fitted"},
       {"--huber", &o.huber, "", "keep wrong data off"},
       {"--profile", &o.profile, "", "intervals by refitting too", "",
        "--huber"},
       {"--level",
        cli::number("--level", o.level, contact::Dimension::number,
                    {0.5, 0.9999, ""}),
        "NUMBER", "probability of intervals; default 0.95"}});
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Friction parameters of a joint from measured moments",
                       "hinge-identify");
  Options options;
  add_joint_options(program, options.joint);
  add_law_options(program, options.joint, cli::Laws::one, cli::Laws::one);
  add_data(program, options);
  add_fit(program, options);
  program.add("Output", {{"--residuals", &options.residuals, "FILE",
                          "CSV file of residuals, - for standard output"}});
  program.add_output(options.output);
  return program.run(argc, argv,
                     std::string(help) + std::string(cli::size_help) +
                         std::string(cli::joint_help) + std::string(data_help) +
                         std::string(cli::exit_status_help),
                     [&] { return hinge_identify::run(options); });
}
