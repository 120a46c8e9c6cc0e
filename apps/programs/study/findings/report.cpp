#include "programs/study/findings/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "cli/number.hpp"
#include "cli/stream/quoting.hpp"
#include "cli/stream/verdict.hpp"
#include "programs/study/findings/histograms.hpp"
#include "programs/study/findings/names.hpp"

namespace study {
namespace {

using nlohmann::ordered_json;

constexpr int digits = 4;

// A percentile is infinite if it falls on a run without the number.
std::string number(double value) {
  return std::isinf(value) ? "no number" : cli::rounded_text(value, digits);
}
std::string number(const std::optional<double>& value) {
  return value ? number(*value) : "-";
}
std::string number(const Range& range) {
  if (range.low == range.high) return number(range.low);
  if (std::isinf(range.low) && std::isinf(range.high)) return "-";
  if (std::isinf(range.low)) return "at most " + number(range.high);
  if (std::isinf(range.high)) return "at least " + number(range.low);
  return number(range.low) + " to " + number(range.high);
}
std::string percent(double share) {
  return fmt::format("{:.6g} %", 100 * share);
}
std::string about(double share) { return fmt::format("{:.3g} %", 100 * share); }

ordered_json json(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return std::isnan(value) ? ordered_json(nullptr) : ordered_json(value);
}
ordered_json json(const std::optional<double>& value) {
  return value ? json(*value) : ordered_json(nullptr);
}
ordered_json json(const Range& range) {
  if (range.low == range.high) return json(range.low);
  return {json(range.low), json(range.high)};
}

const char* to_string(Answer answer) {
  switch (answer) {
    case Answer::met:
      return "met";
    case Answer::not_met:
      return "not met";
    case Answer::open:
      break;
  }
  return "open";
}

std::string line(const Cells& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) {
    text += ' ' + cli::markdown_text(cell) + " |";
  }
  return text + '\n';
}

std::string markdown(const Part& part) {
  std::string text =
      part.text.empty() ? "" : cli::markdown_text(part.text) + "\n\n";
  if (part.header.empty()) return text;
  text += line(part.header);
  text += '|';
  for (std::size_t i = 0; i < part.header.size(); ++i) {
    text += i == 0 ? "---|" : "---:|";
  }
  text += '\n';
  for (const Cells& row : part.rows) text += line(row);
  return text + '\n';
}

std::vector<std::size_t> widths_of(const std::vector<Cells>& lines) {
  std::vector<std::size_t> widths(lines[0].size());
  for (const Cells& cells : lines) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      widths[i] = std::max(widths[i], cli::terminal_width(cells[i]));
    }
  }
  return widths;
}

// Without spare columns as long as the table is too wide.
Part narrowed(Part part) {
  for (const std::string& spare : part.spare) {
    std::vector<Cells> lines = part.rows;
    lines.insert(lines.begin(), part.header);
    const std::vector<std::size_t> widths = widths_of(lines);
    const std::size_t whole =
        std::accumulate(widths.begin(), widths.end(), 2 * widths.size());
    if (whole <= cli::TerminalReport::widest_table) break;
    const auto at = std::ranges::find(part.header, spare) - part.header.begin();
    part.header.erase(part.header.begin() + at);
    for (Cells& row : part.rows) row.erase(row.begin() + at);
  }
  return part;
}

// Columns of a width each, the first to the left. fmt counts characters.
std::string aligned(const Part& part) {
  std::string text = part.text.empty() ? "" : part.text + "\n\n";
  std::vector<Cells> lines = part.rows;
  lines.insert(lines.begin(), part.header);
  const std::vector<std::size_t> widths = widths_of(lines);
  for (const Cells& cells : lines) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      text += i == 0 ? fmt::format("  {:<{}}", cells[i], widths[i])
                     : fmt::format("  {:>{}}", cells[i], widths[i]);
    }
    if (!cells.empty()) text += '\n';
  }
  return text + (part.header.empty() ? "" : "\n");
}

std::string verdict_text(const Judgement& judgement, std::size_t runs) {
  if (!judgement.answer) return "none";
  if (*judgement.answer != Answer::open) return to_string(*judgement.answer);
  return fmt::format("open: {} more runs without a miss",
                     judgement.needed - runs);
}

