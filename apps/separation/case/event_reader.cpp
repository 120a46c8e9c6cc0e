#include "separation/case/event_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "libcontact/base/complaint.hpp"
#include "separation/case/clearance_reader.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

struct Condition {
  Event::Trigger trigger;
  std::string_view key;
};
constexpr std::array<Condition, 3> conditions = {{
    {Event::Trigger::time, "time"},
    {Event::Trigger::angle, "angle"},
    {Event::Trigger::reaction, "reaction"},
}};

// Bodies that come so near to each other.
bool read_distance(const TomlTable& table, const CaseNames& names,
                   Event& event) {
  table.refuse_both("clearance", "touches");
  const bool touches = table.has("touches");
  const auto distance = table.optional_number("distance");
  if (distance && !table.has("clearance")) table.needs("distance", "clearance");
  if (!touches && !table.has("clearance")) return false;
  event.trigger = Event::Trigger::distance;
  event.value = distance.value_or(0);
  if (touches) {
    const auto bodies = table.texts("touches");
    if (bodies.size() != 2) table.must_be("touches", "two names of bodies");
    event.pairs =
        pairs_of(table, {bodies[0], bodies[1]}, {"touches", "touches"}, names);
    return true;
  }
  const std::string name = table.text("clearance");
  std::vector<std::string> known;
  for (const WatchedPair& pair : names.of.clearance) {
    if (pair.name == name) event.pairs.push_back(pair);
    if (!pair.name.empty() &&
        std::ranges::find(known, pair.name) == known.end()) {
      known.push_back(pair.name);
    }
  }
  if (name.empty() || event.pairs.empty()) {
    table.fail("clearance", contact::detail::unknown("clearance", name, known));
  }
  return true;
}

// Bodies that it is about, if the file does not say so.
std::vector<int> bodies_near(const Event& event) {
  std::vector<int> bodies;
  for (const WatchedPair& pair : event.pairs) {
    for (const int body : {pair.a, pair.b}) {
      if (body > 0 && std::ranges::count(bodies, body - 1) == 0) {
        bodies.push_back(body - 1);
      }
    }
  }
  std::ranges::sort(bodies);
  return bodies;
}

void read_condition(const TomlTable& table, const CaseNames& names,
                    Event& event) {
  const Condition* found = nullptr;
  for (const Condition& condition : conditions) {
    const auto value = table.optional_number(condition.key);
    if (!value) continue;
    if (found != nullptr) table.refuse_both(condition.key, found->key);
    found = &condition;
    event.trigger = condition.trigger;
    event.value = *value;
  }
  if (table.has("touches") || table.has("clearance")) {
    const char* const key = table.has("touches") ? "touches" : "clearance";
    if (found != nullptr) table.refuse_both(key, found->key);
    table.refuse_both("delay", key);
  }
  if (read_distance(table, names, event)) return;
  const auto delay = table.optional_number("delay");
  if (found != nullptr) {
    table.refuse_both("delay", found->key);
    // An event some time after another has a delay.
    table.refuse_both("after", "time");
    return;
  }
  if (event.after < 0) {
    table.needs("time, angle, reaction, touches, clearance or after");
  }
  event.trigger = Event::Trigger::after;
  event.value = delay.value_or(0);
}

void read_action(const TomlTable& table, Event& event) {
  table.refuse_both("locks", "breaks");
  table.refuse_both("ends", "breaks");
  table.refuse_both("ends", "locks");
  if (table.optional_choice("locks")) {
    event.action = Event::Action::latch;
  } else if (table.has("breaks")) {
    event.action = static_cast<Event::Action>(table.choice("breaks"));
  } else if (table.optional_choice("ends")) {
    event.action = Event::Action::end_run;
  } else if (table.has("touches") || table.has("clearance")) {
    event.action = Event::Action::none;
  } else {
    table.needs("breaks, locks or ends");
  }
}

void read_latch(const TomlTable& table, Event& event) {
  const auto rate = table.optional_number("rate_below");
  if (event.action != Event::Action::latch) {
    if (rate) table.needs("rate_below", "locks");
    return;
  }
  if (event.trigger == Event::Trigger::reaction) {
    table.needs("reaction", "breaks");
  }
  if (event.trigger == Event::Trigger::distance) {
    table.needs(table.has("touches") ? "touches" : "clearance",
                "breaks or ends");
  }
  if (!rate) return;
  if (event.trigger != Event::Trigger::angle)
    table.needs("rate_below", "angle");
  event.rate_below = *rate;
}

// The nodes that an event speaks of have to be there.
void check_nodes(const TomlTable& table, const CaseNames& names,
                 const Event& event) {
  for (const int i : event.bodies) {
    const Body& body = names.of.bodies[i];
    const bool hinge = body.hinge.kind != multibody::HingeKind::none;
    const bool lock = event.action == Event::Action::break_lock;
    if (event.action < Event::Action::end_run && (lock ? !body.lock : !hinge)) {
      table.needs(table.has("locks") ? "locks" : "breaks",
                  fmt::format("one on body \"{}\"", body.rigid.name));
    }
    if (event.trigger == Event::Trigger::angle && !hinge) {
      table.needs("angle",
                  fmt::format("a hinge on body \"{}\"", body.rigid.name));
    }
    if (event.trigger == Event::Trigger::angle) {
      check_angles(
          table, body.hinge, event.value, event.value,
          fmt::format("the ball hinge of body \"{}\"", body.rigid.name));
    }
    if (event.trigger == Event::Trigger::reaction &&
        (event.node == Event::Node::lock ? !body.lock : !hinge)) {
      table.needs("node", fmt::format("one on body \"{}\"", body.rigid.name));
    }
  }
}

}  // namespace

Event read_event(const TomlTable& table, const CaseNames& names) {
  Event event;
  event.name = table.text("name");
  if (names.of.bodies.empty()) table.needs("one or more [[body]]");
  event.bodies = names.bodies_of(table, "bodies");
  read_action(table, event);
  event.after = names.event_of(table, "after", event.name);
  event.together = table.flag("together");
  read_condition(table, names, event);
  if (!table.has("bodies") && !event.pairs.empty()) {
    event.bodies = bodies_near(event);
  }
  read_latch(table, event);
  event.node =
      static_cast<Event::Node>(table.optional_choice("node").value_or(0));
  if (table.has("node") && event.trigger != Event::Trigger::reaction) {
    table.needs("node", "reaction");
  }
  check_nodes(table, names, event);
  return event;
}

}  // namespace separation
