#include "programs/study/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/interrupts.hpp"
#include "cli/joint/shipped.hpp"
#include "cli/number.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/file_name.hpp"
#include "cli/stream/quoting.hpp"
#include "cli/stream/report.hpp"
#include "cli/stream/verdict.hpp"
#include "programs/separation/output/history_file.hpp"
#include "programs/study/findings/findings.hpp"
#include "programs/study/findings/pictures.hpp"
#include "programs/study/findings/report.hpp"
#include "programs/study/report_file.hpp"
#include "programs/study/rows_file.hpp"
#include "separation/results/run.hpp"
#include "study/rows/journal.hpp"
#include "study/workers.hpp"

namespace study {
namespace {

constexpr const char* program = "hinge-study";

PlanChanges changes_of(const Options& o) {
  PlanChanges changes;
  if (o.runs > 0) changes.runs = static_cast<std::uint64_t>(o.runs);
  if (o.seed) changes.seed = static_cast<std::uint64_t>(*o.seed);
  return changes;
}

// The options on which a run of this study depends.
std::string command_of(const Options& o) {
  std::string command = fmt::format("{} {}", program, cli::shell_word(o.file));
  if (o.runs > 0) command += fmt::format(" --runs {}", o.runs);
  if (o.seed) command += fmt::format(" --seed {}", *o.seed);
  return command;
}

// Rows to compute: "A:B", or all.
struct Range {
  std::uint64_t first;
  std::uint64_t last;
};
Range range_of(const Options& o, const Study& study) {
  if (o.rows.empty()) return {0, study.runs()};
  const auto colon = o.rows.find(':');
  const auto first = cli::parse_number(o.rows.substr(0, colon));
  const auto last = colon == o.rows.npos
                        ? first
                        : cli::parse_number(o.rows.substr(colon + 1));
  const auto whole = [&](const std::optional<double>& x) {
    return x && *x >= 0 && *x <= static_cast<double>(study.runs()) &&
           *x == std::floor(*x);
  };
  if (!whole(first) || !whole(last) || *first > *last) {
    cli::refuse("--rows", o.rows,
                fmt::format("A:B, whole numbers, 0 to {}", study.runs()));
  }
  return {static_cast<std::uint64_t>(*first),
          static_cast<std::uint64_t>(*last)};
}

std::string journal_of(const Options& o) {
  if (!o.journal.empty()) return o.journal;
  return std::filesystem::path(o.file).stem().string() + ".journal";
}

cli::ExitStatus list_quantities(const Options& o, const Study& study) {
  cli::Output output(o.output.output);
  cli::write_table(o.output.of_quantity({"nominal"}), {"quantity", "nominal"},
                   output, [&](cli::RowWriter& cells) {
                     for (const auto& [name, value] : study.nominal()) {
                       cells.text(name);
                       cells.number(value);
                       cells.end();
                     }
                   });
  output.commit();
  return cli::all_good;
}

cli::ExitStatus check(const Options& o, const Study& study) {
  std::vector<std::string> names = {"run"};
  for (const Draw& draw : study.design().draws()) names.push_back(draw.name);
  constexpr std::uint64_t shown = 10;
  cli::write_table(o.output, names, [&](cli::RowWriter& cells) {
    for (std::uint64_t run = 1; run <= std::min(shown, study.runs()); ++run) {
      cells.count(run);
      for (const double x : study.design().numbers(run)) cells.number(x);
      cells.end();
    }
  });
  return cli::all_good;
}

// --rows: lists ranges that cover all rows, one per line.
cli::ExitStatus list_parts(const Options& o, const Study& study) {
  cli::Output output(o.output.output);
  const auto size = static_cast<std::uint64_t>(o.parts);
  for (std::uint64_t first = 0; first <= study.runs(); first += size) {
    output.write(fmt::format("{}:{}\n", first,
                             std::min(first + size - 1, study.runs())));
  }
  output.commit();
  return cli::all_good;
}

// Repeats a run bit-identically, with its history.
cli::ExitStatus repeat(const Options& o, const Study& study) {
  const auto run = static_cast<std::uint64_t>(*o.run);
  if (run > study.runs()) {
    cli::refuse("--run", fmt::format("{}", run),
                fmt::format("0 to {}", study.runs()));
  }
  if (!o.history.empty()) {
    const separation::Case c = study.case_of(run);
    cli::TableStyle style = o.output;
    style.format = cli::Format::csv;
    separation::HistoryFile history(o.history, style,
                                    separation::history_columns(c, true));
    history.write(separation::run_case(c).memory.rows);
  }
  const Row row = study.row(run);
  const auto names = study.columns();
  cli::write_table(o.output, {"name", "value"}, [&](cli::RowWriter& cells) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      cells.text(names[i]);
      cells.number(row.numbers[i]);
      cells.end();
    }
  });
  if (row.failure.empty()) return cli::all_good;
  cli::warn(program, "the run failed: " + row.failure);
  return cli::some_bad;
}

