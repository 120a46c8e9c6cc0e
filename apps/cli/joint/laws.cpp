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

namespace cli {
namespace {

// The names asked for, `all` for the word "all".
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
  refuse(option, text, "all alone, or names");
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
  std::vector<std::string> all = contact::half_angle_law_names();
  std::erase_if(all, [&](const std::string& name) {
    return name == "paper" ||  // one of the others
           !contact::half_angle_law_allows(name, conditions);
  });
  return law_names("--law", asked, std::move(otherwise), std::move(all));
}

std::vector<std::string> pressure_laws(
    const std::vector<std::string>& asked, std::vector<std::string> otherwise,
    const contact::ContactConditions& conditions) {
  std::vector<std::string> all = contact::pressure_law_names();
  std::erase_if(all, [&](const std::string& name) {
    return name == "worn" ||  // of another surface, and up to 90 deg
           !contact::pressure_law_allows(name, conditions);
  });
  return law_names("--pressure", asked, std::move(otherwise), std::move(all));
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
    refuse_without(given("--limit-angle", text),
                   "one of the laws arctan, tanh, blend, "
                   "paper; none of them is asked for");
  }
}

std::string with_loading(const std::string& name,
                         const contact::InnerLoading& loading) {
  if (name != "exact" || !loading.is_back()) return name;
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

}  // namespace cli
