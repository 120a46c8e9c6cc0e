#include "separation/results/record.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "separation/case/hinges/hinge_type.hpp"
#include "separation/clearance/passage.hpp"

namespace separation {
namespace {

using contact::degree;
using Eigen::Vector3d;
using multibody::BodyMotion;
using multibody::HingeKind;
using multibody::HingeMode;
using multibody::HingeSample;
using multibody::MotionSample;

constexpr const char* comes_to_rest = "comes to rest";
constexpr const char* begins_to_slide = "begins to slide";
constexpr const char* hits_stop = "hits its stop";
constexpr const char* rests_on_stop = "rests on its stop";
constexpr const char* leaves_stop = "leaves its stop";

std::string event_text(const Event& event, const Body& body,
                       bool engages = true) {
  const auto text = [&](const std::string& node, const char* what) {
    return fmt::format("{}: {} {}", event.name, node, what);
  };
  switch (event.action) {
    case Event::Action::break_lock:
      return text(body.lock->name, "breaks");
    case Event::Action::break_hinge:
      return text(body.hinge.name, "breaks");
    case Event::Action::open_latch:
      return text("latch of " + body.hinge.name, "opens");
    case Event::Action::end_run:
      return event.name + ": the run ends";
    case Event::Action::none:
      return event.name + ": occurs";
    case Event::Action::latch:
      break;
  }
  return text(body.hinge.name, engages ? "latches" : "does not engage");
}

std::string empty_text(const Force& force) {
  return force.name + ": propellant is used up";
}

// Distances of bodies of some metres are exact to 1e-8 m (nearest.hpp):
// differences below this say nothing.
constexpr double negligible = 1e-8;

// How a joint's contact lies in a seat that ends; none of others.
std::optional<contact::RimContact> rims_of(const Body& body,
                                           const HingeSample& hinge,
                                           std::size_t joint) {
  if (joint >= hinge.joints.size()) return {};
  return body.hinge.joints[joint].model.rims(hinge.joints[joint]);
}

}  // namespace

std::vector<std::string> history_columns(const Case& c, bool clearance) {
  std::vector<std::string> columns = {"time_s"};
  const auto add = [&](const std::string& body,
                       std::initializer_list<const char*> names) {
    for (const char* name : names) columns.push_back(body + '.' + name);
  };
  for (std::size_t i = 0; i <= c.bodies.size(); ++i) {
    const std::string body =
        column_name(c.rigid_body(static_cast<int>(i)).name);
    if (i > 0 && c.bodies[i - 1].hinge.kind != HingeKind::none) {
      add(body,
          {"mode", "angle_deg", "rate_deg_per_s", "acceleration_deg_per_s2",
           "reaction_N", "lock_reaction_N", "friction_moment_N_m",
           "utilisation", "theta0_deg", "peak_pressure_Pa", "friction_work_J"});
      add(body,
          {"reaction_x_N", "reaction_y_N", "reaction_z_N", "lock_reaction_x_N",
           "lock_reaction_y_N", "lock_reaction_z_N", "friction_moment_x_N_m",
           "friction_moment_y_N_m", "friction_moment_z_N_m"});
      if (!c.bodies[i - 1].hinge.stops.empty()) {
        add(body, {"stop_moment_N_m", "stop_impulses_N_m_s"});
      }
      if (c.has_latch(static_cast<int>(i) - 1)) {
        add(body, {"latch_moment_N_m"});
      }
    }
    add(body,
        {"x_m", "y_m", "z_m", "vx_m_per_s", "vy_m_per_s", "vz_m_per_s", "qw",
         "qx", "qy", "qz", "wx_rad_per_s", "wy_rad_per_s", "wz_rad_per_s"});
    if (c.flows(static_cast<int>(i))) add(body, {"mass_kg"});
  }
  if (clearance) {
    for (const Case::Pair& pair : c.clearance) {
      columns.push_back(clearance_column(c, pair) + "_m");
    }
  }
  for (const char* name :
       {"kinetic_J", "gravity_J", "active_work_J", "dissipated_J"}) {
    columns.push_back(std::string("energy.") + name);
  }
  if (c.has_impacts()) columns.push_back("energy.impacts_J");
  if (stores_energy(c)) columns.push_back("energy.springs_J");
  columns.push_back("energy.balance_J");
  return columns;
}

Clearance clearance_of(const Case& c) { return clearance_of(c, c.clearance); }

namespace {

// Rate of the angle: on an axis with its sign. After the release the rate by
// the bodies' relative angular velocity.
double rate_of(const Hinge& hinge, const MotionSample& sample, int body) {
  const auto turn = hinge_type(hinge).turn;
  const BodyMotion& parent = sample.motions()[hinge.on];
  if (sample.mode(body) == HingeMode::released) {
    return turn(hinge, parent.rotation,
                sample.body(body).angular_velocity - parent.angular_velocity);
  }
  const HingeSample now = sample.hinge(body);
  return std::isnan(now.angle_rate)
             ? turn(hinge, parent.rotation, now.relative_angular_velocity)
             : now.angle_rate;
}

bool is_held(HingeMode mode) {
  return is_fixed(mode) || mode == HingeMode::resting;
}

// Its derivative.
double acceleration_of(const Simulation& simulation, int body) {
  const Hinge& hinge = simulation.of().bodies[body].hinge;
  const auto& sample = simulation.sample();
  if (is_held(sample.mode(body))) return 0;  // but for rounding
  const BodyMotion& parent = sample.motions()[hinge.on];
  const BodyMotion& motion = sample.body(body);
  const Vector3d relative =
      sample.angular_acceleration(1 + body) -
      sample.angular_acceleration(hinge.on) -
      parent.angular_velocity.cross(motion.angular_velocity);
  return hinge_type(hinge).turn(hinge, parent.rotation, relative);
}

// The time of a constant value is its first time, regardless of rounding.
void raise(double& peak, double& peak_time, double value, double time) {
  constexpr double same = 1e-13;
  if (!(value > (1 + same) * peak)) return;
  peak = value;
  peak_time = time;
}

}  // namespace

std::size_t Rows::column(const std::string& name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) {
    throw contact::Error(
        contact::detail::unknown("column", contact::detail::printable(name),
                                 contact::detail::nearest(name, columns), {}));
  }
  return static_cast<std::size_t>(found - columns.begin());
}

