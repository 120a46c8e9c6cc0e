#include "separation/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/error.hpp"
#include "separation/case/force_law.hpp"
#include "separation/case/hinge_reader.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/case/system_of.hpp"
#include "separation/simulation/compliant_stops.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using multibody::HingeKind;
using multibody::HingeMode;
using multibody::MotionSample;

multibody::MotionStart start_of(const Case& c) {
  multibody::MotionStart start;
  start.carrier = c.carrier_start;
  for (const Body& body : c.bodies) start.bodies.push_back(body.start);
  return start;
}

std::vector<multibody::HingeFriction> friction_of(const Case& c,
                                                  FrictionChoice choice) {
  std::vector<multibody::HingeFriction> friction;
  for (const Body& body : c.bodies) {
    friction.push_back(make_friction(body.hinge, choice));
  }
  return friction;
}

multibody::MotionOptions options_of(const Case& c) {
  multibody::MotionOptions options = c.options;
  for (int i = 0; i < static_cast<int>(c.bodies.size()); ++i) {
    const Hinge& hinge = c.bodies[i].hinge;
    for (const HingeStop& stop : hinge.stops) {
      if (!stop.is_rigid()) continue;
      options.stops.push_back({i, stop.angle, stop.side, stop.restitution,
                               hinge.body_direction, hinge.parent_direction});
    }
  }
  return options;
}

// Whether a value is at an angle up to rounding, rad.
bool is_at(double angle, double value) {
  return std::abs(angle - value) <= 1e-12 * std::max(1.0, std::abs(value));
}

}  // namespace

NodeReactions node_reactions(const Body& body,
                             const multibody::HingeSample& hinge) {
  NodeReactions result{hinge.reaction_force, Vector3d::Zero()};
  if (hinge.mode != HingeMode::locked || !body.lock) return result;
  const Vector3d d = body.lock->body_point - body.hinge.body_point;
  result.lock = hinge.reaction_moment.cross(d) / d.squaredNorm();
  result.hinge -= result.lock;
  return result;
}

Simulation::Simulation(const Case& c, FrictionChoice friction)
    : case_(c),
      history_(c),
      forces_(std::make_shared<CaseForces>(c, history_)),
      motion_(system_of(c), friction_of(c, friction), forces_, start_of(c),
              options_of(c)) {
  if (c.has_touches()) touches_.emplace(c);
  add_events();
  add_stops();
  if (end_pushes()) renew_forces();
}

Simulation::~Simulation() = default;

double Simulation::angle(int body) const { return angle(sample(), body); }

double Simulation::angle(const MotionSample& sample, int body) const {
  const Hinge& hinge = case_.bodies[body].hinge;
  if (hinge.kind == HingeKind::none) return NAN;
  if (hinge_type(hinge).counts_turns &&
      sample.mode(body) != HingeMode::released) {
    return sample.angle(body);
  }
  return hinge_angle(hinge, sample.motions()[hinge.on], sample.body(body));
}

