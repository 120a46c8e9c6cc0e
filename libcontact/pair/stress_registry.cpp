#include "libcontact/pair/stress_registry.hpp"

namespace contact::detail {

extern const StressEntry stribeck_stress;
extern const StressEntry power_stress;
extern const StressEntry pressure_table_stress;
extern const StressEntry hersey_table_stress;

std::span<const StressEntry* const> stress_entries() {
  static constexpr const StressEntry* all[] = {&stribeck_stress, &power_stress,
                                               &pressure_table_stress,
                                               &hersey_table_stress};
  return all;
}

const StressEntry* find_stress_entry(std::string_view name) {
  for (const StressEntry* entry : stress_entries()) {
    if (entry->name == name) return entry;
  }
  return nullptr;
}

}  // namespace contact::detail
