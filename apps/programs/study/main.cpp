// hinge-study: a thousand separations or loads of a joint, and what they say.
#include <limits>
#include <string>
#include <string_view>

#include "cli/program.hpp"
#include "cli/quantity.hpp"
#include "programs/study/run.hpp"

namespace {

using study::Options;

constexpr std::string_view help = R"(
The study file says which keys of a case or a joint scatter and how, and what is
required: apps/study/study_file.md, examples in data/studies.

Standard output has the table for people: verdict of each requirement, bounds,
percentiles, what drives the numbers, keys without effect, the worst runs.
--output has the same as JSON, --csv and --hdf5 a row for each run: run, inputs,
quantities, status. --report NAME.html is all of it as one page with pictures,
which opens in a browser without a network; the worst runs of a case link to
their replays beside it, NAME_runN.html. Where gnuplot or three.js is missing
the page has tables alone, and a warning says so.

Every row is in the journal as soon as it is done. A study that was stopped,
however, goes on by the same command, to the same bytes. For several machines:
--rows A:B --journal PART computes a part, --merge PART ... takes the rows of
other journals, and what is missing is computed.

Examples:
  hinge-study data/studies/lined_bearing.toml --runs 100 --output bearing.json --csv bearing.csv
  hinge-study data/studies/soyuz.toml --check --format markdown
  hinge-study data/studies/soyuz.toml --runs 50 --report soyuz_study.html
  hinge-study data/studies/soyuz.toml --run 17 --history run17.csv
  hinge-study data/studies/soyuz.toml --quantities --format markdown

)";

constexpr std::string_view exit_status_help =
    "Exit status: 0 all computed, whatever the verdicts; 1 a run, a picture "
    "or\n"
    "the report failed and the rest is there; 2 bad option or file, no "
    "result;\n"
    "130, 143: stopped by SIGINT, SIGTERM; the rows so far are in the "
    "journal.\n";

constexpr int most = std::numeric_limits<int>::max();
constexpr const char* tables = "--rows --merge --csv --hdf5 --plot --report";

void add_study(cli::Program& program, Options& o) {
  program.add("Study", {{"--runs", cli::count("--runs", o.runs, 1, 100'000'000),
                         "N", "instead of the file's"},
                        {"--seed", cli::count("--seed", o.seed, 0, most), "N",
                         "instead of the file's"},
                        {"--rows", &o.rows, "A:B",
                         "computes these only, into the journal", "",
                         "--csv --hdf5 --plot --output --report"},
                        {"--journal", &o.journal, "FILE",
                         "of rows that are done; default NAME.journal"},
                        {"--merge", cli::List{&o.merge, 0}, "FILES",
                         "journals whose rows are taken"}});
}

void add_instead(cli::Program& program, Options& o) {
  program.add("Instead of the study",
              {{"--check", &o.check, "", "the draws of ten runs", "", tables},
               {"--quantities", &o.quantities, "",
                "all numbers of the nominal run", "", tables},
               {"--parts", cli::count("--parts", o.parts, 1, 100'000'000), "N",
                "ranges of so many rows, for --rows", "", tables},
               {"--run", cli::count("--run", o.run, 0, most), "N",
                "this run again; 0 is the nominal one", "", tables},
               {"--history", &o.history, "FILE", "of --run: .csv, .h5 or .hdf5",
                "--run"}});
}

void add_output(cli::Program& program, Options& o) {
  program.add_output(o.output);
  program.add("Output", {{"--csv", &o.csv, "FILE", "all rows as CSV"},
                         {"--hdf5", &o.hdf5, "FILE", "all rows as HDF5"},
                         {"--report", &o.report, "NAME.html",
                          "all that is said as a page, with pictures"}});
  program.add_jobs(o.output);
  program.describe("--output",
                   "the summary, JSON; or the table of --check, --run,\n"
                   "--quantities");
  program.describe("--format", "of these tables");
  program.describe("--plot",
                   "pictures NAME_1.svg ... of each requirement,\n"
                   "NAME_ranking, NAME_clearance, NAME_angles");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program program("Studies of scatter: verdicts, bounds, what drives them",
                       "hinge-study");
  Options options;
  program.add("Study", {{"STUDY.toml", &options.file, "", "the study file", "",
                         "", true}});
  add_study(program, options);
  add_instead(program, options);
  add_output(program, options);
  return program.run(argc, argv,
                     std::string(help) + std::string(exit_status_help),
                     [&] { return study::run(options); });
}
