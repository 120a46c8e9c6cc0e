// hinge-separation: a carrier and its bodies come apart.

#include "cli/program.hpp"
#include "cli/quantity.hpp"
#include "help/help.hpp"
#include "libcontact/files/key_schema.hpp"
#include "programs/separation/option_check.hpp"
#include "programs/separation/run.hpp"
#include "separation/case/case_keys.hpp"

namespace {

using separation::Options;

void add_run(cli::Program& program, Options& o) {
  using contact::Dimension;
  constexpr cli::Allowed times{1e-9, 1e9, "s"};
  program.add(
      "Run",
      {{"--compare", &o.compare, "",
        "compare ideal, full and traditional friction", "",
        "--no-clearance --history --events --plot --friction --checkpoint "
        "--resume"},
       {"--friction", &o.friction, "NAME",
        "full, ideal or traditional; default: as in the case"},
       {"--end-time",
        cli::number("--end-time", o.end_time, Dimension::number, times),
        "SECONDS", "end of the motion; default: as in the case"},
       {"--set", &o.settings, "KEY=VALUE",
        "value for a key of the case or of its joint files;\nmay be repeated"},
       {"--law", &o.half_angle_law, "NAME",
        "half-angle law of all joints; default: the joints'"},
       {"--pressure", &o.pressure_law, "NAME",
        "pressure law of all joints; default: the joints'"},
       {"--no-clearance", &o.no_clearance, "", "compute no distances"},
       {"--checkpoint", &o.checkpoint, "FILE",
        "checkpoint to write during the run, for --resume"},
       {"--checkpoint-every",
        cli::number("--checkpoint-every", o.checkpoint_every, Dimension::time,
                    times),
        "TIME", "motion between checkpoints, in s or with a unit",
        "--checkpoint"},
       {"--resume", &o.resume, "FILE", "checkpoint to continue from"},
       {"--step-limit",
        cli::count("--step-limit", o.step_limit, 1, 2'000'000'000), "N",
        "stop after N steps and write the results so far"},
       {"--time-limit",
        cli::number("--time-limit", o.time_limit, Dimension::time,
                    {1e-3, 1e9, "s"}),
        "TIME", "stop after this wall-clock time, s or with a unit"}});
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
                   "report, the default on a terminal, or json; table of\n"
                   "--compare: csv (default), json, markdown, latex, report");
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
  program.add_schema(
      [] { return contact::schema_text(separation::case_keys()); });
  return program.run(argc, argv, help, [&] {
    separation::check_options(options, program.has("--format"));
    return separation::run(options);
  });
}
