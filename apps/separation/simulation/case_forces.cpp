#include "separation/simulation/case_forces.hpp"

#include <algorithm>
#include <cmath>

#include "separation/case/force_law.hpp"

namespace separation {
using multibody::BodyForce;
using multibody::BodyMotion;

double History::time_of(const Clock& clock, int body, const Case& c) const {
  if (clock.event < 0) return clock.time;
  const auto& times = events[clock.event];
  const auto& bodies = c.events[clock.event].bodies;
  const bool own = body > 0 && std::find(bodies.begin(), bodies.end(),
                                         body - 1) != bodies.end();
  const double event =
      own ? times[body - 1] : *std::min_element(times.begin(), times.end());
  return event + clock.delay;
}

double History::release_of(int body, const Case& c) const {
  double first = not_yet;
  for (std::size_t e = 0; body > 0 && e < c.events.size(); ++e) {
    if (c.events[e].action == Event::Action::break_hinge) {
      first = std::min(first, events[e][body - 1]);
    }
  }
  return first;
}

CaseForces::CaseForces(const Case& c, const History& history)
    : case_(c), stops_(c, history), given_(c, history), flow_(c, history) {
  for (std::size_t i = 0; i < c.forces.size(); ++i) {
    const Force& force = c.forces[i];
    if (history.spent[i]) continue;
    const auto time_of = [&](const Clock& clock) {
      return history.time_of(clock, force.body, c);
    };
    const double end = time_of(force.end);
    const double off = force.law->ends_with_hinge()
                           ? history.release_of(force.body, c)
                           : flow_.empty_at(static_cast<int>(i));
    const Active active{&force, time_of(force.begin), std::min(end, off),
                        time_of(force.law->own_clock())};
    if (std::isinf(active.begin)) continue;
    active_.push_back(active);
    breaks_.insert(breaks_.end(), {active.begin, active.end, active.own});
    force.law->add_breaks(active.begin, breaks_);
  }
  const auto add_window = [&](const WatchedPair& pair) {
    if (pair.is_plain()) return;
    breaks_.push_back(history.time_of(pair.begin, pair, c));
    breaks_.push_back(history.time_of(pair.end, pair, c));
  };
  std::ranges::for_each(c.clearance, add_window);
  std::sort(breaks_.begin(), breaks_.end());
}

ForceInstant CaseForces::instant(const Active& active, double time,
                                 std::span<const BodyMotion> bodies) const {
  return {case_, active.force->body, bodies, time, active.begin, active.own};
}

void CaseForces::add_forces(double time, std::span<const BodyMotion> bodies,
                            std::span<BodyForce> forces) const {
  for (const Active& active : active_) {
    if (!active.is_on(time)) continue;
    active.force->law->add(instant(active, time, bodies), forces);
  }
  stops_.add_forces(bodies, forces);
  given_.add_forces(bodies, forces);
  flow_.add_forces(time, bodies, forces);
}

void CaseForces::add_kinks(double during, std::span<const BodyMotion> bodies,
                           std::vector<multibody::KinkedVariable>& to) const {
  for (const Active& active : active_) {
    if (!active.is_on(during)) continue;
    active.force->law->add_kinks(instant(active, during, bodies), to);
  }
  stops_.add_kinks(bodies, to);
}

std::optional<BodyForce> CaseForces::of(
    int force, double time, std::span<const BodyMotion> bodies) const {
  const Force* wanted = &case_.forces[force];
  const auto active = std::find_if(
      active_.begin(), active_.end(),
      [&](const Active& a) { return a.force == wanted && a.is_on(time); });
  if (active == active_.end()) return {};
  std::vector<BodyForce> forces(bodies.size());
  wanted->law->add(instant(*active, time, bodies), forces);
  return forces[wanted->body];
}

bool stores_energy(const Case& c) {
  return std::ranges::any_of(
      c.forces, [](const Force& force) { return force.law->stores(); });
}

double CaseForces::stored_energy(double time,
                                 std::span<const BodyMotion> bodies) const {
  double sum = 0;
  for (const Active& active : active_) {
    if (!active.is_on(time)) continue;
    sum += active.force->law->stored(instant(active, time, bodies));
  }
  return sum;
}

double CaseForces::next_break(double time) const {
  const auto next = std::upper_bound(breaks_.begin(), breaks_.end(), time);
  return next == breaks_.end() ? History::not_yet : *next;
}

}  // namespace separation
