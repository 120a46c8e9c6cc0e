#include "cli/laws.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>

#include "cli/program.hpp"
#include "cli/quantity.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/units.hpp"

namespace cli {
namespace {

void refuse_repetition(std::string_view option,
                       const std::vector<std::string>& names) {
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::find(names.begin(), name, *name) == name) continue;
    throw contact::Error(
        fmt::format("{} {}: allowed once, is there twice", option, *name));
  }
}

// A law that depends on the loading, with it.
std::string with_loading(const std::string& name,
                         const contact::InnerLoading& loading) {
  if (name != "exact" || !loading.is_back()) return name;
  return fmt::format("{}_{}", name, to_string(loading));
}

// The names asked for, `all` for the word "all".
std::vector<std::string> law_names(std::string_view option,
                                   const std::vector<std::string>& asked,
                                   std::vector<std::string> otherwise,
                                   const std::vector<std::string>& all) {
  refuse_repetition(option, asked);
  if (asked.empty()) return otherwise;
  if (std::find(asked.begin(), asked.end(), "all") == asked.end()) return asked;
  if (asked.size() > 1) {
    throw contact::Error(fmt::format("{} {}: all is allowed alone", option,
                                     fmt::join(asked, ",")));
  }
  return all;
}

}  // namespace

void add_loading_option(CLI::App& app, std::string& loading,
                        const std::string& group) {
  app.add_option("--loading", loading,
                 "of the ball or pin: centre (default) or back:PSI")
      ->option_text("NAME")
      ->group(group);
}

contact::InnerLoading parse_loading(const std::string& text,
                                    const contact::InnerLoading& otherwise) {
  constexpr std::string_view back = "back:";
  constexpr Allowed patch{0, 90, "deg"};
  if (text.empty()) return otherwise;
  if (text == "centre") return contact::InnerLoading::centre();
  const auto degrees = text.starts_with(back)
                           ? parse_number(text.substr(back.size()))
                           : std::nullopt;
  if (!degrees || !patch.contains(*degrees)) {
    throw contact::Error(fmt::format(
        "--loading {}: allowed centre, or back:PSI with PSI from {}", text,
        patch.text()));
  }
  return contact::InnerLoading::back(*degrees * contact::degree);
}

std::vector<std::string> half_angle_laws(
    const std::vector<std::string>& asked, std::vector<std::string> otherwise,
    const contact::ContactConditions& conditions) {
  std::vector<std::string> all = contact::half_angle_law_names();
  std::erase_if(all, [&](const std::string& name) {
    return name == "paper" ||  // one of the others
           !contact::half_angle_law_allows(name, conditions);
  });
  return law_names("--law", asked, std::move(otherwise), all);
}

std::vector<std::string> pressure_laws(
    const std::vector<std::string>& asked, std::vector<std::string> otherwise,
    const contact::ContactConditions& conditions) {
  std::vector<std::string> all = contact::pressure_law_names();
  std::erase_if(all, [&](const std::string& name) {
    return !contact::pressure_law_allows(name, conditions);
  });
  return law_names("--pressure", asked, std::move(otherwise), all);
}

void set_limit_angle(const std::string& text,
                     const std::vector<std::string>& laws,
                     contact::HalfAngleOptions& options) {
  if (text.empty()) return;
  options.limit_half_angle.reset();
  options.linear_limit = text == "linear";
  if (text != "linear" && text != "formula") {
    const auto degrees = parse_number(text);
    if (!degrees || !(*degrees > 0 && *degrees < 180)) {
      throw contact::Error(
          fmt::format("--limit-angle {}: allowed formula, linear, or an angle "
                      "above 0, below 180 deg",
                      text));
    }
    options.limit_half_angle = *degrees * contact::degree;
  }
  if (std::none_of(laws.begin(), laws.end(),
                   contact::takes_half_angle_options)) {
    throw contact::Error(
        fmt::format("--limit-angle {}: allowed with the laws arctan, tanh, "
                    "blend and paper; none of them is asked for",
                    text));
  }
}

std::vector<NamedLaw> make_half_angle_laws(
    const std::vector<std::string>& names, contact::JointKind kind,
    const contact::ElasticPair& pair, const contact::HalfAngleOptions& options,
    const contact::ContactConditions& conditions) {
  std::vector<NamedLaw> laws;
  for (const std::string& name : names) {
    laws.push_back(
        {with_loading(name, conditions.loading),
         contact::make_half_angle_law(name, kind, pair, options, conditions)});
  }
  return laws;
}

NamedPressure make_pressure_law(const std::string& name,
                                contact::JointKind kind,
                                const contact::ElasticPair& pair,
                                const contact::ContactConditions& conditions) {
  return {with_loading(name, conditions.loading),
          contact::make_pressure_law(name, kind, pair, conditions)};
}

std::vector<NamedPressure> make_pressure_laws(
    const std::vector<std::string>& names, contact::JointKind kind,
    const contact::ElasticPair& pair,
    const contact::ContactConditions& conditions) {
  std::vector<NamedPressure> laws;
  for (const std::string& name : names) {
    laws.push_back(make_pressure_law(name, kind, pair, conditions));
  }
  return laws;
}

contact::ElasticPair pair_of_modulus_ratio(std::string_view ratio,
                                           std::string_view poisson1,
                                           std::string_view poisson2) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr Allowed poisson{0, 0.5, ""};
  return contact::ElasticPair::from_modulus_ratio(
      parse_value("--modulus-ratio", ratio, {0, infinity, ""}),
      parse_value("--poisson1", poisson1, poisson),
      parse_value("--poisson2", poisson2, poisson));
}

LawNotes::LawNotes(const std::vector<NamedLaw>& laws,
                   const contact::ElasticPair& pair) {
  for (const NamedLaw& named : laws) {
    for (const std::string& reason : named.law->validity_notes(pair)) {
      laws_by_reason_[reason].push_back(named.name);
    }
  }
}

std::vector<std::string> LawNotes::texts() const {
  std::vector<std::string> texts;
  for (const auto& [reason, laws] : laws_by_reason_) {
    texts.push_back(fmt::format("law {}: {}", fmt::join(laws, ", "), reason));
  }
  return texts;
}

void warn_of_validity(std::string_view program,
                      const std::vector<std::string>& geometry,
                      const LawNotes& laws) {
  for (const std::string& text : geometry) warn(program, text);
  for (const std::string& text : laws.texts()) warn(program, text);
}

}  // namespace cli
