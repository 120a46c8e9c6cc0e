#include "separation/case/case_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "libcontact/base/complaint.hpp"

namespace separation {
namespace {

using contact::TomlTable;

std::vector<std::string> body_names(const Case& c, bool with_carrier) {
  std::vector<std::string> names;
  if (with_carrier) names.push_back(c.carrier.name);
  for (const Body& body : c.bodies) {
    if (names.empty() || names.back() != body.group) {
      names.push_back(body.group);
    }
  }
  for (const Body& body : c.bodies) {
    if (body.rigid.name != body.group) names.push_back(body.rigid.name);
  }
  return names;
}

}  // namespace

std::string circle_of(const std::vector<std::string>& names,
                      const std::vector<int>& next, int start,
                      std::string_view word) {
  int at = next[start];
  // More steps than names mean that another circle has been met.
  for (std::size_t i = 0; i < names.size() && at >= 0 && at != start; ++i) {
    at = next[at];
  }
  if (at != start) return {};
  std::string text = names[start];
  do {
    at = next[at];
    text += fmt::format(" {} {}", word, names[at]);
  } while (at != start);
  return text;
}

std::vector<int> CaseNames::rigid_bodies(std::string_view name) const {
  std::vector<int> found;
  if (of.carrier.name == name) found.push_back(0);
  for (std::size_t i = 0; i < of.bodies.size(); ++i) {
    if (of.bodies[i].group == name || of.bodies[i].rigid.name == name) {
      found.push_back(static_cast<int>(i) + 1);
    }
  }
  return found;
}

std::vector<int> CaseNames::rigid_bodies_of(const TomlTable& table,
                                            std::string_view key) const {
  return rigid_bodies_of(table, key, table.text(key));
}

std::vector<int> CaseNames::rigid_bodies_of(const TomlTable& table,
                                            std::string_view key,
                                            const std::string& name) const {
  auto found = rigid_bodies(name);
  if (found.empty()) {
    table.fail(key,
               contact::detail::unknown("body", name, body_names(of, true)));
  }
  return found;
}

std::vector<int> CaseNames::bodies_of(const TomlTable& table,
                                      std::string_view key) const {
  std::vector<int> bodies;
  for (const std::string& name : table.texts(key)) {
    const auto found = rigid_bodies(name);
    if (found.empty() || found.front() == 0) {
      table.fail(key,
                 contact::detail::unknown("body", name, body_names(of, false)));
    }
    for (const int body : found) {
      if (std::find(bodies.begin(), bodies.end(), body - 1) == bodies.end()) {
        bodies.push_back(body - 1);
      }
    }
  }
  if (bodies.empty()) {
    for (std::size_t i = 0; i < of.bodies.size(); ++i) {
      bodies.push_back(static_cast<int>(i));
    }
  }
  return bodies;
}

int CaseNames::event_of(const TomlTable& table, std::string_view key,
                        std::string_view except) const {
  const auto name = table.optional_text(key);
  return name ? event_called(table, key, *name, except) : -1;
}

int CaseNames::event_called(const TomlTable& table, std::string_view key,
                            const std::string& name,
                            std::string_view except) const {
  const auto found = std::find(events.begin(), events.end(), name);
  if (name == except) table.must_be(key, "another event");
  if (found == events.end()) {
    std::vector<std::string> others = events;
    std::erase(others, except);
    table.fail(key, contact::detail::unknown("event", name, others));
  }
  return static_cast<int>(found - events.begin());
}

Clock CaseNames::clock(const TomlTable& table, const std::string& key,
                       const Clock& otherwise) const {
  const auto time = table.optional_number(key + "_at");
  const int event = event_of(table, key + "_at_event");
  const auto delay = table.optional_number(key + "_delay");
  table.refuse_both(key + "_at_event", key + "_at");
  if (delay && event < 0) table.needs(key + "_delay", key + "_at_event");
  if (event >= 0) return {0, event, delay.value_or(0)};
  return time ? Clock{*time, -1, 0} : otherwise;
}

std::pair<Clock, Clock> CaseNames::window(const TomlTable& table,
                                          std::string_view what) const {
  const Clock begin = clock(table, "starts", Clock{});
  const Clock end = clock(table, "ends", never);
  if (begin.event != end.event) return {begin, end};
  const bool timed = begin.event < 0;
  const double from = timed ? begin.time : begin.delay;
  const double to = timed ? end.time : end.delay;
  if (to > from) return {begin, end};
  const char* const key = timed ? "ends_at" : "ends_delay";
  table.must_be(table.has(key) ? key : "ends_at_event",
                fmt::format("later than {} begins, {:.6g} s{}", what, from,
                            timed ? "" : " after the event"));
}

}  // namespace separation