bool can_be_noted(const Note& note, const Case& c) {
  if (std::ranges::any_of(c.forces, [&](const Force& force) {
        return force.burns && note.body == c.rigid_body(force.body).name &&
               note.what == empty_text(force);
      })) {
    return true;
  }
  const auto body = std::ranges::find(
      c.bodies, note.body, [](const Body& b) { return b.rigid.name; });
  if (body == c.bodies.end()) return false;
  if (note.what == comes_to_rest || note.what == begins_to_slide) return true;
  if (!body->hinge.stops.empty() &&
      (note.what == hits_stop || note.what == rests_on_stop ||
       note.what == leaves_stop)) {
    return true;
  }
  const auto index = static_cast<int>(body - c.bodies.begin());
  return std::ranges::any_of(c.events, [&](const Event& event) {
    return std::ranges::count(event.bodies, index) > 0 &&
           (note.what == event_text(event, *body) ||
            note.what == event_text(event, *body, false));
  });
}

Recorder::Recorder(const Case& c, bool rows, bool clearance, bool refine)
    : case_(c), keep_rows_(rows), refine_(refine) {
  if (clearance && !c.clearance.empty()) clearance_ = clearance_of(c);
  memory_.rows.columns = history_columns(c, clearance);
  for (const Body& body : c.bodies) {
    memory_.bodies.emplace_back();
    memory_.bodies.back().joints.resize(body.hinge.joints.size());
  }
  memory_.pairs.resize(c.clearance.size());
  for (std::size_t i = 0; clearance_ && i < c.clearance.size(); ++i) {
    ways_.emplace_back(clearance_->pairs()[i],
                       reach(c.rigid_body(c.clearance[i].b).shapes));
  }
  memory_.forces.resize(c.forces.size());
  memory_.tip_offs.resize(c.tip_offs.size());
}

void Recorder::go_on_with(const Simulation& simulation) {
  changes_seen_ = simulation.motion().changes().size();
  impacts_seen_ = simulation.impacts().size();
  looks_.clear();
  fault_.clear();
  for (PairWay& way : ways_) way.forget();
}