void add_requirements(const Study& study, const Findings& findings,
                      const Words& words, std::vector<Part>& parts) {
  Part verdicts{
      .heading = "Verdicts",
      .header = {"requirement", "success", "risk", "misses", "verdict",
                 "probability of a miss: lower bound", "upper bound"}};
  Part percentiles{.heading = "Percentiles",
                   .header = {"quantity", "percentile", "lower bound",
                              "estimate", "upper bound"}};
  const auto& requirements = study.plan().requirements;
  for (std::size_t i = 0; i < requirements.size(); ++i) {
    const Requirement& r = requirements[i];
    const Judgement& j = findings.requirements[i];
    verdicts.rows.push_back(
        {words.demand(r), percent(r.demand.success), percent(r.demand.risk),
         fmt::format("{}", j.misses), verdict_text(j, study.runs()),
         j.answer ? about(j.miss_probability.low) : "-",
         j.answer ? about(j.miss_probability.high) : "-"});
    percentiles.rows.push_back(
        {words.key(r.quantity), percent(j.share), number(j.percentile.low),
         number(j.percentile.value), number(j.percentile.high)});
    percentiles.pictures.push_back(fmt::format("{}", i + 1));
  }
  parts.push_back(std::move(verdicts));
  parts.push_back(std::move(percentiles));
  if (study.plan().sampling == Sampling::random) return;
  parts.push_back({.text = "No verdict: counting misses requires independent "
                           "runs, which only random sampling gives."});
}

Part quantities_part(const Study& study, const Findings& findings,
                     const Words& words) {
  Part part{.heading = "Numbers",
            .header = {"quantity", "nominal", "mean", "deviation", "smallest",
                       "5 %", "50 %", "95 %", "largest", "missing"},
            .spare = {"50 %", "smallest", "largest"}};
  if (std::ranges::all_of(findings.quantities,
                          [](const Scatter& s) { return s.missing == 0; })) {
    part.spare.emplace_back("missing");
  }
  part.spare.emplace_back("mean");
  if (study.plan().joint_file.empty()) part.pictures = {"clearance", "angles"};
  for (const Scatter& s : findings.quantities) {
    part.rows.push_back({words.key(s.quantity), number(s.nominal),
                         number(s.mean), number(s.deviation), number(s.low),
                         number(s.p5), number(s.median), number(s.p95),
                         number(s.high), fmt::format("{}", s.missing)});
  }
  return part;
}

// The error with two digits, and the value rounded to the same place.
std::string with_error(double value, double error) {
  constexpr int most = 6;
  const int decimals =
      error > 0
          ? std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0,
                       most)
          : most;
  return fmt::format("{0:.{2}f} +- {1:.{2}f}", value, error, decimals);
}

// The strongest driver comes first.
Part drivers_part(const Study& study, const Driven& driven,
                  const Words& words) {
  constexpr std::size_t shown = 10;
  std::vector<std::pair<double, Cells>> rows;
  if (driven.sobol.empty()) {
    for (std::size_t i = 0; i < study.inputs(); ++i) {
      const double strength = std::abs(driven.regression.standardised[i]);
      rows.push_back({std::isnan(strength) ? 0 : strength,
                      {words.key(study.design().draws()[i].label),
                       number(driven.spearman[i]),
                       number(driven.regression.standardised[i])}});
    }
  } else {
    for (std::size_t i = 0; i < driven.sobol.size(); ++i) {
      const SobolIndex& s = driven.sobol[i];
      rows.push_back({std::isnan(s.total) ? 0 : s.total,
                      {words.key(study.design().source_label(i)),
                       with_error(s.first, s.first_error),
                       with_error(s.total, s.total_error)}});
    }
  }
  std::ranges::stable_sort(rows, std::greater(),
                           [](const auto& row) { return row.first; });
  const bool sobol = !driven.sobol.empty();
  const std::string quantity = words.key(driven.quantity);
  Part part{
      .text = sobol ? fmt::format("What drives {} (shares of its variance):",
                                  quantity)
              : std::isnan(driven.regression.explained)
                  ? fmt::format("What drives {} (runs are too few to explain "
                                "it):",
                                quantity)
                  : fmt::format("What drives {} (regression explains {}):",
                                quantity, about(driven.regression.explained)),
      .header = sobol ? Cells{"input", "alone", "with others"}
                      : Cells{"input", "rank correlation", "regression"}};
  for (std::size_t i = 0; i < std::min(shown, rows.size()); ++i) {
    part.rows.push_back(rows[i].second);
  }
  return part;
}

