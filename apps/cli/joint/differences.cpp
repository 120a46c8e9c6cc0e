// Differences between the joints of a run.
#include <fmt/format.h>

#include <algorithm>

#include "cli/joint/joint_options.hpp"
#include "cli/picture/axis.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace cli {

std::string difference_text(const std::vector<Difference>& differences) {
  std::string text;
  for (const auto& [column, value] : differences) {
    text += text.empty() ? "" : ", ";
    // The key without its tables.
    if (column != "joint") {
      text += column.substr(column.rfind('.') + 1);
      text += " = ";
    }
    text += value;
  }
  return text;
}

namespace {

// The unit at the end of a key that is a length, stress, ...; "" if there is
// none.
std::string_view unit_ending(std::string_view key) {
  using contact::Dimension;
  std::string_view longest;
  for (const Dimension measured :
       {Dimension::length, Dimension::stress, Dimension::velocity,
        Dimension::viscous_constant, Dimension::inverse_velocity,
        Dimension::hersey}) {
    for (const contact::Unit& unit : contact::units_of(measured)) {
      const bool ends = key.ends_with(fmt::format("_{}", unit.ending));
      if (ends && unit.ending.size() > longest.size()) longest = unit.ending;
    }
  }
  return longest;
}

}  // namespace

std::string difference_label(const std::vector<Difference>& differences) {
  std::string text;
  for (const Difference& difference : differences) {
    text += text.empty() ? "" : ", ";
    const std::string key =
        difference.column.substr(difference.column.rfind('.') + 1);
    const std::string_view unit = unit_ending(key);
    if (unit.empty()) {
      text += difference_text({difference});
      continue;
    }
    std::string name = key.substr(0, key.size() - unit.size() - 1);
    std::ranges::replace(name, '_', ' ');
    text += fmt::format("{} {} {}", name, difference.value,
                        with_micro(contact::unit_symbol(unit)));
  }
  return text;
}

std::vector<std::string> joint_columns(
    const std::vector<Joint>& joints,
    const std::vector<std::vector<std::string>>& columns) {
  std::vector<std::string> names;
  for (const Difference& difference : joints[0].differences) {
    names.push_back(difference.column);
  }
  for (const auto& other : columns) {
    const auto [a, b] = std::ranges::mismatch(columns[0], other);
    if (a == columns[0].end() && b == other.end()) continue;
    throw contact::Error(contact::detail::must_be(
        fmt::format(
            "the joints of --joint and --set, {} and {}",
            difference_text(joints[0].differences),
            difference_text(joints[&other - columns.data()].differences)),
        fmt::format("alike: of one kind, with the same laws; the tables have "
                    "the columns {} and {}",
                    a == columns[0].end() ? "-" : *a,
                    b == other.end() ? "-" : *b)));
  }
  names.insert(names.end(), columns[0].begin(), columns[0].end());
  return names;
}

void write_differences(const std::vector<Difference>& differences,
                       RowWriter& row) {
  for (const Difference& difference : differences) {
    if (const auto number = parse_number(difference.value)) {
      row.number(*number);
    } else {
      row.text(difference.value);
    }
  }
}

}  // namespace cli