void Recorder::add_motion(const Simulation& simulation, int number) {
  const BodyMotion& body = simulation.sample().motions()[number];
  const Vector3d w = body.rotation.transpose() * body.angular_velocity;
  const Eigen::Quaterniond q(body.rotation);
  for (const double x : body.position) add(x);
  for (const double v : body.velocity) add(v);
  for (const double x : {q.w(), q.x(), q.y(), q.z()}) add(x);
  for (const double x : w) add(x);
  if (case_.flows(number)) {
    add(simulation.flow().of(number, simulation.time()).mass);
  }
}

void Recorder::look_at_peaks(const Simulation& simulation,
                             const MotionSample& sample, int i) {
  const Body& body = case_.bodies[i];
  BodyRecord& record = memory_.bodies[i];
  const double time = sample.time();
  if (body.hinge.kind == HingeKind::none) return;
  const HingeSample hinge = sample.hinge(i);
  const NodeReactions reactions = node_reactions(body, hinge);
  const double force = reactions.hinge.norm();
  const double lock = reactions.lock.norm();
  raise(record.peak_reaction, record.peak_reaction_time, force, time);
  raise(record.peak_lock, record.peak_lock_time, lock, time);
  seen_.insert(seen_.end(), {force, lock});
  if (!body.hinge.stops.empty()) {
    const double moment = simulation.stop_moment(sample, hinge, i);
    raise(record.peak_stop, record.peak_stop_time, moment, time);
    seen_.push_back(moment);
  }
  if (case_.has_latch(i)) {
    const double moment = simulation.latch_moment(hinge, i);
    raise(record.peak_latch, record.peak_latch_time, moment, time);
    seen_.push_back(moment);
  }
  record.work = std::max(record.work, hinge.dissipated);
  for (std::size_t j = 0; j < record.joints.size(); ++j) {
    if (j >= hinge.joints.size()) {
      seen_.insert(seen_.end(), {0, 0, 0, 0});
      continue;
    }
    const contact::JointSolution& joint = hinge.joints[j];
    JointPeaks& peaks = record.joints[j];
    const double reaction = joint.reaction.norm();
    // At rest the solution belongs to the impending slip.
    const double moment =
        hinge.mode == HingeMode::sliding ? joint.friction_moment.norm() : 0;
    raise(peaks.reaction, peaks.reaction_time, reaction, time);
    peaks.pressure = std::max(peaks.pressure, joint.peak_pressure);
    peaks.half_angle = std::max(peaks.half_angle, joint.half_angle);
    peaks.moment = std::max(peaks.moment, moment);
    if (const auto contact = rims_of(body, hinge, j)) {
      peaks.lower_gap = std::min(peaks.lower_gap, contact->rims[0].gap);
      peaks.upper_gap = std::min(peaks.upper_gap, contact->rims[1].gap);
      if (std::isnan(contact->peak_pressure)) {
        peaks.hidden = std::max(peaks.hidden, contact->mean_pressure());
      }
    }
    seen_.insert(seen_.end(),
                 {reaction, joint.peak_pressure, joint.half_angle, moment});
  }
}

// In the order of seen_.
std::vector<double> Recorder::known_peaks() const {
  std::vector<double> known;
  for (std::size_t i = 0; i < case_.bodies.size(); ++i) {
    if (case_.bodies[i].hinge.kind == HingeKind::none) continue;
    const BodyRecord& record = memory_.bodies[i];
    known.insert(known.end(), {record.peak_reaction, record.peak_lock});
    if (!case_.bodies[i].hinge.stops.empty()) known.push_back(record.peak_stop);
    if (case_.has_latch(static_cast<int>(i))) {
      known.push_back(record.peak_latch);
    }
    for (const JointPeaks& peaks : record.joints) {
      known.insert(known.end(), {peaks.reaction, peaks.pressure,
                                 peaks.half_angle, peaks.moment});
    }
  }
  return known;
}

// The peaks at an earlier time of the step.
Look Recorder::look_back(const Simulation& simulation, double time) {
  seen_.clear();
  simulation.motion().look_back(time, [&](const MotionSample& sample) {
    for (int i = 0; i < static_cast<int>(case_.bodies.size()); ++i) {
      look_at_peaks(simulation, sample, i);
    }
  });
  return {time, seen_};
}

