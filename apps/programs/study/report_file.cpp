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

std::map<std::string, std::string> drawn(const std::vector<Picture>& pictures,
                                         const std::string& file) {
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
  if (!problem.empty()) warn("no pictures in " + file + ": " + problem);
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

// The nominal case, and what the run has instead.
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

std::string replay_of(const Study& study, std::uint64_t run,
                      const PageParts& parts) {
  const separation::Case c = study.case_of(run);
  separation::Warnings warnings(false);
  warn_of_joints(c, warnings);
  const separation::Outcome outcome = separation::run_case(c);
  warn_of_run(c, outcome, warnings);
  separation::Replay replay{c, {{"", &outcome}}, {}, case_text(study, c, run)};
  warn_of_replay(replay, warnings);
  return separation::replay_page(replay, parts).text;
}

// As it was written, but of a pipe, which is at its end.
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
  PageExtras extras{drawn(pictures, file), {}, study_text(study.plan())};
  std::optional<PageParts> parts;
  if (study.plan().joint_file.empty() && !findings.requirements.empty()) {
    parts = parts_of_replays(file);
  }
  bool good = true;
  for (const Judgement& judgement : findings.requirements) {
    for (const RunValue& worst : judgement.worst) {
      if (!parts || extras.replays.contains(worst.run)) continue;
      std::filesystem::path name(file);
      name.replace_filename(fmt::format("{}_run{}{}", name.stem().string(),
                                        worst.run, name.extension().string()));
      try {
        names.keep("--report", name.string());
        write_file(name.string(), replay_of(study, worst.run, *parts));
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
