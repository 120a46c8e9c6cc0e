#include "programs/study/report_file.hpp"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <optional>

#include "cli/gnuplot.hpp"
#include "cli/output.hpp"
#include "cli/program.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "programs/separation/replay/page.hpp"
#include "programs/separation/warnings.hpp"
#include "programs/study/findings/page.hpp"
#include "separation/results/run.hpp"

namespace study {
namespace {

using separation::PageParts;

void warn(const std::string& text) { cli::warn("hinge-study", text); }

void write_file(const std::string& name, const std::string& text) {
  cli::Output output(name);
  output.write(text);
  output.commit();
}

// @param missing  set if some of them, but not all, are missing
std::map<std::string, std::string> drawn(const std::vector<Picture>& pictures,
                                         const std::string& file,
                                         bool& missing) {
  std::map<std::string, std::string> result;
  std::string problem;
  for (const auto& [name, script] : pictures) {
    if (script.empty()) continue;
    try {
      result[name] = cli::svg_of(script);
    } catch (const contact::Error& error) {
      problem = error.what();
    }
  }
  missing = !problem.empty() && !result.empty();
  if (!problem.empty()) {
    warn(fmt::format("{} pictures in {}: {}", missing ? "not all" : "no", file,
                     problem));
  }
  return result;
}

std::optional<PageParts> parts_of_replays(const std::string& file) {
  try {
    return PageParts("a replay of each worst run beside " + file);
  } catch (const contact::Error& error) {
    warn(error.what());
    return {};
  }
}

// The nominal case, and the differing values of the run.
std::string case_text(const Study& study, const separation::Case& c,
                      std::uint64_t run) {
  std::string text = contact::detail::file_text(c.file);
  if (run == 0) return text;
  const auto& draws = study.design().draws();
  const std::vector<double> numbers = study.design().numbers(run);
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const bool relative =
        study.plan().dispersions[draws[i].dispersion].relative;
    text += fmt::format("\n# run {}: {} = {}{}", run, draws[i].name,
                        relative ? "*" : "", numbers[i]);
  }
  return text;
}

// A run repeated for its replay.
struct Repeated {
  explicit Repeated(const Study& study, std::uint64_t run)
      : of(study.case_of(run)), outcome(separation::run_case(of)) {}
  separation::Case of;
  separation::Outcome outcome;
};

// A replay shows the run beside the nominal one, which is faint.
std::string replay_of(const Study& study, std::uint64_t run,
                      const Repeated& nominal, const PageParts& parts) {
  const Repeated worst(study, run);
  const separation::Case& c = worst.of;
  separation::Warnings warnings(false);
  warn_of_joints(c, warnings);
  warn_of_run(c, worst.outcome, warnings);
  separation::Replay replay{c,
                            {{fmt::format("run {}", run), &worst.outcome},
                             {"nominal", &nominal.outcome, &nominal.of}},
                            {},
                            case_text(study, c, run)};
  warn_of_replay(replay, warnings);
  return separation::replay_page(replay, parts).text;
}

// The file as written; a pipe has already been read.
std::string study_text(const Plan& plan) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(plan.path, ignored)
             ? contact::detail::file_text(plan.path.string())
             : plan.file.toml_text();
}

}  // namespace

bool write_report(const Study& study, const Findings& findings,
                  const std::vector<Picture>& pictures,
                  const std::string& command, const std::string& file,
                  cli::OutputNames& names) {
  bool missing = false;
  PageExtras extras{
      drawn(pictures, file, missing), {}, study_text(study.plan())};
  std::optional<PageParts> parts;
  std::optional<Repeated> nominal;
  if (study.plan().joint_file.empty() && !findings.requirements.empty()) {
    parts = parts_of_replays(file);
    if (parts) nominal.emplace(study, 0);
  }
  bool good = !missing;
  for (const Judgement& judgement : findings.requirements) {
    for (const RunValue& worst : judgement.worst) {
      if (!parts || extras.replays.contains(worst.run)) continue;
      std::filesystem::path name(file);
      name.replace_filename(fmt::format("{}_run{}{}", name.stem().string(),
                                        worst.run, name.extension().string()));
      try {
        names.keep("--report", name.string());
        write_file(name.string(),
                   replay_of(study, worst.run, *nominal, *parts));
        extras.replays[worst.run] = name.filename().string();
      } catch (const std::exception& error) {
        warn(fmt::format("no replay of run {}: {}", worst.run, error.what()));
        good = false;
      }
    }
  }
  try {
    write_file(file, report_page(study, findings, command, extras));
  } catch (const contact::Error& error) {
    warn(fmt::format("no report: {}", error.what()));
    good = false;
  }
  return good;
}

}  // namespace study