// Between this look and the last one. Where that is before the step something
// has changed at its beginning.
void Recorder::refine_peaks(const Simulation& simulation) {
  const Look now{simulation.sample().time(), seen_};
  constexpr double instant = 1e-12;
  if (!looks_.empty() &&
      (looks_.back().time < simulation.motion().step_begin() ||
       now.time - looks_.back().time <= instant * (1 + std::abs(now.time)))) {
    looks_.clear();
  }
  if (!looks_.empty()) refine_between(simulation, looks_.back(), now);
  if (looks_.size() == 2) looks_.erase(looks_.begin());
  looks_.push_back(now);
}

void Recorder::refine_between(const Simulation& simulation, const Look& from,
                              const Look& to) {
  if (looks_.size() == 2 &&
      !may_peak(looks_.front(), from, to, from.time, known_peaks())) {
    return;
  }
  constexpr int middle = peak_nodes / 2;
  std::array<Look, peak_nodes> looks;
  looks.front() = from;
  looks.back() = to;
  const auto look = [&](int k) {
    looks[k] = look_back(simulation, peak_node(k, from.time, to.time));
  };
  look(middle);
  if (!may_peak(from, looks[middle], to, from.time, known_peaks())) return;
  for (int k = 1; k + 1 < peak_nodes; ++k) {
    if (k != middle) look(k);
  }
  for (const double time : peak_times(looks, known_peaks())) {
    look_back(simulation, time);
  }
}

// Columns of a body's hinge.
void Recorder::add_hinge(const Simulation& simulation, int i) {
  const Body& body = case_.bodies[i];
  if (body.hinge.kind == HingeKind::none) return;
  const HingeSample hinge = simulation.sample().hinge(i);
  const NodeReactions reactions = node_reactions(body, hinge);
  double half_angle = NAN;
  double pressure = NAN;
  for (const contact::JointSolution& joint : hinge.joints) {
    half_angle = std::fmax(half_angle, joint.half_angle);
    pressure = std::fmax(pressure, joint.peak_pressure);
  }
  add(static_cast<double>(hinge.mode));
  add(simulation.angle(i) / degree);
  add(rate_of(body.hinge, simulation.sample(), i) / degree);
  add(acceleration_of(simulation, i) / degree);
  add(reactions.hinge.norm());
  add(reactions.lock.norm());
  add(hinge.friction_moment.norm());
  add(hinge.utilisation);
  add(half_angle / degree);
  add(pressure);
  add(hinge.dissipated);
  const Eigen::Matrix3d& to_inertial = simulation.sample().body(i).rotation;
  for (const Vector3d& v :
       {reactions.hinge, reactions.lock, hinge.friction_moment}) {
    for (const double x : Vector3d(to_inertial * v)) add(x + 0.0);  // no -0
  }
  if (!body.hinge.stops.empty()) {
    add(simulation.stop_moment(simulation.sample(), hinge, i));
    add(memory_.bodies[i].stop_impulses);
  }
  if (case_.has_latch(i)) {
    add(simulation.latch_moment(hinge, i));
  }
}

// Does not record a rest of zero duration, as where a body reverses.
void Recorder::note_change(const multibody::HingeChange& change,
                           bool was_on_stop) {
  const std::string& body = case_.bodies[change.body].rigid.name;
  const bool rests = change.to == HingeMode::resting;
  const auto same =
      std::find_if(memory_.notes.rbegin(), memory_.notes.rend(),
                   [&](const Note& note) { return note.body == body; });
  if (!rests && same != memory_.notes.rend() && same->time == change.time &&
      same->what == comes_to_rest) {
    memory_.notes.erase(std::next(same).base());
    return;
  }
  const char* what = rests ? comes_to_rest : begins_to_slide;
  if (change.on_stop && !was_on_stop) what = rests_on_stop;
  // Whatever else: friction may hold a ball joint at the stop, or beside it.
  if (was_on_stop && !change.on_stop) what = leaves_stop;
  memory_.notes.push_back({change.time, body, what});
}

