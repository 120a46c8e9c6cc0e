#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "libcontact/pair/law_entry.hpp"
#include "libcontact/pressure/factory.hpp"

/// The pressure laws that have a name: each stands in the file of its law, all
/// of them in registry.cpp.
namespace contact::detail {

struct PressureRequest {
  JointKind kind;
  const ElasticPair& pair;
  const ContactConditions& conditions;
};

struct PressureEntry {
  LawEntry about;
  std::string_view shape;  ///< p/p(0); c = cos theta0
  std::unique_ptr<PressureLaw> (*make)(const PressureRequest&) = nullptr;
};

/// In the order of the sources.
std::span<const PressureEntry* const> pressure_entries();

/// The entry of a name; null if there is none.
const PressureEntry* find_pressure_entry(std::string_view name);

}  // namespace contact::detail
