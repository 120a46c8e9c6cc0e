// hinge-study: a thousand separations or loads of a joint, and their
// statistics.
#include <limits>

#include "cli/program.hpp"
#include "cli/quantity.hpp"
#include "help/help.hpp"
#include "libcontact/files/key_schema.hpp"
#include "programs/study/run.hpp"
#include "study/plan/plan.hpp"

namespace {

using study::Options;

constexpr int most = std::numeric_limits<int>::max();
constexpr const char* tables = "--rows --merge --csv --hdf5 --plot --report";

void add_study(cli::Program& program, Options& o) {
  program.add(
      "Study",
      {{"--runs", cli::count("--runs", o.runs, 1, 100'000'000), "N",
        "in place of the file's"},
       {"--seed", cli::count("--seed", o.seed, 0, most), "N",
        "in place of the file's"},
       {"--rows", &o.rows, "A:B", "compute these rows only, into the journal",
        "", "--csv --hdf5 --plot --output --report"},
       {"--journal", &o.journal, "FILE",
        "journal of finished rows; default NAME.journal"},
       {"--merge", cli::List{&o.merge, 0}, "FILES", "journals to merge"}});
}

void add_instead(cli::Program& program, Options& o) {
  program.add("Instead of the study",
              {{"--check", &o.check, "", "the draws of ten runs", "", tables},
               {"--quantities", &o.quantities, "",
                "all numbers of the nominal run", "", tables},
               {"--parts", cli::count("--parts", o.parts, 1, 100'000'000), "N",
                "ranges of so many rows, for --rows", "", tables},
               {"--run", cli::count("--run", o.run, 0, most), "N",
                "repeat this run; 0 is the nominal one", "", tables},
               {"--history", &o.history, "FILE",
                "history of --run: .csv, .h5 or .hdf5", "--run"}});
}

void add_output(cli::Program& program, Options& o) {
  program.add_output(o.output);
  program.add("Output", {{"--csv", &o.csv, "FILE", "all rows as CSV"},
                         {"--hdf5", &o.hdf5, "FILE", "all rows as HDF5"},
                         {"--report", &o.report, "NAME.html",
                          "the full report as a page, with pictures"}});
  program.add_jobs(o.output);
  program.describe("--output",
                   "the summary, JSON; or the table of --check, --run,\n"
                   "--quantities");
  program.describe("--format", "format of these tables");
  program.describe("--plot",
                   "pictures NAME_1.svg ... of each requirement,\n"
                   "NAME_ranking, NAME_clearance, NAME_angles");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Studies of scatter: verdicts, bounds, sensitivities",
                       "hinge-study");
  Options options;
  program.add("Study", {{"STUDY.toml", &options.file, "", "the study file", "",
                         "", true}});
  add_study(program, options);
  add_instead(program, options);
  add_output(program, options);
  program.add_schema([] { return contact::schema_text(study::study_keys()); });
  return program.run(argc, argv, help, [&] { return study::run(options); });
}