// A latch has its note already, by before().
void Recorder::note_impact(const multibody::HingeImpact& impact) {
  const auto& [time, body, latches, rate, impulse, loss] = impact;
  const std::string& name = case_.bodies[body].rigid.name;
  BodyRecord& record = memory_.bodies[body];
  if (latches) {
    record.latch_impulse = std::max(record.latch_impulse, impulse);
    record.latch_loss += loss;
    const auto note = std::ranges::find_if(
        memory_.notes.rbegin(), memory_.notes.rend(), [&](const Note& n) {
          return n.body == name && n.what.ends_with("latches");
        });
    if (note == memory_.notes.rend()) return;
    note->rate = rate;
    note->impulse = impulse;
    note->loss = loss;
    return;
  }
  // Of a body that rests on its stop while another one hits.
  const bool is_hit = rate != 0;
  record.impacts += is_hit ? 1 : 0;
  record.stop_impulses += impulse;
  record.largest_impulse = std::max(record.largest_impulse, impulse);
  record.stop_loss += loss;
  if (is_hit) {
    memory_.notes.push_back({time, name, hits_stop, rate, impulse, loss});
  }
}

// At an event that comes for a body, the first one of those about others; of
// the event -1 every time.
void Recorder::look_at_tip_offs(const Simulation& simulation,
                                const Happening& h) {
  for (std::size_t i = 0; i < memory_.tip_offs.size(); ++i) {
    const auto& [number, event, direction] = case_.tip_offs[i];
    TipOffRecord& record = memory_.tip_offs[i];
    if (event != h.event) continue;
    if (event >= 0 &&
        (record.time != History::not_yet ||
         (number != 1 + h.body &&
          std::ranges::count(case_.events[event].bodies, number - 1) > 0))) {
      continue;
    }
    const BodyMotion& body = simulation.sample().motions()[number];
    const Eigen::AngleAxisd turn(body.rotation);
    record.time = simulation.time();
    record.rates = body.rotation.transpose() * body.angular_velocity;
    record.velocity = body.velocity;
    record.attitude = turn.angle() * turn.axis();
    if (direction) record.across = record.rates.cross(*direction).norm();
    if (case_.flows(number)) {
      record.mass = simulation.flow().of(number, record.time).mass;
    }
  }
}

// Engines that have used up their propellant since the last look.
void Recorder::note_empty(const Simulation& simulation) {
  for (int f = 0; f < static_cast<int>(case_.forces.size()); ++f) {
    const Force& force = case_.forces[f];
    if (!force.burns) continue;
    const double time = simulation.flow().empty_at(f);
    if (!(memory_.last_time < time && time <= simulation.time())) continue;
    const auto later =
        std::ranges::upper_bound(memory_.notes, time, {}, &Note::time);
    memory_.notes.insert(
        later, {time, case_.rigid_body(force.body).name, empty_text(force)});
  }
}

// Sticking and sliding, with the time at rest and at rims.
void Recorder::look_at_changes(const Simulation& simulation) {
  const double time = simulation.time();
  const auto& changes = simulation.motion().changes();
  const auto resting = static_cast<int>(HingeMode::resting);
  if (!memory_.begun) {
    memory_.begun = true;
    memory_.last_time = time;
    memory_.modes.clear();
    for (std::size_t i = 0; i < case_.bodies.size(); ++i) {
      memory_.modes.push_back(
          static_cast<int>(simulation.sample().mode(static_cast<int>(i))));
      memory_.bodies[i].on_stop = static_cast<int>(
          simulation.sample().rests_on_stop(static_cast<int>(i)));
    }
    changes_seen_ = changes.size();
    impacts_seen_ = simulation.impacts().size();
    return;
  }
  std::vector<double> since(case_.bodies.size(), memory_.last_time);
  const auto add_rest = [&](std::size_t body, double until) {
    BodyRecord& record = memory_.bodies[body];
    if (memory_.modes[body] == resting) {
      record.rest_time += until - since[body];
    }
    if (record.on_stop != 0) record.rest_on_stop += until - since[body];
  };
  const auto& impacts = simulation.impacts();
  const auto note_impacts = [&](double until) {
    for (; impacts_seen_ < impacts.size(); ++impacts_seen_) {
      if (impacts[impacts_seen_].time > until) return;
      note_impact(impacts[impacts_seen_]);
    }
  };
  for (; changes_seen_ < changes.size(); ++changes_seen_) {
    const auto& change = changes[changes_seen_];
    note_impacts(change.time);
    add_rest(change.body, change.time);
    since[change.body] = change.time;
    memory_.modes[change.body] = static_cast<int>(change.to);
    const bool was_on_stop =
        std::exchange(memory_.bodies[change.body].on_stop,
                      static_cast<int>(change.on_stop)) != 0;
    // Breaks and latches are noted under the event's name.
    if (change.to == HingeMode::released || is_fixed(change.to) ||
        is_fixed(change.from)) {
      continue;
    }
    note_change(change, was_on_stop);
  }
  note_impacts(time);
  note_empty(simulation);
  for (std::size_t i = 0; i < case_.bodies.size(); ++i) {
    add_rest(i, time);
    const Body& body = case_.bodies[i];
    if (body.hinge.joints.empty() || body.hinge.joints[0].model.is_endless()) {
      continue;
    }
    const auto contact =
        rims_of(body, simulation.sample().hinge(static_cast<int>(i)), 0);
    if (!contact || contact->gap() > 0) continue;
    memory_.bodies[i].joints[0].rim_time += time - memory_.last_time;
  }
  memory_.last_time = time;
}