Part worst_part(const Requirement& requirement, const Judgement& judgement,
                const Words& words) {
  Part part{
      .text = fmt::format("The worst runs for {}:", words.demand(requirement)),
      .header = {"run", words.key(requirement.quantity)}};
  for (const RunValue& run : judgement.worst) {
    part.rows.push_back(
        {fmt::format("{}", run.run),
         std::isnan(run.value) ? "failed or without it" : number(run.value)});
    part.runs.push_back(run.run);
  }
  return part;
}

ordered_json requirement_json(const Requirement& r, const Judgement& j) {
  ordered_json out = {{"quantity", r.quantity},
                      {r.at_least ? "at_least" : "at_most", r.limit},
                      {"success", r.demand.success},
                      {"risk", r.demand.risk},
                      {"misses", j.misses},
                      {"missing", j.missing}};
  out["verdict"] = j.answer ? ordered_json(to_string(*j.answer)) : nullptr;
  if (j.answer) {
    out["miss_probability"] = {j.miss_probability.low, j.miss_probability.high};
    out["runs_needed_with_these_misses"] = j.needed;
  }
  out["percentile"] = {{"share", j.share},
                       {"value", json(j.percentile.value)},
                       {"low", json(j.percentile.low)},
                       {"high", json(j.percentile.high)}};
  for (const RunValue& run : j.worst) {
    out["worst"].push_back({{"run", run.run}, {"value", json(run.value)}});
  }
  return out;
}

ordered_json driven_json(const Study& study, const Driven& d) {
  ordered_json out = {{"quantity", d.quantity},
                      {"regression_explains", json(d.regression.explained)}};
  for (std::size_t i = 0; i < study.inputs(); ++i) {
    out["inputs"].push_back(
        {{"input", study.design().draws()[i].name},
         {"rank_correlation", json(d.spearman[i])},
         {"regression", json(d.regression.standardised[i])}});
  }
  for (std::size_t i = 0; i < d.sobol.size(); ++i) {
    const SobolIndex& s = d.sobol[i];
    out["sobol"].push_back({{"source", study.design().sources()[i]},
                            {"first", json(s.first)},
                            {"first_error", json(s.first_error)},
                            {"total", json(s.total)},
                            {"total_error", json(s.total_error)}});
  }
  return out;
}

}  // namespace

const Words as_in_files = {
    [](std::string_view key) { return std::string(key); }, to_string};
const Words in_words = {shown_label, shown_demand};

std::string to_string(const Requirement& requirement) {
  return fmt::format("{} {} {}", requirement.quantity,
                     requirement.at_least ? "at least" : "at most",
                     cli::number_text(requirement.limit));
}

std::string above_limit_text(const Study& study, const Findings& findings) {
  return fmt::format(
      "{} of {} runs have peak pressures above 5 % of a Young's modulus, where "
      "linear elasticity ends, or above a limit_pressure: {}",
      findings.above_limit, study.runs(), over_limit);
}

ordered_json to_json(const Study& study, const Findings& findings) {
  const Plan& plan = study.plan();
  ordered_json j = {
      {"study", plan.name},
      {"runs", study.runs()},
      {"seed", plan.seed},
      {"sampling", sampling_names[static_cast<std::size_t>(plan.sampling)]},
      {"failed_runs", findings.failed},
      {"runs_above_limit_of_pressure", findings.above_limit},
      {"requirements", ordered_json::array()},
      {"quantities", ordered_json::array()},
      {"drivers", ordered_json::array()},
      {"keys_without_effect", findings.idle},
      {"warnings_of_nominal_run", study.warnings()}};
  for (std::size_t i = 0; i < plan.requirements.size(); ++i) {
    j["requirements"].push_back(
        requirement_json(plan.requirements[i], findings.requirements[i]));
  }
  for (const Scatter& s : findings.quantities) {
    j["quantities"].push_back({{"quantity", s.quantity},
                               {"nominal", json(s.nominal)},
                               {"mean", json(s.mean)},
                               {"deviation", json(s.deviation)},
                               {"smallest", json(s.low)},
                               {"p5", json(s.p5)},
                               {"p50", json(s.median)},
                               {"p95", json(s.p95)},
                               {"largest", json(s.high)},
                               {"missing", s.missing}});
  }
  for (const Driven& d : findings.driven) {
    j["drivers"].push_back(driven_json(study, d));
  }
  return j;
}