// On a terminal: reports the speed, and the remaining time.
class Pace {
 public:
  explicit Pace(std::size_t total) : total_(total) {}
  void add() {
    ++done_;
    if (!progress_.is_terminal() || !progress_.is_due()) return;
    const double seconds =
        std::chrono::duration<double>(Clock::now() - begin_).count();
    const double rate = static_cast<double>(done_) / seconds;
    progress_.say(fmt::format("{} of {} runs, {:.3g} runs/s, {:.0f} s left",
                              done_, total_, rate,
                              static_cast<double>(total_ - done_) / rate));
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::size_t total_;
  std::size_t done_ = 0;
  Clock::time_point begin_ = Clock::now();
  cli::Progress progress_;
};

// Other journals, from which rows are taken.
std::vector<std::unique_ptr<Journal>> parts_of(const Options& o,
                                               const Study& study) {
  std::vector<std::unique_ptr<Journal>> parts;
  for (const std::string& name : o.merge) {
    parts.push_back(std::make_unique<Journal>(
        name, study.identity(), study.columns(), Journal::Use::read));
  }
  return parts;
}

// Computes the rows of a range that are in no journal. A signal ends this
// between rows; later signals end the program as usual.
cli::ExitStatus compute_missing(const Options& o, const Study& study,
                                const Range& range, Journal& journal) {
  const auto missing = journal.missing(range.first, range.last);
  const std::string forecast = study.forecast(missing.size(), o.output.jobs);
  if (!forecast.empty()) cli::note(program, forecast);
  const cli::Interrupts interrupts;
  Pace pace(missing.size());
  compute(
      study, missing, o.output.jobs, journal,
      [&] { return interrupts.signal() == 0 ? "" : "a signal"; },
      [&] { pace.add(); });
  if (interrupts.signal() == 0) return cli::all_good;
  cli::warn(
      program,
      fmt::format("stopped: {} rows are in {}; repeat the command to continue",
                  journal.size(), journal_of(o)));
  return interrupts.status(cli::all_good);
}

void write_results(const Options& o, const Study& study,
                   const Findings& findings, const Journal& journal) {
  if (!o.csv.empty()) write_csv(study, journal, o.output, o.csv);
  if (!o.hdf5.empty()) write_hdf5(study, journal, o.hdf5);
  if (!o.output.output.empty()) {
    cli::Output output(o.output.output);
    output.write(to_json(study, findings).dump(2) + '\n');
    output.commit();
    if (o.output.output == "-") return;
  }
  cli::Output text("");
  const bool colour = o.output.report.colour;
  const std::string said =
      o.output.format == cli::Format::report
          ? to_report(study, findings, command_of(o), o.output.report)
          : to_text(study, findings, command_of(o));
  if (colour && o.output.format == cli::Format::report) {
    text.write_coloured(said);
  } else if (colour) {
    text.write_coloured(cli::with_coloured_verdicts(cli::terminal_text(said)));
  } else {
    text.write(said);
  }
  text.commit();
}

cli::ExitStatus run_study(const Options& o, const Study& study,
                          cli::OutputNames& names) {
  const Range range = range_of(o, study);
  const auto parts = parts_of(o, study);
  Journal journal(journal_of(o), study.identity(), study.columns(),
                  Journal::Use::write);
  for (const auto& part : parts) journal.take(*part, study.runs());
  cli::ExitStatus status = compute_missing(o, study, range, journal);
  if (status != cli::all_good || !o.rows.empty()) return status;
  journal.hold();
  const Findings findings = find(study, journal);
  write_results(o, study, findings, journal);
  if (findings.above_limit > 0) {
    cli::warn(program, above_limit_text(study, findings));
  }
  if (findings.failed > 0) status = cli::some_bad;
  if (o.output.plot.empty() && o.report.empty()) return status;
  const std::vector<Picture> pictures = pictures_of(study, findings, journal);
  if (!o.report.empty() && !write_report(study, findings, pictures,
                                         command_of(o), o.report, names)) {
    status = cli::some_bad;
  }
  if (o.output.plot.empty()) return status;
  return cli::drawn(program, draw(pictures, o.output.plot), status);
}

cli::OutputNames check_outputs(const Options& o) {
  if (!o.report.empty() && !cli::is_page(o.report)) {
    cli::refuse("--report", o.report, "a name that ends in .html");
  }
  cli::OutputNames names = names_of(o.output);
  names.add("--csv", o.csv);
  names.add("--hdf5", o.hdf5);
  names.add("--report", o.report);
  names.add("--history", o.history);
  for (const char* end : {"", "-wal", "-shm", "-journal"}) {
    names.keep("--journal", journal_of(o) + end);
  }
  return names;
}

// Prints the warnings on the nominal run.
void say_warnings(const Study& study) {
  for (const std::string& warning : study.warnings()) {
    cli::warn(program, "nominal run: " + warning);
  }
}

}  // namespace

cli::ExitStatus run(const Options& o) {
  cli::OutputNames names = check_outputs(o);
  const Study study = cli::read_as("a study file", program, o.file, [&] {
    return Study(o.file, changes_of(o));
  });
  if (!o.output.plot.empty()) {
    for (const std::string& file : picture_files(study, o.output.plot)) {
      names.keep("--plot", file);
    }
  }
  if (o.parts > 0) return list_parts(o, study);
  if (o.run) return repeat(o, study);
  // Parts of a study leave the warnings to the complete study.
  if (o.rows.empty()) say_warnings(study);
  if (o.quantities) return list_quantities(o, study);
  if (o.check) return check(o, study);
  return run_study(o, study, names);
}

}  // namespace study