// Every event of every body becomes a function of the motion, every force with
// a stroke one that ends its push. A stroke at its beginning is end_pushes()'s
// business; the end of its time belongs to it, as steps end there and its
// stroke may be used up in the last one.
void Simulation::add_events() {
  for (int e = 0; e < static_cast<int>(case_.events.size()); ++e) {
    const Event& event = case_.events[e];
    sense_.emplace_back(case_.bodies.size(), 1.0);
    if (event.trigger == Event::Trigger::time ||
        event.trigger == Event::Trigger::after) {
      continue;
    }
    for (const int body : event.bodies) {
      const Happening h{e, body};
      if (event.trigger == Event::Trigger::distance) {
        add_touches(h);
        continue;
      }
      if (event.trigger == Event::Trigger::angle && event.value < angle(body)) {
        sense_[e][body] = -1;
      }
      motion_.add_event({[this, h](const MotionSample& sample) {
                           return has_happened(h) || !is_armed(h)
                                      ? -1.0
                                      : condition(sample, h);
                         },
                         multibody::MotionEvent::Crossing::rising});
      meanings_.push_back({h});
      // A latch with rate_below also catches a body that comes to rest at its
      // angle.
      if (std::isinf(event.rate_below)) continue;
      motion_.add_event({[this, h](const MotionSample& sample) {
                           return !has_happened(h) && is_armed(h) &&
                                          is_at_latch(sample, h) &&
                                          sample.mode(h.body) ==
                                              HingeMode::resting
                                      ? 1.0
                                      : -1.0;
                         },
                         multibody::MotionEvent::Crossing::rising});
      meanings_.push_back({h});
    }
  }
  for (int f = 0; f < static_cast<int>(case_.forces.size()); ++f) {
    const Force& force = case_.forces[f];
    if (!force.law->overrun(force.body, sample().motions())) continue;
    motion_.add_event(
        {[this, &force, f](const MotionSample& sample) {
           const double time = sample.time();
           if (history_.spent[f] ||
               time <= history_.time_of(force.begin, force.body, case_) ||
               time > history_.time_of(force.end, force.body, case_)) {
             return -1.0;
           }
           return *force.law->overrun(force.body, sample.motions());
         },
         multibody::MotionEvent::Crossing::rising});
    meanings_.push_back({{-1, -1}, f});
  }
}

void Simulation::add_touches(const Happening& h) {
  // Nearest points are known to 1e-8 m (nearest.hpp).
  constexpr double negligible = 1e-8;
  for (const int pair : touches_->pairs_of(h.event, h.body)) {
    motion_.add_event({[this, h, pair](const MotionSample& sample) {
                         if (has_happened(h)) return -1.0;
                         return is_armed(h)
                                    ? touches_->condition(h.event, pair,
                                                          history_, sample)
                                    : 1.0;
                       },
                       multibody::MotionEvent::Crossing::rising,
                       [this, h, pair](const MotionSample& sample) {
                         return has_happened(h) || !is_armed(h)
                                    ? 0.0
                                    : touches_->speed(h.event, pair, sample);
                       },
                       negligible});
    meanings_.push_back({{h.event, h.body, pair}});
  }
}

double Simulation::approach(const Happening& h) const {
  return h.pair < 0 ? 0 : touches_->approach(h.event, h.pair, sample());
}

bool Simulation::is_over() const {
  for (std::size_t e = 0; e < case_.events.size(); ++e) {
    if (case_.events[e].action == Event::Action::end_run &&
        std::ranges::any_of(history_.events[e], [](double time) {
          return time != History::not_yet;
        })) {
      return true;
    }
  }
  return false;
}

// Every touch of a compliant stop becomes a function of the motion.
void Simulation::add_stops() {
  for (int i = 0; i < static_cast<int>(case_.bodies.size()); ++i) {
    const auto& stops = case_.bodies[i].hinge.stops;
    for (std::size_t k = 0; k < stops.size(); ++k) {
      if (stops[k].is_rigid()) continue;
      motion_.add_event({[this, i, &stop = stops[k]](const MotionSample& s) {
                           return s.mode(i) == HingeMode::released
                                      ? 1.0
                                      : stop.gap(angle(s, i));
                         },
                         multibody::MotionEvent::Crossing::falling});
      meanings_.push_back({{-1, -1}, -1, i, k});
    }
  }
}

void Simulation::take_impacts() {
  const auto& all = motion_.impacts();
  impacts_.insert(impacts_.end(), all.begin() + impacts_taken_, all.end());
  impacts_taken_ = all.size();
}

double Simulation::stop_moment(const MotionSample& sample,
                               const multibody::HingeSample& of,
                               int body) const {
  return of.stop_moment + forces_->stop_moment(body, sample.motions());
}

