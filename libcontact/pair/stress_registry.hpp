#pragma once

#include <limits>
#include <span>
#include <string_view>

#include "libcontact/pair/friction_stress.hpp"

/// The friction stresses that have a name: each stands in the file of its law,
/// all of them in stress_registry.cpp.
namespace contact::detail {

/// One of the numbers of a stress.
struct StressNumber {
  std::string_view key;        ///< in joint files
  std::string_view unit = {};  ///< SI, as in the ending of a key: "m_per_s"
  bool is_above_zero = false;  ///< else 0 or above
  double largest = std::numeric_limits<double>::infinity();
};

struct StressEntry {
  std::string_view name;
  std::string_view meaning;  ///< tau
  /// In the order of FrictionStress::Source::numbers.
  std::span<const StressNumber> numbers = {};
  /// For tables: the key of the points, and their SI unit.
  std::string_view points = {};
  std::string_view points_unit = {};
  /// @throws Error if an argument is out of range.
  FrictionStress (*make)(std::span<const double> numbers,
                         const FrictionStress::Table& table) = nullptr;

  bool is_table() const { return !points.empty(); }
};

std::span<const StressEntry* const> stress_entries();

/// The entry of a name; null if there is none.
const StressEntry* find_stress_entry(std::string_view name);

}  // namespace contact::detail
