#include "separation/case/case_keys.hpp"

#include "libcontact/files/joint_tables.hpp"
#include "separation/case/force_kind.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/stop_reader.hpp"

namespace separation {
namespace {

using contact::Dimension;
using contact::KnownKey;
using contact::table_key;
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
  return {{"end_time", Dimension::time},
          {"output_step", Dimension::time},
          {"friction"},
          {"integrator"},
          {"step", Dimension::time},
          {"relative_tolerance"},
          {"absolute_tolerance"},
          {"longest_step", Dimension::time}};
}

Keys shape_keys() {
  Keys keys = with({{"kind"}, {"name"}}, of("capsule cylinder cone",
                                            {{"from", Dimension::length},
                                             {"to", Dimension::length},
                                             {"radius", Dimension::length}}));
  keys = with(keys, of("hull", {{"points", Dimension::length}}));
  return with(keys, of("box", {{"centre", Dimension::length},
                               {"size", Dimension::length},
                               {"rotation", Dimension::angle}}));
}

Keys rigid_body_keys() {
  return {{"name"},
          {"mass", Dimension::mass},
          {"density_kg_per_m3"},
          {"com", Dimension::length},
          {"inertia", Dimension::inertia},
          {"principal_inertia", Dimension::inertia},
          table_key("shape", shape_keys()),
          table_key("direction", {{"name"}, {"vector"}})};
}

Keys start_keys() {
  return {{"position", Dimension::length},
          {"velocity", Dimension::velocity},
          {"rotation", Dimension::angle},
          {"angular_velocity", Dimension::angular_velocity}};
}

Keys hinge_keys() {
  Keys keys = {
      {"kind"},
      {"name"},
      {"on"},
      {"body_point", Dimension::length, {}, {}, "load_point"},
      {"carrier_point", Dimension::length},
      {"parent_point", Dimension::length},
      {"zero_rotation", Dimension::angle},
      table_key("stop", stop_keys()),
      table_key("torque_margin", margin_keys()),
      table_key("joint",
                with(contact::joint_keys(),
                     {{.key = "file", .of_file = contact::joint_keys()},
                      {"position", Dimension::length},
                      {.key = "in_seat", .former = "in_seat"},
                      {"without_seat"},
                      {"seat_loads", Dimension::force},
                      {"seat_table"}}))};
  for (const HingeType& type : hinge_types()) {
    keys = with(keys, of(type.name, type.keys));
  }
  return keys;
}

Keys pattern_keys() {
  return {{"count"}, {"axis"}, {"first", Dimension::angle}};
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
  return {{"name"},
          {"bodies", Dimension::number, {}, {}, "loads"},
          {"breaks"},
          {"locks"},
          {"ends"},
          {"rate_below", Dimension::angular_velocity},
          {"after"},
          {"together"},
          {"node"},
          {"time", Dimension::time},
          {"delay", Dimension::time},
          {"angle", Dimension::angle},
          {"reaction", Dimension::force},
          {"touches"},
          {"clearance"},
          {"distance", Dimension::length}};
}

Keys clearance_keys() {
  return {{"a"}, {"b"}, {"name"}, {"a_shapes"}, {"b_shapes"}};
}

// While something is: KEY_at or KEY_at_event with KEY_delay.
Keys window_keys() {
  return {{"starts_at", Dimension::time},
          {"starts_at_event"},
          {"starts_delay", Dimension::time},
          {"ends_at", Dimension::time},
          {"ends_at_event"},
          {"ends_delay", Dimension::time}};
}

Keys force_keys() {
  Keys keys = with({{"kind"}, {"name"}, {"body"}}, window_keys());
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