double Simulation::latch_moment(const multibody::HingeSample& of,
                                int body) const {
  if (of.mode != HingeMode::latched) return 0;
  const Vector3d held = of.reaction_moment;
  const Hinge& hinge = case_.bodies[body].hinge;
  if (hinge.kind != HingeKind::axis) return held.norm();
  return std::abs(held.dot(hinge.zero_rotation.transpose() * hinge.axis));
}

bool Simulation::engages(const Happening& h) const {
  const double rate = sample().hinge(h.body).relative_angular_velocity.norm();
  return !(rate > case_.events[h.event].rate_below);
}

bool Simulation::is_at_latch(const MotionSample& sample,
                             const Happening& h) const {
  return is_at(angle(sample, h.body), case_.events[h.event].value);
}

bool Simulation::has_happened(const Happening& h) const {
  return history_.events[h.event][h.body] != History::not_yet;
}

bool Simulation::is_due(const Happening& h) const {
  return std::ranges::find(due_, h) != due_.end();
}

bool Simulation::is_armed(const Happening& h) const {
  const int after = case_.events[h.event].after;
  if (after < 0) return true;
  const Clock clock{0, after, 0};
  return history_.time_of(clock, h.body + 1, case_) != History::not_yet;
}

// Time of an event that does not depend on the motion.
double Simulation::due_time(const Happening& h) const {
  const Event& event = case_.events[h.event];
  if (event.trigger == Event::Trigger::time) return event.value;
  if (event.trigger != Event::Trigger::after) return History::not_yet;
  return history_.time_of({0, event.after, event.value}, h.body + 1, case_);
}

// Crosses 0 upwards when the event comes.
double Simulation::condition(const MotionSample& sample,
                             const Happening& h) const {
  const Event& event = case_.events[h.event];
  if (event.trigger == Event::Trigger::angle) {
    return sense_[h.event][h.body] * (angle(sample, h.body) - event.value);
  }
  if (sample.mode(h.body) == HingeMode::released) return -1;
  const NodeReactions reactions =
      node_reactions(case_.bodies[h.body], sample.hinge(h.body));
  const Vector3d& force =
      event.node == Event::Node::lock ? reactions.lock : reactions.hinge;
  return force.norm() / event.value - 1;
}

// Finds happenings due now: by the clock, or because the condition was met
// already when it was armed or when something changed. It does not run whenever
// the motion is looked at: conditions that come true on the way are found by
// the motion, which must not depend on the output times.
void Simulation::find_due() {
  const bool changed = std::exchange(changed_, false);
  for (int e = 0; e < static_cast<int>(case_.events.size()); ++e) {
    const Event& event = case_.events[e];
    for (const int body : event.bodies) {
      const Happening h{e, body};
      if (has_happened(h) || !is_armed(h)) continue;
      const bool timed = event.trigger == Event::Trigger::time ||
                         event.trigger == Event::Trigger::after;
      // A latch catches a body that passes its angle, not one beyond it; bodies
      // that are near already do not come near.
      const auto is_met = [&] {
        if (event.trigger == Event::Trigger::distance) return false;
        return event.action == Event::Action::latch
                   ? is_at_latch(sample(), h) && engages(h)
                   : condition(sample(), h) >= 0;
      };
      if (timed ? due_time(h) <= time() : changed && is_met()) {
        due_.push_back(h);
      }
    }
  }
}

double Simulation::next_time() const {
  double next = History::not_yet;
  for (int e = 0; e < static_cast<int>(case_.events.size()); ++e) {
    for (const int body : case_.events[e].bodies) {
      const Happening h{e, body};
      if (!has_happened(h)) next = std::min(next, due_time(h));
    }
  }
  for (const Force& force : case_.forces) {
    if (!force.law->overrun(force.body, sample().motions())) continue;
    const double begin = history_.time_of(force.begin, force.body, case_);
    if (begin > time()) next = std::min(next, begin);
  }
  return next;
}