void Recorder::note_distance(std::size_t i, double distance, double time) {
  PairRecord& pair = memory_.pairs[i];
  // A touch has its time from the search, which comes after the look.
  if (distance < pair.smallest || (distance <= 0 && time < pair.time)) {
    pair.smallest = distance;
    pair.time = time;
  }
  if (std::isnan(distance) && fault_.empty()) {
    const int a = case_.clearance[i].a;
    const int b = case_.clearance[i].b;
    fault_ = fmt::format(
        "t = {:.6g} s: the distance of {} and {} could not be certified", time,
        case_.rigid_body(a).name, case_.rigid_body(b).name);
  }
  if (distance <= 0) {
    pair.overlap_from = std::min(pair.overlap_from, time);
    pair.overlap_to = std::max(pair.overlap_to, time);
  }
}

// Without rows distances are computed only where one may be smaller than known,
// or an overlap may go on.
void Recorder::look_at_distances(const Simulation& simulation, bool keep) {
  const MotionSample& sample = simulation.sample();
  const double time = sample.time();
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    PairWay& way = ways_[i];
    if (!simulation.history().is_on(case_.clearance[i], time, case_)) {
      way.forget();
      if (keep) add(NAN);
      continue;
    }
    way.move_on(time, sample.motions());
    const double known = memory_.pairs[i].smallest;
    const double least = std::min(way.least_now(), way.least_since());
    if (!keep && least > 0 && least > known - negligible) continue;
    const double distance = clearance_->distance(i, sample.motions());
    way.know(distance);
    const PairRecord& pair = memory_.pairs[i];
    const bool overlapped =
        pair.overlap_from <= way.since() && pair.overlap_to == way.since();
    const bool changes = overlapped != (distance <= 0);
    note_distance(i, distance, time);
    if (keep) add(distance);
    const bool may_be_smaller = way.least_since() < pair.smallest - negligible;
    if (refine_ && (changes || may_be_smaller) && way.since() < time &&
        simulation.history().is_on(case_.clearance[i], way.since(), case_) &&
        way.since() >= simulation.motion().step_begin()) {
      search_distance(simulation, i);
    }
  }
}

// The smallest distance of a pair between the last look and this one, for each
// of its solids with each.
void Recorder::search_distance(const Simulation& simulation, std::size_t i) {
  const int a = clearance_->pairs()[i].a;
  const int b = clearance_->pairs()[i].b;
  const multibody::Motion& motion = simulation.motion();
  const MotionSample& sample = simulation.sample();
  for (std::size_t solids = 0; solids < clearance_->solid_pairs(i); ++solids) {
    // Passages take some hundred looks; a distance that stays the same as
    // bodies turn would take as many as its way has parts of `accuracy`.
    constexpr int many = 300;
    double accuracy = negligible;
    int looks = 0;
    const auto look = [&](double time) {
      if (++looks > many) accuracy *= 1.1;
      const auto seen =
          clearance_->look(i, solids, time, motion.place_back(a, time),
                           motion.place_back(b, time));
      note_distance(i, seen.distance, time);
      return seen;
    };
    const auto now = clearance_->look(i, solids, sample.time(),
                                      sample.motions()[a], sample.motions()[b]);
    search_passage(look, look(ways_[i].since()), now, memory_.pairs[i].smallest,
                   accuracy);
  }
}