std::vector<Part> inputs_of(const Study& study, const Words& words) {
  const Plan& plan = study.plan();
  Part part{.heading = "Inputs",
            .header = {"key", "what is drawn", "distribution", "factors"}};
  for (const Dispersion& d : plan.dispersions) {
    std::vector<std::string> factors;
    for (const auto& [factor, loading] : d.shares) {
      factors.push_back(fmt::format("{} {}", plan.factors[factor],
                                    cli::number_text(loading)));
    }
    part.rows.push_back(
        {words.key(d.key),
         fmt::format("{}{}", d.relative ? "factor of its number" : "number",
                     d.each ? ", for each copy" : ""),
         d.distribution, fmt::format("{}", fmt::join(factors, ", "))});
  }
  for (std::size_t i = 0; i < count_input_pictures(study); ++i) {
    part.pictures.push_back(input_picture(i));
  }
  std::vector<Part> parts = {std::move(part)};
  if (!plan.factors.empty()) {
    parts.push_back({.text = fmt::format("Factors, standard normal numbers: {}",
                                         fmt::join(plan.factors, ", "))});
  }
  return parts;
}

std::vector<Part> parts_of(const Study& study, const Findings& findings,
                           const Words& words) {
  const Plan& plan = study.plan();
  std::vector<Part> parts;
  parts.push_back({.heading = "Runs",
                   .text = fmt::format(
                       "{} runs ({}, seed {}) and the nominal one; {} failed.",
                       study.runs(),
                       sampling_names[static_cast<std::size_t>(plan.sampling)],
                       plan.seed, findings.failed)});
  if (findings.failed > 0) {
    parts.push_back({.text = "The first failure: " + findings.first_failure});
  }
  for (const std::string& warning : study.warnings()) {
    parts.push_back({.text = "Warning of the nominal run: " + warning});
  }
  if (findings.above_limit > 0) {
    parts.push_back({.text = above_limit_text(study, findings) + "."});
  }
  if (!plan.requirements.empty()) {
    add_requirements(study, findings, words, parts);
  }
  parts.push_back(quantities_part(study, findings, words));
  for (std::size_t i = 0; i < findings.driven.size(); ++i) {
    parts.push_back(drivers_part(study, findings.driven[i], words));
    parts.back().pictures = {fmt::format("ranking_{}", i + 1)};
    if (i == 0) parts.back().heading = "Drivers";
  }
  for (std::size_t i = 0; i < findings.idle.size(); ++i) {
    parts.push_back(
        {.text = "No effect on any number of the study: " + findings.idle[i]});
    if (i == 0) parts.back().heading = "Keys without effect";
  }
  for (std::size_t i = 0; i < findings.requirements.size(); ++i) {
    parts.push_back(
        worst_part(plan.requirements[i], findings.requirements[i], words));
    if (i == 0) parts.back().heading = "Worst runs";
  }
  return parts;
}

std::string command_of(const Study& study, const std::string& command,
                       std::uint64_t run) {
  return fmt::format("{} --run {}{}", command, run,
                     study.plan().joint_file.empty()
                         ? fmt::format(" --history run{}.csv", run)
                         : "");
}

std::string to_text(const Study& study, const Findings& findings,
                    const std::string& command) {
  std::string text =
      fmt::format("# {}\n\n", cli::markdown_text(study.plan().name));
  for (const Part& part : parts_of(study, findings, as_in_files)) {
    text += markdown(part);
  }
  if (!findings.requirements.empty()) {
    const std::uint64_t worst = findings.requirements[0].worst[0].run;
    text +=
        fmt::format("To repeat one: {}\n\n", command_of(study, command, worst));
  }
  text.pop_back();
  return text;
}

std::string to_report(const Study& study, const Findings& findings,
                      const std::string& command,
                      const cli::TerminalReport::Style& style) {
  const bool colour = style.colour;
  // Texts of files have no colours of their own.
  const auto plain = [colour](const std::string& text) {
    return colour ? cli::terminal_text(text) : text;
  };
  std::string text = plain(study.plan().name) + "\n\n";
  for (std::size_t i = 0; i < findings.requirements.size(); ++i) {
    const Judgement& j = findings.requirements[i];
    const std::string sentence =
        plain(verdict_sentence(study, study.plan().requirements[i], j));
    text += colour && j.answer ? cli::coloured(sentence, to_string(*j.answer))
                               : sentence;
    text += "\n\n";
  }
  for (const Part& part : parts_of(study, findings, in_words)) {
    if (part.heading == "Verdicts") continue;
    text += plain(aligned(style.all ? part : narrowed(part)));
  }
  if (!findings.requirements.empty()) {
    const std::uint64_t worst = findings.requirements[0].worst[0].run;
    text +=
        fmt::format("To repeat one: {}\n", command_of(study, command, worst));
  }
  return text;
}

}  // namespace study