// A force that begins now with its stroke used up does not push.
bool Simulation::end_pushes() {
  bool ended = false;
  for (std::size_t f = 0; f < case_.forces.size(); ++f) {
    const Force& force = case_.forces[f];
    if (history_.spent[f] ||
        history_.time_of(force.begin, force.body, case_) != time()) {
      continue;
    }
    const auto overrun = force.law->overrun(force.body, sample().motions());
    if (!overrun || *overrun < 0) continue;
    history_.spent[f] = true;
    ended = true;
  }
  return ended;
}

void Simulation::renew_forces() {
  forces_ = std::make_shared<CaseForces>(case_, history_);
  motion_.set_forces(forces_);
}

// Why the motion failed, and where by the names of body and joint.
std::string Simulation::failure_text() const {
  const multibody::MotionFailure& failure = *motion_.failure();
  if (failure.body < 0) return failure.reason;
  const Body& body = case_.bodies[failure.body];
  std::string place = fmt::format("\"{}\"", body.rigid.name);
  if (failure.joint >= 0) {
    place += fmt::format(", joint \"{}\"",
                         body.hinge.joints[failure.joint].joint.name);
  }
  return fmt::format("{} ({})", failure.reason, place);
}

// In the shortest steps rounding may have a body come to its stop twice.
void Simulation::note_touch(int body, std::size_t stop) {
  const double instant = 1e-12 * (1 + time());
  for (auto it = impacts_.rbegin();
       it != impacts_.rend() && it->time >= time() - instant; ++it) {
    if (it->body == body) return;
  }
  const Hinge& hinge = case_.bodies[body].hinge;
  const auto& parent = sample().motions()[hinge.on];
  const auto& motion = sample().body(body);
  const double rate =
      axis_of(hinge, parent, motion)
          .dot(motion.angular_velocity - parent.angular_velocity);
  history_.touches[body][stop] = std::abs(rate);
  impacts_.push_back({time(), body, false, rate, 0, 0});
  renew_forces();
}

// The motion has stopped at an event of its own.
void Simulation::note_motion_event() {
  const Meaning& meaning = meanings_[motion_.event()];
  if (meaning.body >= 0) {
    note_touch(meaning.body, meaning.stop);
  } else if (meaning.force >= 0) {
    history_.spent[meaning.force] = true;
    end_pushes();
    renew_forces();
  } else {
    add_due(meaning.happening);
  }
}

// Bodies that come near each other do so at one time.
void Simulation::add_due(const Happening& h) {
  if (has_happened(h)) return;
  due_.push_back(h);
  if (h.pair < 0) return;
  const Event& event = case_.events[h.event];
  const WatchedPair& pair = event.pairs[h.pair];
  for (const int body : {pair.a - 1, pair.b - 1}) {
    const Happening other{h.event, body, h.pair};
    if (std::ranges::count(event.bodies, body) > 0 && !is_due(other) &&
        !has_happened(other) && is_armed(other)) {
      due_.push_back(other);
    }
  }
}

Simulation::Stop Simulation::advance_to(double end) {
  due_.clear();
  find_due();
  while (due_.empty() && time() < end) {
    const double spent = forces_->flow().spent_at();
    const auto stop = motion_.advance_to(std::min({end, next_time(), spent}));
    take_impacts();
    if (time() >= spent) {
      message_ = fmt::format(
          "t = {:.6g} s: an engine has burned all of its body: give it a "
          "propellant, or an end before",
          time());
      return Stop::failed;
    }
    switch (stop) {
      case multibody::Stop::failed:
        message_ = failure_text();
        return Stop::failed;
      case multibody::Stop::halted:
        return Stop::halted;
      case multibody::Stop::event:
        note_motion_event();
        break;
      case multibody::Stop::time:
        if (end_pushes()) renew_forces();
        find_due();
    }
  }
  if (due_.empty()) return Stop::time;
  add_latches_here();
  // Together: all bodies of an event when it comes for one.
  const auto own = due_;
  for (const Happening& h : own) {
    const Event& event = case_.events[h.event];
    if (!event.together) continue;
    for (const int body : event.bodies) {
      const Happening too{h.event, body, h.pair};
      if (!has_happened(too) && !is_due(too)) due_.push_back(too);
    }
  }
  // At one instant locks break first, whatever the order in the file.
  std::stable_partition(due_.begin(), due_.end(), [&](const Happening& h) {
    return case_.events[h.event].action == Event::Action::break_lock;
  });
  return Stop::event;
}

