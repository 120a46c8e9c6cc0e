#include "separation/case/case_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "separation/case/case_keys.hpp"
#include "separation/case/case_names.hpp"
#include "separation/case/clearance_reader.hpp"
#include "separation/case/event_reader.hpp"
#include "separation/case/force_reader.hpp"
#include "separation/case/form/body_tree.hpp"
#include "separation/case/form/case_parts.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

// Columns are named after bodies, with underscores for blanks.
void check_name(const TomlTable& table, const Case& c,
                const std::string& name) {
  const std::string column = column_name(name);
  const auto refuse_as = [&](const std::string& other) {
    if (column_name(other) != column) return;
    table.must_be("name",
                  other == name
                      ? "a name that no other body has"
                      : fmt::format("a name that is not that of \"{}\" "
                                    "in columns, where blanks are underscores",
                                    other));
  };
  refuse_as(c.carrier.name);
  for (const Body& body : c.bodies) {
    refuse_as(body.group);
    refuse_as(body.rigid.name);
  }
}

void read_all_bodies(const TomlTable& file, const JointLaws& laws,
                     contact::SharedLaws& made, Case& c, CaseNames& names) {
  BodyTree tree = read_bodies(file, c.carrier, laws, made);
  names.turns = std::move(tree.turns);
  auto next = tree.bodies.begin();
  for (std::size_t i = 0; i < tree.counts.size(); ++i) {
    const TomlTable table = file.tables("body")[i];
    const auto end = next + tree.counts[i];
    check_name(table, c, next->group);
    std::for_each(next, end, [&](const Body& copy) {
      check_name(table, c, copy.rigid.name);
    });
    c.bodies.insert(c.bodies.end(), next, end);
    next = end;
  }
}

// A latch that opens has to be there.
void check_latches(const std::vector<TomlTable>& tables, const Case& c) {
  for (std::size_t i = 0; i < tables.size(); ++i) {
    if (c.events[i].action != Event::Action::open_latch) continue;
    for (const int body : c.events[i].bodies) {
      if (c.has_latch(body)) continue;
      tables[i].needs("breaks",
                      fmt::format("an event that locks the hinge of \"{}\"",
                                  c.bodies[body].rigid.name));
    }
  }
}

void read_event_names(const TomlTable& file, CaseNames& names) {
  for (const TomlTable& table : file.tables("event")) {
    const std::string name = table.text("name");
    if (std::find(names.events.begin(), names.events.end(), name) !=
        names.events.end()) {
      table.must_be("name", "a name that no other event has");
    }
    // Tip-off at the end has it.
    if (name == "end") table.must_be("name", "another one than \"end\"");
    names.events.push_back(name);
  }
}

void read_events(const TomlTable& file, Case& c, const CaseNames& names) {
  const auto tables = file.tables("event");
  for (const TomlTable& table : tables) {
    c.events.push_back(read_event(table, names));
  }
  check_latches(tables, c);
  std::vector<int> after;
  std::vector<int> waits;  // for it, or for the window of its clearance
  for (const Event& event : c.events) {
    after.push_back(event.after);
    const int opens = event.pairs.empty() ? -1 : event.pairs[0].begin.event;
    waits.push_back(opens < 0 ? event.after : opens);
  }
  const auto refuse = [&](const std::vector<int>& next, const char* key,
                          const char* rule, const char* word) {
    for (std::size_t i = 0; i < tables.size(); ++i) {
      const std::string circle =
          circle_of(names.events, next, static_cast<int>(i), word);
      if (circle.empty() || !tables[i].has(key)) continue;
      tables[i].must_be(key, fmt::format("{}: {}", rule, circle));
    }
  };
  refuse(after, "after", "an event that does not wait for this one", "after");
  refuse(waits, "clearance", "one whose window does not wait for this event",
         "waits for");
}

void read_all_forces(const TomlTable& file, const CaseNames& names, Case& c) {
  std::set<std::string> taken;
  for (const TomlTable& table : file.tables("force")) {
    if (!taken.insert(table.text("name")).second) {
      table.must_be("name", "a name that no other force has");
    }
    for (Force& force : read_forces(table, names)) {
      c.forces.push_back(std::move(force));
    }
  }
  check_propellant(file, c);
  if (std::ranges::none_of(c.forces, &Force::burns)) return;
  for (const TomlTable& table : file.tables("body")) {
    check_beside_flow(
        table, *std::ranges::find(c.bodies, table.text("name"), &Body::group));
  }
}

Case whole_case(const TomlTable& file, const JointLaws& laws) {
  contact::SharedLaws made;
  Case c = case_of_file(file, laws, made);
  c.content = file.canonical_text();
  return c;
}

}  // namespace

void read_tip_offs(const TomlTable& file, const CaseNames& names, Case& c) {
  for (const TomlTable& table : file.tables("tip_off")) {
    for (const int body : names.rigid_bodies_of(table, "body")) {
      if (std::ranges::count(c.tip_offs, body, &TipOff::body) > 0) {
        table.must_be("body", "a body of no other [[tip_off]]");
      }
      TipOff of{body, -1, {}};
      if (const auto name = table.optional_text("direction")) {
        const auto& all = c.rigid_body(body).directions;
        const auto found = std::ranges::find(all, *name, &NamedDirection::name);
        if (found == all.end()) {
          std::vector<std::string> known;
          for (const NamedDirection& d : all) known.push_back(d.name);
          table.fail("direction",
                     contact::detail::unknown("direction", *name, known));
        }
        of.direction = found->vector;
      }
      c.tip_offs.push_back(of);
      if (!table.has("events")) continue;
      for (const std::string& name : table.texts("events")) {
        of.event = names.event_called(table, "events", name);
        const auto is_same = [&of](const TipOff& other) {
          return other.body == of.body && other.event == of.event;
        };
        if (std::ranges::any_of(c.tip_offs, is_same)) {
          table.must_be("events", "different ones");
        }
        c.tip_offs.push_back(of);
      }
    }
  }
}

Case case_of_file(const TomlTable& file, const JointLaws& laws,
                  contact::SharedLaws& made) {
  Case c;
  c.file = file.source();
  c.name = file.text("name");
  read_run_of(file, c);
  read_carrier_of(file, c);
  CaseNames names{c, {}, {}};
  read_all_bodies(file, laws, made, c, names);
  read_event_names(file, names);
  c.clearance = read_clearance(file, names);
  read_events(file, c, names);
  read_all_forces(file, names, c);
  read_tip_offs(file, names, c);
  file.refuse_idle();
  return c;
}

Case read_case(const std::filesystem::path& path, const JointLaws& laws,
               const contact::KeySettings& settings) {
  return whole_case(TomlTable::from_file(path, case_keys(), settings), laws);
}

Case parse_case(std::string_view text, const std::string& source,
                const JointLaws& laws, const contact::KeySettings& settings,
                const std::filesystem::path& folder) {
  return whole_case(
      TomlTable::from_text(text, source, case_keys(), folder, settings), laws);
}

}  // namespace separation
