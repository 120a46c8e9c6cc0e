// The types that the npm package has from the library's tables: behind
// index.d.ts.
#include <cstdio>
#include <set>
#include <string>

#include "libcontact/base/text.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "libcontact/files/key_units.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/seat.hpp"
#include "libcontact/quantities/tables.hpp"

namespace {

using contact::KnownKey;
using contact::KnownKeys;
using contact::detail::message;

// A name in two tables of an answer belongs to the first one.
using Names = std::set<std::string_view>;

template <class Row>
std::string interface(const char* name,
                      std::span<const contact::Quantity<Row>> table,
                      Names& seen) {
  constexpr const char* types[] = {
      "number",
      "number",
      "boolean",
      "Status",
      "\"sliding\" | \"resting\" | \"unloaded\"",
      "Vector3",
      "\"closed\" | \"lifted\" | \"zero\" | \"clearance\"",
      "number"};
  std::string text = message("export interface {} {{\n", name);
  for (const auto& q : table) {
    if (!seen.insert(q.key).second) continue;
    text += message("  /** {} */\n  readonly {}: {};\n", description(q), q.key,
                    types[q.of.index()]);
  }
  return text + "}\n";
}
template <class Row>
std::string interface(const char* name,
                      std::span<const contact::Quantity<Row>> table) {
  Names none;
  return interface(name, table, none);
}

// The keys of a table of a joint file, with every unit.
std::string keys_of(const KnownKeys& keys, const std::string& margin) {
  std::set<std::string> seen;
  std::string text;
  for (const KnownKey& key : keys) {
    const bool is_number = key.dimension != contact::Dimension::number;
    const std::string type =
        key.inside.empty()
            ? std::string(is_number ? "Numbers" : "Value")
            : message("Table<{{\n{}{}}}>", keys_of(key.inside, margin + "  "),
                      margin);
    for (const auto& name :
         contact::detail::spellings(key.key, key.dimension)) {
      if (!seen.insert(name).second) continue;
      text += message("{}{}{}: {};\n", margin, name,
                      key.key == "kind" && margin.size() == 2 ? "" : "?", type);
    }
  }
  return text;
}

}  // namespace

int main() {
  Names of_answer;
  // As contact_joint_get() looks for them.
  const std::string rims =
      interface("Rims", contact::rim_quantities(), of_answer);
  const std::string lie =
      interface("Lie", contact::lie_quantities(), of_answer);
  const std::string all =
      interface("Solution", contact::solution_quantities(), of_answer) + rims +
      lie + interface("Rest", contact::rest_quantities()) +
      interface("Patch", contact::patch_quantities()) +
      interface("Rating", contact::rating_quantities()) +
      "export interface JointFile {\n" + keys_of(contact::joint_keys(), "  ") +
      "}\n";
  return std::fputs(all.c_str(), stdout) < 0;
}
