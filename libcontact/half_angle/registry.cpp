#include "libcontact/half_angle/registry.hpp"

#include <cmath>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace detail {

extern const HalfAngleEntry hertz_law;
extern const HalfAngleEntry arctan_law;
extern const HalfAngleEntry tanh_law;
extern const HalfAngleEntry blend_law;
extern const HalfAngleEntry paper_law;
extern const HalfAngleEntry fitted_law;
extern const HalfAngleEntry exact_law;

std::span<const HalfAngleEntry* const> half_angle_entries() {
  static constexpr const HalfAngleEntry* all[] = {
      &hertz_law, &arctan_law, &tanh_law, &blend_law,
      &paper_law, &fitted_law, &exact_law};
  return all;
}

const HalfAngleEntry* find_half_angle_entry(std::string_view name) {
  const auto colon = name.find(':');
  for (const HalfAngleEntry* entry : half_angle_entries()) {
    if (entry->about.name != name.substr(0, colon)) continue;
    return colon == name.npos || entry->takes_parameter ? entry : nullptr;
  }
  return nullptr;
}

}  // namespace detail

void HalfAngleLaw::require_closing_load() const {
  if (!std::isnan(closing_load())) return;
  throw Error(detail::needs(
      to_string(kind_) + " joint with interference",
      "a load through the centre, and bodies that can be pressed together all "
      "round, not an incompressible layer or body between rigid ones"));
}

const std::vector<std::string>& half_angle_law_names() {
  static const auto& names = *new auto(detail::names_of(
      detail::half_angle_entries(), [](const auto&) { return true; }));
  return names;
}

bool takes_half_angle_options(std::string_view name) {
  const detail::HalfAngleEntry* entry = detail::find_half_angle_entry(name);
  return entry && entry->takes_options;
}

bool half_angle_law_allows(std::string_view name,
                           const ContactConditions& conditions) {
  const detail::HalfAngleEntry* entry = detail::find_half_angle_entry(name);
  return (entry ? entry->about : detail::LawEntry{}).allows(conditions);
}

std::unique_ptr<HalfAngleLaw> make_half_angle_law(
    std::string_view name, JointKind kind, const ElasticPair& pair,
    const HalfAngleOptions& options, const ContactConditions& conditions) {
  if (!half_angle_law_allows(name, conditions)) {
    detail::refuse_law("half-angle law", name, detail::half_angle_entries(),
                       conditions);
  }
  const detail::HalfAngleEntry* entry = detail::find_half_angle_entry(name);
  if (!entry) {
    throw Error(
        detail::unknown("half-angle law", name, half_angle_law_names()));
  }
  const std::string_view parameter =
      name == entry->about.name ? std::string_view()
                                : name.substr(entry->about.name.size() + 1);
  auto law = entry->make({kind, pair, options, conditions, parameter});
  if (conditions.clearance == Clearance::interference) {
    law->require_closing_load();
  }
  return law;
}

}  // namespace contact
