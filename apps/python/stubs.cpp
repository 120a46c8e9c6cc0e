// The types of the package: replaces the lines @CLASS@ of a stub on standard
// input by quantities.
#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "libcontact/files/joint_tables.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/pressure/registry.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/fit.hpp"
#include "libcontact/quantities/play.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/stuck.hpp"
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
                                   "_Integers", "_Integers"};
  std::string text;
  for (const auto& q : table) text += property(q.key, types[q.of.index()]);
  return text;
}

// NAME(normal_force), of a joint also for a number.
template <class Row>
std::string methods(std::span<const Quantity<Row>> table, bool of_one) {
  std::string text;
  for (const auto& q : table) {
    const std::string head = "    def " + std::string(q.key) + "(\n";
    if (of_one) {
      text += "    @overload\n    def " + std::string(q.key) +
              "(self, normal_force: float) -> float: ...  "
              "# type: ignore[misc]\n    @overload\n";
    }
    text += head +
            "        self,\n        normal_force: ArrayLike,\n        *,\n"
            "        out: _Floats | None = None,\n"
            "        threads: int = 1,\n    ) -> _Floats: ...\n";
  }
  return text;
}

std::string methods(bool of_one) {
  return methods(contact::patch_quantities(), of_one) +
         methods(contact::approach_quantities(), of_one);
}

template <class Quantities>
std::string numbers(const Quantities& quantities) {
  std::string text;
  for (const auto& q : quantities) {
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

// NAME = Literal["WORD", ...]
std::string literal(const std::string& name,
                    const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words)
    text += (text.empty() ? "\"" : ", \"") + word + '"';
  return name + " = Literal[" + text + "]\n";
}

template <class Entries>
std::string laws(const char* name, const Entries& entries) {
  return literal(name, contact::detail::names_of(
                           entries, [](const auto&) { return true; }));
}

// Names of quantities allowed in `fields`.
template <class... Table>
std::string fields(const std::string& name, const Table&... tables) {
  std::vector<std::string> keys;
  const auto add = [&](const auto& table) {
    for (const auto& q : table) keys.emplace_back(q.key);
  };
  (add(tables), ...);
  return literal("_" + name + "Field", keys);
}

std::string all_fields() {
  return fields("Solution", contact::solution_quantities(),
                contact::rim_quantities(), contact::lie_quantities()) +
         fields("RestSolution", contact::rest_quantities()) +
         fields("Rating", contact::rating_quantities()) +
         fields("Step", contact::step_quantities()) +
         fields("Stuck", contact::stuck_quantities()) +
         fields("Prox", contact::prox_quantities());
}

// A key with each allowed unit.
std::vector<std::string> spellings(const contact::KnownKey& key) {
  std::vector<std::string> all = {std::string(key.key)};
  for (const contact::Unit& unit : units_of(key.dimension)) {
    if (!unit.ending.empty())
      all.push_back(all.front() + "_" + std::string(unit.ending));
  }
  return all;
}

const contact::KnownKey& inside(const contact::KnownKeys& keys,
                                std::string_view key) {
  return *std::ranges::find(keys, key, &contact::KnownKey::key);
}

// Tables passed as keywords, as TypedDicts.
std::string tables() {
  const contact::KnownKeys keys = contact::joint_keys();
  const auto material = inside(inside(keys, "materials").inside, "inner");
  std::string text =
      "class Material(TypedDict, total=False):\n"
      "    \"\"\"The material of a body: its elasticity, and what else is "
      "known "
      "of it.\"\"\"\n";
  std::string layer =
      "class Layer(Material, total=False):\n"
      "    \"\"\"A layer of a wall, or a coating: its material and "
      "thickness.\"\"\"\n";
  for (const auto& key : material.inside) {
    for (const auto& name : spellings(key))
      text += "    " + name +
              (key.key == "name"    ? ": str\n"
               : key.key == "liner" ? ": bool\n"
                                    : ": float\n");
  }
  for (const auto& key : inside(keys, "coating").inside) {
    if (std::ranges::find(material.inside, key.key, &contact::KnownKey::key) !=
        material.inside.end())
      continue;
    for (const auto& name : spellings(key))
      layer += "    " + name + ": float\n";
  }
  return text + '\n' + layer +
         "\nclass Wall(TypedDict, total=False):\n"
         "    \"\"\"Layers of the seat or hole, from the contact outwards, and "
         "what is behind them.\"\"\"\n"
         "    backing: str | Material\n    layer: Sequence[Layer]\n";
}

const char* type_of_keyword(std::string_view key) {
  if (key == "half_angle") return "_HalfAngle | Mapping[str, object] | None";
  if (key == "pressure") return "_Pressure | Mapping[str, object] | None";
  if (key == "inner" || key == "outer") return "Material | None";
  if (key == "liner") return "bool | None";
  if (key == "wall") return "Wall | None";
  if (key == "coating") return "Layer | Sequence[Layer] | None";
  return "_Key";
}

// The keywords of a joint: the _joint_keys outside tables.
// @param line  "@JointKeys" and the omitted ones
std::string joint_keywords(const std::string& line) {
  std::string text;
  const auto add = [&](const contact::KnownKey& key) {
    if (line.find(" " + std::string(key.key)) != line.npos) return;
    for (const auto& name : spellings(key))
      text +=
          "        " + name + ": " + type_of_keyword(key.key) + " = None,\n";
  };
  for (const contact::KnownKey& table : contact::joint_keys()) {
    if (table.key != "kind") add(table);
    if (table.key == "wall" || table.key == "coating") continue;
    for (const contact::KnownKey& key : table.inside) {
      if (key.key != "law" && key.key != "kind") add(key);
    }
  }
  return text;
}

// "@Rows TYPE FIELDS NAME" with its parameters in the lines below it: all
// quantities, some by their names, or in given arrays.
class RowsFunction {
 public:
  explicit RowsFunction(const std::string& line) {
    std::istringstream words(line);
    std::string at;
    words >> at >> type_ >> fields_ >> name_;
  }
  void add(const std::string& parameter) { parameters_ += parameter + ",\n"; }
  std::string text() const {
    return overload("None = None", "None = None", type_) +
           overload("_" + fields_ + "Field | Sequence[_" + fields_ + "Field]",
                    "None = None", dict) +
           overload("None = None", "dict[str, NDArray[Any]]", dict);
  }

 private:
  static constexpr const char* dict = "dict[str, NDArray[Any]]";
  std::string overload(const std::string& fields, const std::string& out,
                       const std::string& type) const {
    return "    @overload\n    def " + name_ + "(\n        self,\n" +
           parameters_ + "        fields: " + fields +
           ",\n        out: " + out +
           ",\n        threads: int = 1,\n    ) -> " + type + ": ...\n";
  }

  std::string type_, fields_, name_, parameters_;
};

}  // namespace

