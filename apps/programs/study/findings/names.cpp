#include "programs/study/findings/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/picture/axis.hpp"

namespace study {
namespace {

std::string with_blanks(std::string_view text) {
  std::string shown(text);
  std::ranges::replace(shown, '_', ' ');
  return shown;
}

// "joint 1" for "joint[1]"; a body's name for a body.
std::string shown_step(std::string_view step) {
  const std::size_t bracket = step.find('[');
  if (bracket == step.npos || !step.ends_with(']')) return std::string(step);
  const std::string table = with_blanks(step.substr(0, bracket));
  step.remove_prefix(bracket + 1);
  step.remove_suffix(1);
  return table == "body" ? std::string(step)
                         : fmt::format("{} {}", table, step);
}

// Numbers of a list stand behind its unit: "com[1]" and m for "com_m[1]".
cli::ShownUnit unit_of(std::string_view key) {
  const std::size_t list = key.ends_with(']') ? key.rfind('[') : key.size();
  cli::ShownUnit unit = cli::shown_unit(key.substr(0, list));
  unit.stem += key.substr(list);
  return unit;
}

std::string share_text(double share) {
  return fmt::format("{:.3g} %", 100 * share);
}

}  // namespace

std::string shown_name(std::string_view key) {
  const std::string stem = unit_of(key).stem;
  std::vector<std::string_view> steps;
  for (std::string_view rest = stem;;) {
    const std::size_t dot = rest.find('.');
    steps.push_back(rest.substr(0, dot));
    if (dot == rest.npos) break;
    rest.remove_prefix(dot + 1);
  }
  // Symbols of tables need no further words.
  if (steps.size() == 1) return cli::shown_symbol(stem);
  // From the innermost part to the outermost.
  std::string name = with_blanks(shown_step(steps.back()));
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    const std::string_view step = steps[i];
    // The keys of these tables suffice.
    if (step == "geometry" || step == "materials") continue;
    name += step == "clearance"       ? " clearance"
            : step.starts_with("at_") ? ' ' + with_blanks(step)
                                      : " of " + shown_step(step);
  }
  return name;
}

std::string shown_label(std::string_view key) {
  const std::string unit = unit_of(key).symbol;
  return shown_name(key) + (unit.empty() ? "" : ", " + unit);
}

std::string shown_demand(const Requirement& requirement) {
  const cli::ShownUnit unit =
      cli::shown_unit(requirement.quantity).scaled(requirement.limit);
  return fmt::format("{} {} {}{}{}", shown_name(requirement.quantity),
                     requirement.at_least ? "at least" : "at most",
                     unit.text(requirement.limit),
                     unit.symbol.empty() || unit.symbol == "°" ? "" : " ",
                     unit.symbol);
}

std::string verdict_sentence(const Study& study, const Requirement& requirement,
                             const Judgement& judgement) {
  const std::string demand = shown_demand(requirement);
  const std::string counted =
      fmt::format("{} of {} do", judgement.misses, study.runs());
  if (!judgement.answer) {
    return fmt::format("No verdict on \"{}\": {} of {} runs miss it.", demand,
                       judgement.misses, study.runs());
  }
  const std::string sure = share_text(1 - requirement.demand.risk);
  const std::string share = share_text(1 - requirement.demand.success);
  switch (*judgement.answer) {
    case Answer::met:
      return fmt::format(
          "Met: at most {} of all runs miss \"{}\", with {} confidence: {}.",
          share, demand, sure, counted);
    case Answer::not_met:
      return fmt::format(
          "Not met: {} to {} of all runs miss \"{}\", with {} confidence each: "
          "{}.",
          share_text(judgement.miss_probability.low),
          share_text(judgement.miss_probability.high), demand, sure, counted);
    case Answer::open:
      break;
  }
  return fmt::format(
      "Open: whether at most {} of all runs miss \"{}\" cannot be said with {} "
      "confidence: {}; {} more runs without a miss would do.",
      share, demand, sure, counted, judgement.needed - study.runs());
}

}  // namespace study
