#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/pair/contact_conditions.hpp"

namespace contact::detail {

/// Properties of a law, in the file of the law: help, messages, tables of the
/// docs, Python and tests read it here.
struct LawEntry {
  /// Inputs of a law beside the load; each includes the one before.
  enum class Needs { nothing, materials, conditions };

  std::string_view name;
  std::string_view meaning;
  std::string_view accuracy;  ///< against the exact contact
  Needs needs = Needs::nothing;
  /// Whether it holds for a joint that is loaded through the back; with walls.
  bool allows_back = false;
  bool allows_walls = false;
  Clearance least_clearance = Clearance::none;
  /// Whether it is among "all": not if it is one of the others by another
  /// name, or of another surface.
  bool is_among_all = true;
  /// Whether it is so slow to make that a file is read without making it.
  bool is_slow_to_make = false;

  bool allows(const ContactConditions& conditions) const {
    return (allows_back || !conditions.loading.is_back()) &&
           (allows_walls || !conditions.walls) &&
           conditions.clearance <= least_clearance;
  }
};

/// The names of a registry's entries for which `fits` is true.
template <class Entry, class Fits>
std::vector<std::string> names_of(std::span<const Entry* const> entries,
                                  const Fits& fits) {
  std::vector<std::string> names;
  for (const Entry* entry : entries) {
    if (fits(*entry)) names.emplace_back(entry->about.name);
  }
  return names;
}

/// "pressure law cosine must be exact or worn with finite walls".
/// @param kind     "pressure law"
/// @param allowed  names of those that are for these conditions
[[noreturn]] void refuse_law(std::string_view kind, std::string_view name,
                             const std::vector<std::string>& allowed,
                             const ContactConditions& conditions);
template <class Entry>
[[noreturn]] void refuse_law(std::string_view kind, std::string_view name,
                             std::span<const Entry* const> entries,
                             const ContactConditions& conditions) {
  const auto allows = [&](const Entry& entry) {
    return entry.about.allows(conditions);
  };
  refuse_law(kind, name, names_of(entries, allows), conditions);
}

}  // namespace contact::detail
