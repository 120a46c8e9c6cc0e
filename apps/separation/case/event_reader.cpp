#include "separation/case/event_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

#include "separation/case/reading.hpp"

namespace separation {
namespace {

struct Condition {
  Event::Trigger trigger;
  std::string_view key;
  Interval allowed;
  Dimension dimension;
};
constexpr std::array<Condition, 3> conditions = {{
    {Event::Trigger::time, "time", Interval::non_negative(), Dimension::time},
    {Event::Trigger::angle,
     "angle",
     {-100 * std::numbers::pi, 100 * std::numbers::pi},
     Dimension::angle},
    {Event::Trigger::reaction, "reaction", Interval::positive(),
     Dimension::force},
}};

void read_condition(const TomlTable& table, Event& event) {
  const Condition* found = nullptr;
  for (const Condition& condition : conditions) {
    const auto value = table.optional_number(condition.key, condition.allowed,
                                             condition.dimension);
    if (!value) continue;
    if (found != nullptr) {
      table.fail(condition.key,
                 fmt::format("allowed: not together with {}", found->key));
    }
    found = &condition;
    event.trigger = condition.trigger;
    event.value = *value;
  }
  const auto delay =
      table.optional_number("delay", Interval::non_negative(), Dimension::time);
  if (found != nullptr) {
    if (delay) {
      table.fail("delay",
                 fmt::format("allowed: not together with {}", found->key));
    }
    if (event.trigger == Event::Trigger::time && event.after >= 0) {
      table.fail("after", "allowed: not together with time; see delay");
    }
    return;
  }
  if (event.after < 0) {
    table.fail_missing("time", "an event needs time, angle, reaction or after");
  }
  event.trigger = Event::Trigger::after;
  event.value = delay.value_or(0);
}

// The nodes that an event speaks of have to be there.
void check_nodes(const TomlTable& table, const CaseNames& names,
                 const Event& event) {
  for (const int i : event.bodies) {
    const Body& body = names.of.bodies[i];
    const bool hinge = body.hinge.kind != multibody::HingeKind::none;
    if (event.action == Event::Action::break_hinge ? !hinge : !body.lock) {
      table.fail("breaks",
                 fmt::format("body \"{}\" has none", body.rigid.name));
    }
    if (event.trigger == Event::Trigger::angle && !hinge) {
      table.fail("angle",
                 fmt::format("body \"{}\" has no hinge", body.rigid.name));
    }
    // 180 deg but for the rounding of units.
    constexpr double most = std::numbers::pi * (1 + 1e-15);
    if (event.trigger == Event::Trigger::angle &&
        body.hinge.kind == multibody::HingeKind::ball &&
        (event.value < 0 || event.value > most)) {
      table.fail("angle",
                 fmt::format("allowed: 0 deg to 180 deg on the ball hinge "
                             "of body \"{}\": it is the angle between two "
                             "directions",
                             body.rigid.name));
    }
    if (event.trigger == Event::Trigger::reaction &&
        (event.node == Event::Node::lock ? !body.lock : !hinge)) {
      table.fail("node", fmt::format("body \"{}\" has none", body.rigid.name));
    }
  }
}

}  // namespace

Event read_event(const TomlTable& table, const CaseNames& names) {
  Event event;
  event.name = table.text("name");
  event.bodies = names.bodies_of(table, "bodies");
  event.action =
      static_cast<Event::Action>(table.choice("breaks", {"lock", "hinge"}));
  event.after = names.event_of(table, "after", event.name);
  event.together = table.optional_boolean("together").value_or(false);
  read_condition(table, event);
  event.node = static_cast<Event::Node>(
      table.optional_choice("node", {"hinge", "lock"}).value_or(0));
  if (table.has("node") && event.trigger != Event::Trigger::reaction) {
    table.fail("node", "allowed: with reaction");
  }
  check_nodes(table, names, event);
  return event;
}

}  // namespace separation
