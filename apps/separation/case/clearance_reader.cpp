#include "separation/case/clearance_reader.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

// Places of the shapes that a key names.
std::vector<int> read_shapes(const TomlTable& table, std::string_view key,
                             const RigidBody& body) {
  std::vector<int> places;
  if (!table.has(key)) return places;
  for (const std::string& name : table.texts(key)) {
    const auto found = std::ranges::find(body.shapes, name, &Shape::name);
    if (name.empty() || found == body.shapes.end()) {
      std::vector<std::string> names;
      for (const Shape& shape : body.shapes) {
        if (!shape.name.empty()) names.push_back(shape.name);
      }
      table.fail(key, contact::detail::unknown("shape", name, names));
    }
    places.push_back(static_cast<int>(found - body.shapes.begin()));
  }
  return places;
}

std::vector<WatchedPair> read_one(const TomlTable& table,
                                  const CaseNames& names) {
  const std::array<std::string, 2> bodies{table.text("a"), table.text("b")};
  auto pairs = pairs_of(table, bodies, {"a", "b"}, names);
  const Case& c = names.of;
  const auto of_a = names.rigid_bodies(bodies[0]);
  const auto of_b = names.rigid_bodies(bodies[1]);
  auto a = read_shapes(table, "a_shapes", c.rigid_body(of_a.front()));
  auto b = read_shapes(table, "b_shapes", c.rigid_body(of_b.front()));
  const auto [begin, end] = names.window(table, "the clearance");
  const std::string name = table.has("name") ? column_text(table, "name") : "";
  for (WatchedPair& pair : pairs) {
    const bool swapped = std::ranges::count(of_a, pair.a) == 0 ||
                         std::ranges::count(of_b, pair.b) == 0;
    pair.name = name;
    pair.begin = begin;
    pair.end = end;
    pair.a_shapes = swapped ? b : a;
    pair.b_shapes = swapped ? a : b;
  }
  return pairs;
}

auto place_of(const WatchedPair& pair) {
  return std::tie(pair.a, pair.b, pair.name);
}

}  // namespace

std::vector<WatchedPair> pairs_of(const TomlTable& table,
                                  const std::array<std::string, 2>& bodies,
                                  const std::array<std::string, 2>& keys,
                                  const CaseNames& names) {
  std::array<std::vector<int>, 2> found;
  for (const int k : {0, 1}) {
    found[k] = names.rigid_bodies_of(table, keys[k], bodies[k]);
    if (names.of.rigid_body(found[k].front()).shapes.empty()) {
      table.must_be(keys[k], "a body with shapes");
    }
  }
  if (found[0].size() == 1 && found[0] == found[1]) {
    table.must_be(keys[1], keys[0] == keys[1] ? "two different bodies"
                                              : "another body than a");
  }
  std::vector<WatchedPair> pairs;
  for (const int a : found[0]) {
    for (const int b : found[1]) {
      const WatchedPair pair{std::min(a, b), std::max(a, b)};
      // Copies of one body meet in both orders.
      const bool is_new = std::ranges::none_of(pairs, [&](const auto& other) {
        return other.a == pair.a && other.b == pair.b;
      });
      if (a != b && is_new) pairs.push_back(pair);
    }
  }
  return pairs;
}

std::vector<WatchedPair> read_clearance(const TomlTable& file,
                                        const CaseNames& names) {
  const Case& c = names.of;
  std::vector<WatchedPair> all;
  const auto tables = file.tables("clearance");
  for (const TomlTable& table : tables) {
    for (WatchedPair& pair : read_one(table, names)) {
      const auto same = std::ranges::find(all, place_of(pair), place_of);
      if (std::ranges::any_of(all, [&](const WatchedPair& other) {
            return other.name != pair.name &&
                   column_name(other.name) == column_name(pair.name);
          })) {
        table.must_be("name", "another one in columns, too");
      }
      if (same == all.end()) {
        all.push_back(std::move(pair));
      } else if (!same->is_plain() || !pair.is_plain()) {
        table.must_be(table.has("name") ? "name" : "b",
                      "of other bodies than those of another [[clearance]], or "
                      "have a name of its own");
      }
    }
  }
  if (tables.empty()) {
    const int count = static_cast<int>(c.bodies.size()) + 1;
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        if (!c.rigid_body(a).shapes.empty() && !c.rigid_body(b).shapes.empty())
          all.push_back({a, b});
      }
    }
  }
  std::ranges::sort(all, {}, place_of);
  return all;
}

}  // namespace separation
