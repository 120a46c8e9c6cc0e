// hinge-study: a thousand separations or loads of a joint, and what they say.
#include <CLI/CLI.hpp>
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

void add_options(CLI::App& app, Options& options) {
  constexpr int most = std::numeric_limits<int>::max();
  app.add_option("STUDY.toml", options.file, "the study file")
      ->required()
      ->option_text(" ");
  const auto count = [&app](const char* name, const char* what, int least,
                            int largest, auto& to) {
    return app
        .add_option_function<std::string>(
            name,
            [name, least, largest, &to](const std::string& text) {
              to = cli::parse_count(name, text, least, largest);
            },
            what)
        ->option_text("N");
  };
  const auto text = [&app](const char* name, const char* what, const char* kind,
                           auto& to) {
    return app.add_option(name, to, what)->option_text(kind);
  };
  app.option_defaults()->group("Study");
  count("--runs", "instead of the file's", 1, 100'000'000, options.runs);
  count("--seed", "instead of the file's", 0, most, options.seed);
  text("--rows", "computes these only, into the journal", "A:B", options.rows);
  text("--journal", "of rows that are done; default NAME.journal", "FILE",
       options.journal);
  text("--merge", "journals whose rows are taken", "FILES", options.merge);
  app.option_defaults()->group("Instead of the study");
  app.add_flag("--check", options.check, "the draws of ten runs")
      ->option_text(" ");
  app.add_flag("--quantities", options.quantities,
               "all numbers of the nominal run")
      ->option_text(" ");
  count("--parts", "ranges of so many rows, for --rows", 1, 100'000'000,
        options.parts);
  auto* run = count("--run", "this run again; 0 is the nominal one", 0, most,
                    options.run);
  text("--history", "of --run: .csv, .h5 or .hdf5", "FILE", options.history)
      ->needs(run);
  cli::add_output_options(app, options.output);
  text("--csv", "all rows as CSV", "FILE", options.csv);
  text("--hdf5", "all rows as HDF5", "FILE", options.hdf5);
  text("--report", "all that is said as a page, with pictures", "NAME.html",
       options.report);
  cli::add_jobs_option(app, options.output);
  for (const char* other : {"--check", "--quantities", "--parts", "--run"}) {
    cli::exclude(
        app, other,
        {"--rows", "--merge", "--csv", "--hdf5", "--plot", "--report"});
  }
  cli::exclude(app, "--rows",
               {"--csv", "--hdf5", "--plot", "--output", "--report"});
  app.get_option("--output")
      ->description(
          "the summary, JSON; or the table of --check, --run,\n"
          "--quantities");
  app.get_option("--format")->description("of these tables");
  app.get_option("--plot")->description(
      "pictures NAME_1.svg ... of each requirement,\nNAME_ranking, "
      "NAME_clearance, NAME_angles");
  app.footer(std::string(help) + std::string(exit_status_help));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Studies of scatter: verdicts, bounds, what drives them",
               "hinge-study");
  Options options;
  add_options(app, options);
  return cli::run_program(app, argc, argv, [&] { return study::run(options); });
}