int main() {
  const std::map<std::string, std::string> of = {
      {"@Solution@", arrays(contact::solution_quantities()) +
                         arrays(contact::rim_quantities()) +
                         arrays(contact::lie_quantities())},
      {"@RestSolution@", arrays(contact::rest_quantities())},
      {"@Rating@", arrays(contact::rating_quantities())},
      {"@WearIn@", arrays(contact::worn_quantities())},
      {"@Coefficients@", arrays(contact::coefficient_quantities())},
      {"@Step@", arrays(contact::step_quantities())},
      {"@Stuck@", arrays(contact::stuck_quantities())},
      {"@Prox@", arrays(contact::prox_quantities())},
      {"@Joint@", methods(true)},
      {"@Joints@", methods(false)},
      {"@Fields@", all_fields()},
      {"@Tables@", tables()},
      {"@ForceState@", arrays(contact::force_state_quantities())},
      {"@Impact@", arrays(contact::impact_quantities())},
      {"@PlayForce@", arrays(contact::play_force_quantities())},
      {"@Laws@", laws("_HalfAngle", contact::detail::half_angle_entries()) +
                     laws("_Pressure", contact::detail::pressure_entries())},
      {"@Cycle@", numbers(contact::cycle_quantities())},
      {"@CycleWorst@", numbers(contact::worst_quantities())},
      {"@Fit@", fit()}};
  std::string line;
  bool has_line = static_cast<bool>(std::getline(std::cin, line));
  const auto next = [&] {
    has_line = static_cast<bool>(std::getline(std::cin, line));
  };
  while (has_line) {
    while (has_line && line.starts_with("    @Rows ")) {
      RowsFunction function(line);
      next();
      while (has_line && line.starts_with("        ")) {
        function.add(line);
        next();
      }
      std::cout << function.text();
    }
    const auto found = of.find(line);
    std::cout << (line.starts_with("@JointKeys") ? joint_keywords(line)
                  : found != of.end()            ? found->second
                                                 : line + '\n');
    next();
  }
}
