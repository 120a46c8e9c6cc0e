// hinge-separation: a carrier and its bodies come apart.
#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "cli/program.hpp"
#include "cli/quantity.hpp"
#include "programs/separation/option_check.hpp"
#include "programs/separation/run.hpp"

namespace {

using separation::Options;

constexpr std::string_view help = R"(
The case file says what the bodies, hinges, forces and events are; its keys
are in apps/separation/case_file.md, examples in data/cases.

The summary (JSON, --output) has the events, for each body peak reactions,
work of friction, time at rest, angle and rates at release, for each joint
peak reaction, peak pressure and largest half-angle theta0, the smallest
clearances and the energy balance. Peaks and smallest clearances are looked for
within the steps too.
Angles are in degrees, all else in SI units; the keys name the unit.

Columns of the history: time_s; of each body with a hinge NAME.mode (sliding,
resting, locked, released), .angle_deg, .rate_deg_per_s,
.acceleration_deg_per_s2, .reaction_N, .lock_reaction_N, .friction_moment_N_m,
.utilisation, .theta0_deg, .peak_pressure_Pa, .friction_work_J, .reaction_x_N to
.reaction_z_N, .lock_reaction_x_N to .lock_reaction_z_N, .friction_moment_x_N_m
to .friction_moment_z_N_m (on the body, inertial axes; the work is what
friction has taken, never negative); of each body
NAME.x_m to .z_m and .vx_m_per_s to .vz_m_per_s (centre of mass, inertial
axes), .qw to .qz (body axes to inertial ones), .wx_rad_per_s to .wz_rad_per_s
(body axes); clearance.A.B_m; energy.*_J.

--columns chooses columns of the history, of CSV and HDF5, or of --compare.

--compare runs the case with ideal joints, full friction and the traditional
estimate (friction from the reaction instead of the normal force).

--plot NAME.svg draws NAME_angles.svg, NAME_rates.svg, NAME_reactions.svg (with
hinges) and NAME_clearance.svg (with shapes).

--replay NAME.html is one page with the bodies in motion, their reactions,
friction and contacts, curves, events, summary, warnings and the case file, which
opens in a browser without a network. --replay NAME.glb has the bodies and their
motion for other viewers. With --compare both show full friction and, faint,
ideal joints.

A run that goes on with --resume FILE from a checkpoint comes to the same
results to the last byte, and goes on with checkpoints as often as before. With
--end-time it ends later or earlier than the case says; output times stay.

A run that stops early, at --step-limit, --time-limit or by SIGINT or SIGTERM,
writes its results so far, as one that fails does, and says what held it.

Examples:
  hinge-separation data/cases/soyuz.toml --history soyuz.csv --output soyuz.json
  hinge-separation data/cases/two_stage_turn.toml --compare --format markdown
  hinge-separation data/cases/flywheels.toml --friction ideal
  hinge-separation data/cases/soyuz.toml --set run.end_time_s=3 --set 'body[booster].hinge.joint[1].friction.coefficient=0.2'
  hinge-separation data/cases/slosh.toml --history slosh.h5 --events slosh_events.csv
  hinge-separation data/cases/soyuz.toml --replay soyuz.html --replay soyuz.glb
  hinge-separation data/cases/platform.toml --checkpoint platform.db --checkpoint-every 2

)";

void add_options(CLI::App& app, Options& options) {
  const cli::TextOptions add_text(app);
  app.add_option("CASE.toml", options.case_file, "the case file")
      ->required()
      ->option_text(" ");
  app.option_defaults()->group("Run");
  app.add_flag("--compare", options.compare,
               "ideal, full and traditional friction side by side")
      ->option_text(" ");
  add_text("--friction", options.friction,
           "full, ideal or traditional; default: the case's", "NAME");
  app.add_option_function<std::string>(
         "--end-time",
         [&options](const std::string& text) {
           options.end_time =
               cli::parse_value("--end-time", text, {1e-9, 1e9, "s"});
         },
         "of the motion; default: the case's")
      ->option_text("SECONDS");
  app.add_option("--set", options.settings,
                 "another value of a key of the case or of a file of its\n"
                 "joints; more than once for several")
      ->option_text("KEY=VALUE")
      ->allow_extra_args(false);
  add_text("--law", options.half_angle_law,
           "half-angle law of all joints; default: the joints'", "NAME");
  add_text("--pressure", options.pressure_law,
           "pressure law of all joints; default: the joints'", "NAME");
  app.add_flag("--no-clearance", options.no_clearance,
               "do not work out distances")
      ->option_text(" ");
  auto* checkpoint = add_text("--checkpoint", options.checkpoint,
                              "file to write on the way, for --resume", "FILE");
  app.add_option_function<std::string>(
         "--checkpoint-every",
         [&options](const std::string& text) {
           options.checkpoint_every =
               cli::parse_quantity("--checkpoint-every", text,
                                   contact::Dimension::time, {1e-9, 1e9, "s"});
         },
         "so much of the motion, in s or with a unit")
      ->option_text("TIME")
      ->needs(checkpoint);
  add_text("--resume", options.resume, "checkpoint to go on from", "FILE");
  app.add_option_function<std::string>(
         "--step-limit",
         [&options](const std::string& text) {
           constexpr int most = 2'000'000'000;
           options.step_limit = cli::parse_count("--step-limit", text, 1, most);
         },
         "stop after as many steps, with what there is")
      ->option_text("N");
  app.add_option_function<std::string>(
         "--time-limit",
         [&options](const std::string& text) {
           options.time_limit =
               cli::parse_quantity("--time-limit", text,
                                   contact::Dimension::time, {1e-3, 1e9, "s"});
         },
         "stop after so much wall-clock time, s or with a unit")
      ->option_text("TIME");
  app.option_defaults()->group("Output");
  add_text("--history", options.history,
           "time history: .csv, .h5 or .hdf5, - for CSV on stdout", "FILE");
  add_text("--events", options.events, "list of events: .csv, - for stdout",
           "FILE");
  auto* replay =
      app.add_option("--replay", options.replays,
                     "the motion in 3D: .html, a page for any browser,\n"
                     ".glb (glTF); may be given twice")
          ->option_text("FILE")
          ->expected(1)
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
          ->allow_extra_args(false);
  app.add_flag("--no-case", options.no_case,
               "leave the case file out of the page")
      ->option_text(" ")
      ->needs(replay);
  cli::add_output_options(app, options.output);
  cli::exclude(app, "--compare",
               {"--no-clearance", "--history", "--events", "--plot",
                "--friction", "--checkpoint", "--resume"});
  app.get_option("--format")
      ->description(
          "of --compare: csv (default), json, markdown,\nlatex; the summary is "
          "JSON");
  app.footer(std::string(help) + std::string(cli::exit_status_help) +
             "130, 143: stopped by SIGINT, SIGTERM; the results so far are "
             "there.\n");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Separation of stages and motion of hinged bodies",
               "hinge-separation");
  Options options;
  add_options(app, options);
  return cli::run_program(app, argc, argv, [&] {
    separation::check_options(options, app.count("--format") > 0);
    return separation::run(options);
  });
}
