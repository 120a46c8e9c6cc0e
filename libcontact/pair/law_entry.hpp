#pragma once

#include <string_view>

#include "libcontact/pair/contact_conditions.hpp"

namespace contact::detail {

/// What is said of a law beside its name, in the file of the law: help,
/// messages, tables of the docs, Python and tests read it here.
struct LawEntry {
  /// What a law depends on beside the load; each includes the one before.
  enum class Needs { nothing, materials, conditions };

  std::string_view name;
  std::string_view meaning;
  std::string_view accuracy;  ///< against the exact contact
  Needs needs = Needs::nothing;
  /// Whether it holds for a joint that is loaded through the back; with walls.
  bool allows_back = false;
  bool allows_walls = false;
  /// Whether it is among "all": not if it is one of the others by another
  /// name, or of another surface.
  bool is_among_all = true;
  /// Whether it is so slow to make that a file is read without making it.
  bool is_slow_to_make = false;

  bool allows(const ContactConditions& conditions) const {
    return (allows_back || !conditions.loading.is_back()) &&
           (allows_walls || !conditions.walls);
  }
};

}  // namespace contact::detail
