#include "libcontact/pressure/registry.hpp"

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace detail {

extern const PressureEntry cosine_pressure;
extern const PressureEntry sqrt_tan_pressure;
extern const PressureEntry sqrt_theta_pressure;
extern const PressureEntry mixture_pressure;
extern const PressureEntry exact_pressure;
extern const PressureEntry worn_pressure;

std::span<const PressureEntry* const> pressure_entries() {
  static constexpr const PressureEntry* all[] = {
      &cosine_pressure,  &sqrt_tan_pressure, &sqrt_theta_pressure,
      &mixture_pressure, &exact_pressure,    &worn_pressure};
  return all;
}

const PressureEntry* find_pressure_entry(std::string_view name) {
  for (const PressureEntry* entry : pressure_entries()) {
    if (entry->about.name == name) return entry;
  }
  return nullptr;
}

}  // namespace detail

const std::vector<std::string>& pressure_law_names() {
  static const auto& names = *new auto(detail::names_of(
      detail::pressure_entries(), [](const auto&) { return true; }));
  return names;
}

bool pressure_law_allows(std::string_view name,
                         const ContactConditions& conditions) {
  const detail::PressureEntry* entry = detail::find_pressure_entry(name);
  if (entry) return entry->about.allows(conditions);
  return !conditions.walls &&  // one's own
         conditions.clearance != Clearance::interference;
}

std::unique_ptr<PressureLaw> make_pressure_law(
    std::string_view name, JointKind kind, const ElasticPair& pair,
    const ContactConditions& conditions) {
  if (!pressure_law_allows(name, conditions)) {
    detail::refuse_law("pressure law", name, detail::pressure_entries(),
                       conditions);
  }
  const detail::PressureEntry* entry = detail::find_pressure_entry(name);
  if (!entry) {
    throw Error(detail::unknown("pressure law", name, pressure_law_names()));
  }
  return entry->make({kind, pair, conditions});
}

}  // namespace contact
