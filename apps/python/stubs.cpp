// The types of the package: puts quantities into the lines @CLASS@ of a stub
// from standard input.
#include <iostream>
#include <map>
#include <string>

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
                                   "_Integers", "_Integers", "_Floats"};
  std::string text;
  for (const auto& q : table) text += property(q.key, types[q.of.index()]);
  return text;
}

template <class Row>
std::string methods(std::span<const Quantity<Row>> table) {
  std::string text;
  for (const auto& q : table) {
    text += "    def " + std::string(q.key) +
            "(self, normal_force: ArrayLike) -> _Floats: ...\n";
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
      {"@Cycle@", numbers()},
      {"@Fit@", fit()}};
  for (std::string line; std::getline(std::cin, line);) {
    const auto found = of.find(line);
    std::cout << (found == of.end() ? line + '\n' : found->second);
  }
}
