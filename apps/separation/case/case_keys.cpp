#include "separation/case/case_keys.hpp"

#include "libcontact/files/joint_tables.hpp"
#include "separation/case/force_kind.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/stop_reader.hpp"

namespace separation {
namespace {

using contact::Dimension;
using contact::integer_key;
using contact::KnownKey;
using contact::number_key;
using contact::table_key;
using contact::word_key;
using Keys = contact::KnownKeys;

Keys with(Keys keys, const Keys& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

// The same, of some kinds only.
Keys of(std::string_view kinds, Keys keys) {
  for (KnownKey& key : keys) key.kinds = kinds;
  return keys;
}

Keys run_keys() {
  const auto time = [](std::string_view key) {
    return number_key(key, Dimension::time, Interval::positive());
  };
  constexpr Interval tolerance{1e-14, 1e-2};
  return {
      time("end_time"),
      time("output_step"),
      word_key("friction", {friction_choices.begin(), friction_choices.end()}),
      word_key("integrator", {"adaptive", "rk4"}),
      time("step"),
      number_key("relative_tolerance", tolerance),
      number_key("absolute_tolerance", tolerance),
      time("longest_step")};
}

Keys shape_keys() {
  Keys keys =
      with({word_key("kind", {"capsule", "cylinder", "cone", "hull", "box"}),
            {"name"}},
           of("capsule cylinder cone",
              {{"from", Dimension::length},
               {"to", Dimension::length},
               number_key("radius", Dimension::length, Interval::positive())}));
  keys = with(keys, of("hull", {{"points", Dimension::length}}));
  return with(
      keys,
      of("box", {{"centre", Dimension::length},
                 number_key("size", Dimension::length, Interval::positive()),
                 number_key("rotation", Dimension::angle, most_turns)}));
}

Keys rigid_body_keys() {
  return {{"name"},
          number_key("mass", Dimension::mass, Interval::positive()),
          number_key("density_kg_per_m3", Interval::positive()),
          {"com", Dimension::length},
          {"inertia", Dimension::inertia},
          {"principal_inertia", Dimension::inertia},
          table_key("shape", shape_keys()),
          table_key("direction", {{"name"}, {"vector"}})};
}

Keys start_keys() {
  return {{"position", Dimension::length},
          {"velocity", Dimension::velocity},
          number_key("rotation", Dimension::angle, most_turns),
          {"angular_velocity", Dimension::angular_velocity}};
}

Keys hinge_keys() {
  std::vector<std::string> kinds;
  for (const HingeType& type : hinge_types()) kinds.emplace_back(type.name);
  Keys keys = {
      word_key("kind", kinds),
      {"name"},
      {"on"},
      {"body_point", Dimension::length, {}, {}, "load_point"},
      {"carrier_point", Dimension::length},
      {"parent_point", Dimension::length},
      number_key("zero_rotation", Dimension::angle, most_turns),
      table_key("stop", stop_keys()),
      table_key("torque_margin", margin_keys()),
      table_key("joint",
                with(contact::joint_keys(),
                     {{.key = "file", .of_file = contact::joint_keys()},
                      {"position", Dimension::length},
                      {.key = "in_seat", .former = "in_seat"},
                      {"without_seat"},
                      number_key("seat_loads", Dimension::force,
                                 Interval::positive()),
                      {"seat_table"}}))};
  for (const HingeType& type : hinge_types()) {
    keys = with(keys, of(type.name, type.keys));
  }
  return keys;
}

Keys pattern_keys() {
  return {integer_key("count", 2, 1000), {"axis"}, {"first", Dimension::angle}};
}

Keys body_keys() {
  return with(
      rigid_body_keys(),
      {table_key("hinge", hinge_keys()),
       table_key(
           "lock",
           {{"name"}, {"body_point", Dimension::length, {}, {}, "load_point"}}),
       table_key("start",
                 with(start_keys(), {{"angle", Dimension::angle},
                                     {"rate", Dimension::angular_velocity}})),
       table_key("pattern", pattern_keys())});
}

Keys event_keys() {
  constexpr auto non_negative = Interval::non_negative();
  return {{"name"},
          {"bodies", Dimension::number, {}, {}, "loads"},
          word_key("breaks", {"lock", "hinge", "latch"}),
          word_key("locks", {"hinge"}),
          word_key("ends", {"run"}),
          number_key("rate_below", Dimension::angular_velocity,
                     Interval::positive()),
          {"after"},
          {"together"},
          word_key("node", {"hinge", "lock"}),
          number_key("time", Dimension::time, non_negative),
          number_key("delay", Dimension::time, non_negative),
          number_key("angle", Dimension::angle, most_turns),
          number_key("reaction", Dimension::force, Interval::positive()),
          {"touches"},
          {"clearance"},
          number_key("distance", Dimension::length, non_negative)};
}

Keys clearance_keys() {
  return {{"a"}, {"b"}, {"name"}, {"a_shapes"}, {"b_shapes"}};
}

// While something is: KEY_at or KEY_at_event with KEY_delay.
Keys window_keys() {
  const auto time = [](std::string_view key) {
    return number_key(key, Dimension::time, Interval::non_negative());
  };
  return {time("starts_at"), {"starts_at_event"}, time("starts_delay"),
          time("ends_at"),   {"ends_at_event"},   time("ends_delay")};
}

Keys force_keys() {
  std::vector<std::string> kinds;
  for (const ForceKind& kind : force_kinds()) kinds.emplace_back(kind.name);
  Keys keys =
      with({word_key("kind", kinds), {"name"}, {"body"}}, window_keys());
  for (const ForceKind& kind : force_kinds()) {
    keys = with(keys, of(kind.name, kind.keys));
    if (!kind.has_pattern) continue;
    keys = with(keys, of(kind.name, {table_key("pattern", pattern_keys())}));
  }
  return keys;
}

}  // namespace

Keys case_keys() {
  return {
      {"name"},
      {"gravity", Dimension::acceleration},
      table_key("run", run_keys()),
      table_key(
          "carrier",
          with(rigid_body_keys(),
               {{"fixed"},
                table_key("start", start_keys()),
                table_key("drive", {{"acceleration", Dimension::acceleration},
                                    {"angular_acceleration",
                                     Dimension::angular_acceleration}})})),
      {"body", Dimension::number, body_keys(), {}, "load"},
      table_key("event", event_keys()),
      table_key("force", force_keys()),
      table_key("tip_off", {{"body"}, {"events"}, {"direction"}}),
      table_key("clearance", with(clearance_keys(), window_keys()))};
}

}  // namespace separation
