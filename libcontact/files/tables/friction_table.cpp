#include "libcontact/files/tables/friction_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/files/tables/friction_presets.hpp"
#include "libcontact/pair/stress_registry.hpp"

namespace contact {
namespace {

FrictionStress curve_from_table(const TomlTable& friction,
                                const detail::StressEntry& entry) {
  const ArrayShape two_or_more{.rows = 2, .or_more = true};
  FrictionStress::Table table;
  table.points = friction.numbers(entry.points, two_or_more);
  table.coefficients = friction.numbers("coefficients", two_or_more);
  if (friction.optional_choice("curve").value_or(0)) {
    table.curve = FrictionStress::Table::Curve::linear;
  }
  try {
    return entry.make({}, table);
  } catch (const Error& error) {
    friction.fail("coefficients", error.what());
  }
}

Interval range_of(const detail::StressNumber& number) {
  return {0, std::min(number.largest, Interval::largest), number.is_above_zero};
}

// A stress of pressure and speed, by the name of its law.
FrictionStress stress_from_table(const TomlTable& friction) {
  const detail::StressEntry& entry =
      *detail::stress_entries()[friction.choice("law")];
  if (entry.is_table()) return curve_from_table(friction, entry);
  std::vector<double> numbers;
  for (const detail::StressNumber& number : entry.numbers) {
    numbers.push_back(friction.number(number.key, range_of(number)));
  }
  return entry.make(numbers, {});
}

// Dimension of a key, from its SI unit.
Dimension dimension_of(std::string_view unit) {
  for (int i = 0; i <= static_cast<int>(Dimension::hersey); ++i) {
    const auto dimension = static_cast<Dimension>(i);
    if (units_of(dimension)[0].ending == unit) return dimension;
  }
  throw std::logic_error("no key is in this unit");
}

// A coefficient between the least and the largest of published ones.
double coefficient_from_table(const TomlTable& friction) {
  if (!friction.has("preset")) {
    if (friction.has("preset_share")) {
      friction.needs("preset_share", "preset");
    }
    return friction.number("coefficient");
  }
  friction.refuse_both("preset", "coefficient");
  const detail::FrictionPreset& preset =
      detail::friction_presets()[friction.choice("preset")];
  return preset.at(friction.optional_number("preset_share").value_or(0.5));
}

}  // namespace

// Viscous friction has either of its two numbers, dry friction a coefficient.
std::optional<FrictionModel> friction_from_table(const TomlTable& table) {
  const auto friction = table.optional_table("friction");
  if (!friction) return {};
  if (friction->has("law")) return stress_from_table(*friction);
  const auto constant = friction->optional_number("viscous_constant");
  const auto slope = friction->optional_number("viscous_pressure_slope");
  const auto adhesion = friction->optional_number("adhesion");
  if (!constant && !slope) {
    return FrictionLaw(coefficient_from_table(*friction), adhesion.value_or(0));
  }
  const char* const viscous =
      constant ? "viscous_constant" : "viscous_pressure_slope";
  friction->refuse_both(viscous, "coefficient");
  friction->refuse_both(viscous, "preset");
  friction->refuse_both(viscous, "adhesion");
  return ViscousLaw(constant.value_or(0), slope.value_or(0));
}

KnownKeys friction_keys() {
  constexpr auto non_negative = Interval::non_negative();
  std::vector<std::string> presets;
  for (const detail::FrictionPreset& preset : detail::friction_presets()) {
    presets.emplace_back(preset.name);
  }
  std::vector<std::string> laws;
  for (const detail::StressEntry* entry : detail::stress_entries()) {
    laws.emplace_back(entry->name);
  }
  KnownKeys keys = {
      number_key("coefficient", non_negative),
      word_key("preset", presets),
      number_key("preset_share", {0, 1}),
      number_key("adhesion", Dimension::stress, non_negative),
      number_key("viscous_constant", Dimension::viscous_constant, non_negative),
      number_key("viscous_pressure_slope", Dimension::inverse_velocity,
                 non_negative),
      word_key("law", laws)};
  const auto add = [&](std::string_view key, std::string_view unit,
                       const Interval& range) {
    if (std::ranges::find(keys, key, &KnownKey::key) != keys.end()) return;
    keys.push_back(number_key(key, dimension_of(unit), range));
  };
  for (const detail::StressEntry* entry : detail::stress_entries()) {
    for (const detail::StressNumber& number : entry->numbers) {
      add(number.key, number.unit, range_of(number));
    }
    if (entry->is_table()) {
      add(entry->points, entry->points_unit, Interval::positive());
    }
  }
  add("coefficients", "", non_negative);
  keys.push_back(word_key("curve", {"spline", "linear"}));
  return keys;
}

}  // namespace contact