// Others that catch their bodies at this instant: one impulse is for all.
void Simulation::add_latches_here() {
  const auto latches = [&](const Happening& h) {
    return case_.events[h.event].action == Event::Action::latch;
  };
  if (std::ranges::none_of(due_, latches)) return;
  for (int e = 0; e < static_cast<int>(case_.events.size()); ++e) {
    const Event& event = case_.events[e];
    if (!latches({e, 0}) || event.trigger != Event::Trigger::angle) continue;
    for (const int body : event.bodies) {
      const Happening h{e, body};
      if (is_due(h) || has_happened(h) || !is_armed(h)) continue;
      constexpr double instant = 1e-11;  // s
      const double rate = sample().hinge(body).relative_angular_velocity.norm();
      const double away = std::abs(angle(body) - event.value);
      if (away <= rate * instant * (1 + time()) && engages(h)) {
        due_.push_back(h);
      }
    }
  }
}

// Adds the changes of an event. A broken hinge or lock does not break again.
bool Simulation::perform(const Happening& h, multibody::MotionChange& breaks) {
  const Event& event = case_.events[h.event];
  const HingeMode mode = sample().mode(h.body);
  if (event.action == Event::Action::latch && !engages(h)) return true;
  history_.events[h.event][h.body] = time();
  switch (event.action) {
    case Event::Action::latch:
      breaks.latched.push_back(h.body);
      return true;
    case Event::Action::break_lock:
      if (mode == HingeMode::locked) breaks.unlocked.push_back(h.body);
      return true;
    case Event::Action::open_latch:
      if (mode == HingeMode::latched) breaks.unlocked.push_back(h.body);
      return true;
    case Event::Action::end_run:
    case Event::Action::none:
      return true;
    case Event::Action::break_hinge:
      break;
  }
  if (mode == HingeMode::locked &&
      std::ranges::find(breaks.unlocked, h.body) == breaks.unlocked.end()) {
    message_ = fmt::format(
        "t = {:.6g} s: event \"{}\": the hinge of \"{}\" breaks while its lock "
        "still holds: break the lock first",
        time(), event.name, case_.bodies[h.body].rigid.name);
    return false;
  }
  breaks.released.push_back(h.body);
  return true;
}

// All at once: forces begin and end with the nodes that break.
bool Simulation::apply() {
  multibody::MotionChange breaks;
  for (const Happening& h : std::exchange(due_, {})) {
    if (!perform(h, breaks)) return false;
  }
  end_pushes();
  forces_ = std::make_shared<CaseForces>(case_, history_);
  breaks.forces = forces_;
  motion_.change(breaks);
  take_impacts();
  if (motion_.failure()) {
    message_ = failure_text();
    return false;
  }
  changed_ = true;
  return true;
}

void Simulation::set_inputs(std::vector<double> values) {
  if (values == history_.inputs) return;
  history_.inputs = std::move(values);
  has_new_inputs_ = true;
}

void Simulation::use_inputs() {
  renew_forces();
  has_new_inputs_ = false;
  // A reaction may be beyond its limit now.
  changed_ = true;
}

SimulationState Simulation::save() {
  // As restore() has it.
  due_.clear();
  changed_ = true;
  return {motion_.save(), history_};
}

void Simulation::restore(const SimulationState& state) {
  history_ = state.history;
  has_new_inputs_ = false;
  due_.clear();
  // A force may have begun just then.
  changed_ = true;
  renew_forces();
  motion_.restore(state.motion);
}

}  // namespace separation