void Recorder::look_at_energy(const Simulation& simulation, bool first) {
  const multibody::EnergyBook book = simulation.sample().energy();
  if (first) memory_.first_balance = book.balance();
  const double drift = std::abs(book.balance() - memory_.first_balance);
  memory_.largest_drift = std::max(memory_.largest_drift, drift);
  for (const double e : {book.kinetic, book.gravity, book.active_work,
                         book.dissipated, book.impacts}) {
    memory_.largest_energy = std::max(memory_.largest_energy, std::abs(e));
  }
  if (!keep_rows_) return;
  for (const double e :
       {book.kinetic, book.gravity, book.active_work, book.dissipated}) {
    add(e);
  }
  if (case_.has_impacts()) add(book.impacts);
  if (stores_energy(case_)) add(simulation.stored_energy());
  add(book.balance());
}

void Recorder::look(const Simulation& simulation) {
  const bool first = !memory_.begun;
  seen_.clear();
  look_at_changes(simulation);
  const auto& sample = simulation.sample();
  if (keep_rows_) {
    add(sample.time());
    add_motion(simulation, 0);
  }
  for (int i = 0; i < static_cast<int>(case_.bodies.size()); ++i) {
    look_at_peaks(simulation, sample, i);
    if (!keep_rows_) continue;
    add_hinge(simulation, i);
    add_motion(simulation, 1 + i);
  }
  look_at_distances(simulation, keep_rows_);
  look_at_forces(simulation, memory_.forces);
  look_at_energy(simulation, first);
  look_at_tip_offs(simulation, {-1, -1});
  if (refine_) refine_peaks(simulation);
}

void Recorder::look_between(const Simulation& simulation) {
  const auto& sample = simulation.sample();
  seen_.clear();
  for (int i = 0; i < static_cast<int>(case_.bodies.size()); ++i) {
    look_at_peaks(simulation, sample, i);
  }
  look_at_distances(simulation, false);
  look_at_forces(simulation, memory_.forces);
  if (refine_) refine_peaks(simulation);
}

// Whether happenings[i] changes anything: what is broken already, also by those
// before it, does not break again, and a locked hinge does not break.
bool Recorder::breaks(const Simulation& simulation,
                      const std::vector<Happening>& happenings,
                      std::size_t i) const {
  const Happening& h = happenings[i];
  const auto broken = [&](Event::Action action) {
    return std::any_of(happenings.begin(), happenings.begin() + i,
                       [&](const Happening& other) {
                         return other.body == h.body &&
                                case_.events[other.event].action == action;
                       });
  };
  const Event::Action action = case_.events[h.event].action;
  if (action >= Event::Action::end_run) return true;
  if (broken(action)) return false;
  const HingeMode mode = simulation.sample().mode(h.body);
  const bool locked = mode == HingeMode::locked;
  if (action == Event::Action::open_latch) return mode == HingeMode::latched;
  if (action == Event::Action::latch) {
    return mode != HingeMode::released && !is_fixed(mode);
  }
  if (action == Event::Action::break_lock) return locked;
  return mode != HingeMode::released &&
         (!locked || broken(Event::Action::break_lock));
}

void Recorder::before(const Simulation& simulation,
                      const std::vector<Happening>& happenings) {
  looks_.clear();
  const auto& sample = simulation.sample();
  for (std::size_t i = 0; i < happenings.size(); ++i) {
    const Happening& h = happenings[i];
    const Event& event = case_.events[h.event];
    // A latch that does not engage may do so later.
    if (event.action != Event::Action::latch || simulation.engages(h)) {
      look_at_tip_offs(simulation, h);
    }
    if (!breaks(simulation, happenings, i)) continue;
    const Body& body = case_.bodies[h.body];
    const bool hinge = event.action == Event::Action::break_hinge;
    const bool fails =
        event.action == Event::Action::latch && !simulation.engages(h);
    memory_.notes.push_back({simulation.time(), body.rigid.name,
                             event_text(event, body, !fails),
                             fails ? rate_of(body.hinge, sample, h.body) : 0});
    memory_.notes.back().approach = simulation.approach(h);
    BodyRecord::Release& release = memory_.bodies[h.body].release;
    if (!hinge || release.time != History::not_yet) continue;
    const HingeSample now = sample.hinge(h.body);
    const BodyMotion& parent = sample.motions()[body.hinge.on];
    release = {simulation.time(), simulation.angle(h.body),
               rate_of(body.hinge, sample, h.body),
               now.relative_angular_velocity,
               parent.rotation.transpose() *
                   (sample.body(h.body).velocity - parent.velocity)};
  }
}

}  // namespace separation
