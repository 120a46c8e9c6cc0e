// hinge-separation: a carrier and its bodies come apart.
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

void add_run(cli::Program& program, Options& o) {
  using contact::Dimension;
  constexpr cli::Allowed times{1e-9, 1e9, "s"};
  program.add(
      "Run",
      {{"--compare", &o.compare, "",
        "ideal, full and traditional friction side by side", "",
        "--no-clearance --history --events --plot --friction --checkpoint "
        "--resume"},
       {"--friction", &o.friction, "NAME",
        "full, ideal or traditional; default: the case's"},
       {"--end-time",
        cli::number("--end-time", o.end_time, Dimension::number, times),
        "SECONDS", "of the motion; default: the case's"},
       {"--set", &o.settings, "KEY=VALUE",
        "another value of a key of the case or of a file of its\n"
        "joints; more than once for several"},
       {"--law", &o.half_angle_law, "NAME",
        "half-angle law of all joints; default: the joints'"},
       {"--pressure", &o.pressure_law, "NAME",
        "pressure law of all joints; default: the joints'"},
       {"--no-clearance", &o.no_clearance, "", "do not work out distances"},
       {"--checkpoint", &o.checkpoint, "FILE",
        "file to write on the way, for --resume"},
       {"--checkpoint-every",
        cli::number("--checkpoint-every", o.checkpoint_every, Dimension::time,
                    times),
        "TIME", "so much of the motion, in s or with a unit", "--checkpoint"},
       {"--resume", &o.resume, "FILE", "checkpoint to go on from"},
       {"--step-limit",
        cli::count("--step-limit", o.step_limit, 1, 2'000'000'000), "N",
        "stop after as many steps, with what there is"},
       {"--time-limit",
        cli::number("--time-limit", o.time_limit, Dimension::time,
                    {1e-3, 1e9, "s"}),
        "TIME", "stop after so much wall-clock time, s or with a unit"}});
}

void add_output(cli::Program& program, Options& o) {
  program.add(
      "Output",
      {{"--history", &o.history, "FILE",
        "time history: .csv, .h5 or .hdf5, - for CSV on stdout"},
       {"--events", &o.events, "FILE", "list of events: .csv, - for stdout"},
       {"--replay", &o.replays, "FILE",
        "the motion in 3D: .html, a page for any browser,\n"
        ".glb (glTF); may be given twice"},
       {"--no-case", &o.no_case, "", "leave the case file out of the page",
        "--replay"}});
  program.add_output(o.output);
  program.describe("--format",
                   "of --compare: csv (default), json, markdown,\nlatex; the "
                   "summary is JSON");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Separation of stages and motion of hinged bodies",
                       "hinge-separation");
  Options options;
  program.add("Run", {{"CASE.toml", &options.case_file, "", "the case file", "",
                       "", true}});
  add_run(program, options);
  add_output(program, options);
  return program.run(
      argc, argv,
      std::string(help) + std::string(cli::exit_status_help) +
          "130, 143: stopped by SIGINT, SIGTERM; the results so far are "
          "there.\n",
      [&] {
        separation::check_options(options, program.has("--format"));
        return separation::run(options);
      });
}
