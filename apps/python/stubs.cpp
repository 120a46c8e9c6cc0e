// The types of the package: puts quantities into the lines @CLASS@ of a stub
// from standard input.
#include <iostream>
#include <map>
#include <string>

#include "libcontact/files/joint_tables.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/pressure/registry.hpp"
#include "libcontact/quantities/fit.hpp"
#include "libcontact/quantities/play.hpp"
#include "libcontact/quantities/tables.hpp"

namespace {

using contact::Quantity;

std::string property(std::string_view key, const char* type) {
  return "    @property\n    def " + std::string(key) + "(self) -> " + type +
         ": ...\n";
}

template <class Row>
std::string arrays(std::span<const Quantity<Row>> table) {
  constexpr const char* types[] = {"_Floats",   "_Integers", "_Booleans",
                                   "_Integers", "_Integers", "_Floats",
                                   "_Integers"};
  std::string text;
  for (const auto& q : table) text += property(q.key, types[q.of.index()]);
  return text;
}

template <class Row>
std::string methods(std::span<const Quantity<Row>> table) {
  std::string text;
  for (const auto& q : table) {
    const std::string head = "    @overload\n    def " + std::string(q.key);
    text += head +
            "(self, normal_force: float) -> float: ...  "
            "# type: ignore[misc]\n" +
            head + "(self, normal_force: ArrayLike) -> _Floats: ...\n";
  }
  return text;
}

std::string numbers() {
  std::string text;
  for (const auto& q : contact::cycle_quantities()) {
    text += property(q.key, "float");
  }
  return text;
}

std::string fit() {
  constexpr const char* types[] = {"float", "int", "Estimate", "_Floats"};
  std::string text;
  for (const auto& q : contact::fit_quantities()) {
    text += property(q.key, types[q.of.index()]);
  }
  return text;
}

// NAME = Literal["LAW", ...]
template <class Entries>
std::string literal(const char* name, const Entries& entries) {
  std::string names;
  for (const auto& law : contact::detail::names_of(
           entries, [](const auto& /*entry*/) { return true; })) {
    names += (names.empty() ? "\"" : ", \"") + law + '"';
  }
  return std::string(name) + " = Literal[" + names + "]\n";
}

// The keywords of a joint: those of _joint_keys that are keys of no table.
std::string joint_keywords() {
  std::string text;
  const auto add = [&](const std::string& name, const char* type = "_Key") {
    text += "        " + name + ": " + type + " = None,\n";
  };
  const auto law = [](std::string_view key) {
    return key == "half_angle" ? "_HalfAngle | Mapping[str, object] | None"
           : key == "pressure" ? "_Pressure | Mapping[str, object] | None"
                               : "_Key";
  };
  for (const contact::KnownKey& table : contact::joint_keys()) {
    if (table.key != "kind") add(std::string(table.key), law(table.key));
    for (const contact::Unit& unit : units_of(table.dimension)) {
      if (!unit.ending.empty())
        add(std::string(table.key) + "_" + std::string(unit.ending));
    }
    if (table.key == "wall" || table.key == "coating") continue;
    for (const contact::KnownKey& key : table.inside) {
      if (key.key == "law" || key.key == "kind") continue;
      add(std::string(key.key));
      for (const contact::Unit& unit : units_of(key.dimension)) {
        if (!unit.ending.empty())
          add(std::string(key.key) + "_" + std::string(unit.ending));
      }
    }
  }
  return text;
}

}  // namespace

int main() {
  const std::map<std::string, std::string> of = {
      {"@Solution@", arrays(contact::solution_quantities())},
      {"@RestSolution@", arrays(contact::rest_quantities())},
      {"@Rating@", arrays(contact::rating_quantities())},
      {"@WearIn@", arrays(contact::worn_quantities())},
      {"@Coefficients@", arrays(contact::coefficient_quantities())},
      {"@Joint@", methods(contact::patch_quantities()) +
                      methods(contact::approach_quantities())},
      {"@ForceState@", arrays(contact::force_state_quantities())},
      {"@Impact@", arrays(contact::impact_quantities())},
      {"@PlayForce@", arrays(contact::play_force_quantities())},
      {"@Laws@", literal("_HalfAngle", contact::detail::half_angle_entries()) +
                     literal("_Pressure", contact::detail::pressure_entries())},
      {"@JointKeys@", joint_keywords()},
      {"@Cycle@", numbers()},
      {"@Fit@", fit()}};
  for (std::string line; std::getline(std::cin, line);) {
    const auto found = of.find(line);
    std::cout << (found == of.end() ? line + '\n' : found->second);
  }
}
