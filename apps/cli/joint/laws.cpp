#include "cli/joint/laws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/pressure/registry.hpp"

namespace cli {
namespace {

// The names given, or `all` for the word "all".
std::vector<std::string> law_names(std::string_view option,
                                   const std::vector<std::string>& asked,
                                   std::vector<std::string> otherwise,
                                   std::vector<std::string> all) {
  for (auto name = asked.begin(); name != asked.end(); ++name) {
    if (std::find(asked.begin(), name, *name) == name) continue;
    throw contact::Error(contact::detail::duplicate(option, *name));
  }
  if (asked.empty()) return otherwise;
  if (std::find(asked.begin(), asked.end(), "all") == asked.end()) return asked;
  if (asked.size() == 1) return all;
  const std::string text = fmt::format("{}", fmt::join(asked, ","));
  refuse(option, text, "\"all\" alone, or names of laws");
}

// Laws that "all" selects under these conditions.
template <class Entries>
std::vector<std::string> all_names(
    const Entries& entries, const contact::ContactConditions& conditions) {
  return contact::detail::names_of(entries, [&](const auto& entry) {
    return entry.about.is_among_all && entry.about.allows(conditions);
  });
}

// True if the law with this name is one of these and depends on the loading.
template <class Entries>
bool depends_on_loading(const Entries& entries, std::string_view name) {
  return std::ranges::any_of(entries, [&](const auto* entry) {
    using Needs = contact::detail::LawEntry::Needs;
    return entry->about.name == name && entry->about.needs == Needs::conditions;
  });
}

}  // namespace

contact::InnerLoading parse_loading(const std::string& text,
                                    const contact::InnerLoading& otherwise) {
  constexpr std::string_view back = "back:";
  constexpr Allowed patch{0, 90, "deg"};
  if (text.empty()) return otherwise;
  if (text == "centre") return contact::InnerLoading::centre();
  const auto degrees =
      text.starts_with(back)
          ? read_quantity("--loading back:", text.substr(back.size()),
                          contact::Dimension::angle)
          : std::nullopt;
  if (!degrees || !patch.contains(*degrees)) {
    refuse("--loading", text,
           "centre, or back:PSI with PSI from " + patch.text());
  }
  return contact::InnerLoading::back(*degrees * contact::degree);
}

std::vector<std::string> half_angle_laws(
    const std::vector<std::string>& asked, std::vector<std::string> otherwise,
    const contact::ContactConditions& conditions) {
  return law_names(
      "--law", asked, std::move(otherwise),
      all_names(contact::detail::half_angle_entries(), conditions));
}

std::vector<std::string> pressure_laws(
    const std::vector<std::string>& asked, std::vector<std::string> otherwise,
    const contact::ContactConditions& conditions) {
  return law_names("--pressure", asked, std::move(otherwise),
                   all_names(contact::detail::pressure_entries(), conditions));
}

void set_limit_angle(const std::string& text,
                     const std::vector<std::string>& laws,
                     contact::HalfAngleOptions& options) {
  if (text.empty()) return;
  options.limit_half_angle.reset();
  options.linear_limit = text == "linear";
  if (text != "linear" && text != "formula") {
    const auto degrees =
        read_quantity("--limit-angle", text, contact::Dimension::angle);
    if (!degrees || !(*degrees > 0 && *degrees < 180)) {
      refuse("--limit-angle", text,
             "formula, linear, or an angle above 0, below 180 deg");
    }
    options.limit_half_angle = *degrees * contact::degree;
  }
  if (std::none_of(laws.begin(), laws.end(),
                   contact::takes_half_angle_options)) {
    const auto takers = contact::detail::names_of(
        contact::detail::half_angle_entries(),
        [](const auto& entry) { return entry.takes_options; });
    refuse_without(given("--limit-angle", text),
                   fmt::format("one of the laws {}; none of them is asked for",
                               fmt::join(takers, ", ")));
  }
}

std::string with_loading(const std::string& name,
                         const contact::InnerLoading& loading) {
  namespace laws = contact::detail;
  if (!loading.is_back() ||
      !(depends_on_loading(laws::half_angle_entries(), name) ||
        depends_on_loading(laws::pressure_entries(), name))) {
    return name;
  }
  return fmt::format("{}_{}", name, to_string(loading));
}

std::vector<std::string> law_notes(const std::vector<NamedLaw>& laws,
                                   const contact::ElasticPair& pair) {
  std::map<std::string, std::vector<std::string>> laws_by_reason;
  for (const NamedLaw& named : laws) {
    for (const std::string& reason : named.law->validity_notes(pair)) {
      laws_by_reason[reason].push_back(named.name);
    }
  }
  std::vector<std::string> texts;
  for (const auto& [reason, names] : laws_by_reason) {
    texts.push_back(fmt::format("law {}: {}", fmt::join(names, ", "), reason));
  }
  return texts;
}

int law_colour(std::string_view name) {
  constexpr std::pair<std::string_view, int> colours[] = {
      {"exact", 6}, {"fitted", 1},   {"tanh", 3},       {"arctan", 4},
      {"hertz", 2}, {"blend", 5},    {"paper", 7},      {"cosine", 1},
      {"worn", 2},  {"sqrt_tan", 3}, {"sqrt_theta", 4}, {"mixture", 5}};
  // exact_back:20, blend:0.3
  for (const auto& [law, colour] : colours) {
    if (name.starts_with(law)) return colour;
  }
  return 0;
}

}  // namespace cli
