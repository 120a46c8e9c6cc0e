#include "multibody/motion/hinge_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "multibody/system/eigen_conversion.hpp"

namespace multibody {
namespace {

using Eigen::Vector3d;

// Speed up to which a ball joint slides straight when it begins to slide,
// rad/s: invisible, but far above the uncertainty by tolerances.
constexpr double onset_speed = 3e-5;

double default_stop_speed(const MotionOptions& options) {
  if (options.stop_speed > 0) return options.stop_speed;
  // Below 1e-9 rad/s rounding of the accelerations dominates.
  return options.integrator == Integrator::rk4
             ? 1e-8
             : std::max(100 * options.absolute_tolerance, 1e-9);
}

}  // namespace

HingeChanges::HingeChanges(Equations& equations, MotionSample& view,
                           const MotionOptions& options)
    : equations_(equations),
      view_(view),
      coupled_(equations.coupled),
      impulse_(equations),
      stop_speed_(default_stop_speed(options)),
      stall_changes_(options.stall_changes),
      stall_span_(options.stall_span),
      straight_from_(coupled_.size()),
      settle_times_(coupled_.size()),
      recent_(coupled_.size()) {}

void HingeChanges::change(double time, int body, HingeMode mode) {
  const bool stays = coupled_.hinge(body).rests_on >= 0 &&
                     (mode == HingeMode::sliding || mode == HingeMode::resting);
  if (!stays) settle_times_[body] = 0;
  all_.push_back({time, body, coupled_.mode(body), mode,
                  stays && settle_times_[body] == 0});
  equations_.set_mode(body, mode);
}

// A ball joint rests on its stop whether it turns along it or not. Not while
// its last bounces are summed.
bool HingeChanges::is_on_stop(int body,
                              const std::vector<double>& state) const {
  const Hinge& hinge = coupled_.hinge(body);
  return hinge.is_axis ? hinge.mode == HingeMode::resting &&
                             coupled_.can_push(body, state.data())
                       : hinge.rests_on >= 0 && settle_times_[body] == 0;
}

void HingeChanges::slide_straight(int body, bool straight) {
  const Vector3d rate = view_.rate_of(body);
  straight_from_[body] = rate.norm();
  equations_.memory.hinges[body].direction = rate.normalized();
  coupled_.slide_straight(body, straight);
}

CoupledReport HingeChanges::resolve_rest(double time,
                                         const std::vector<double>& state,
                                         bool due) {
  std::vector<HingeMode> before;
  std::vector<int> stops;
  for (int i = 0; i < coupled_.size(); ++i) {
    before.push_back(coupled_.mode(i));
    stops.push_back(coupled_.hinge(i).rests_on);
  }
  const CoupledReport report = equations_.resolve_rest(time, state.data(), due);
  for (int i = 0; i < coupled_.size(); ++i) {
    const HingeMode mode = coupled_.mode(i);
    const bool stays = stops[i] == coupled_.hinge(i).rests_on;
    if (mode == before[i] && stays) continue;
    if (stops[i] < 0 || !stays) settle_times_[i] = 0;
    all_.push_back({time, i, before[i], mode, is_on_stop(i, state)});
    if (mode == before[i]) continue;
    // After rest the direction of a nearly zero velocity is undefined; until
    // the speed has grown, friction opposes the acceleration.
    if (mode == HingeMode::sliding && !equations_.is_axis(i)) {
      straight_from_[i] = std::max(onset_speed / 2, stop_speed_);
      coupled_.follow_acceleration(i);
    }
  }
  return report;
}

void HingeChanges::stop(int body, std::vector<double>& state) {
  if (equations_.rate_of(body, state.data()).isZero(0)) return;
  const auto jumps =
      impulse_.apply(view_.time(), {{body, Vector3d::Zero()}}, false, state);
  state[equations_.dissipated_at(body)] += jumps.front().loss;
}

// Bodies that rest on their stops.
std::vector<HingeChanges::Bounce> HingeChanges::at_stops(
    const std::vector<double>& state) const {
  std::vector<Bounce> all;
  for (int i = 0; i < coupled_.size(); ++i) {
    const Hinge& hinge = coupled_.hinge(i);
    if (hinge.stops.empty() || hinge.mode == HingeMode::released) continue;
    const double* s = &state[equations_.offset(i)];
    if (!hinge.rests_on_stop(s)) continue;
    all.push_back({hinge.stop_at(s)});
    if (!hinge.is_axis) all.back().along = hinge.cone->turn(s).axis;
  }
  return all;
}

// Adds those that the impulse would drive into their stops: there their rates
// stay 0 by impulses of the stops, which do not pull.
std::vector<Impulse::Target> HingeChanges::with_stops(
    double time, const std::vector<Impulse::Target>& targets,
    const std::vector<double>& state) {
  std::vector<Impulse::Target> all = targets;
  std::vector<Impulse::Target> at_rest;
  for (const Bounce& bounce : at_stops(state)) {
    const int body = bounce.stop->body;
    if (std::ranges::count(targets, body, &Impulse::Target::body) == 0) {
      at_rest.push_back({body, Vector3d::Zero(), bounce.along});
    }
  }
  if (at_rest.empty()) return all;
  const int most = 2 * coupled_.size();
  for (int round = 0; round < most; ++round) {
    std::vector<double> after = state;
    const auto jumps = impulse_.apply(time, all, true, after);
    const std::size_t before = all.size();
    const auto push_of = [&](int body) {
      const int at = equations_.offset(body);
      return coupled_.hinge(body).push_at(&state[at]);
    };
    for (std::size_t t = targets.size(); t < before; ++t) {
      const Vector3d along = all[t].along.value_or(Vector3d::UnitZ());
      if (push_of(all[t].body) * along.dot(jumps[t].impulse) >= 0) continue;
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(t));
      break;
    }
    if (all.size() < before) continue;
    for (const Impulse::Target& target : at_rest) {
      const int body = target.body;
      const double* s = &after[equations_.offset(body)];
      const bool is_in =
          std::ranges::count(all, body, &Impulse::Target::body) > 0;
      const double rate = coupled_.hinge(body).stop_rate(s);
      if (!is_in && push_of(body) * rate < 0) all.push_back(target);
    }
    if (all.size() == before) break;
  }
  return all;
}

// One impulse in several hinges, and its effect on the others.
std::vector<Impulse::Jump> HingeChanges::jump(
    double time, const std::vector<Impulse::Target>& given, bool ideal,
    std::vector<double>& state) {
  const std::vector<double> before = state;
  const auto targets = ideal ? with_stops(time, given, state) : given;
  const auto jumps = impulse_.apply(time, targets, ideal, state);
  for (std::size_t t = 0; t < targets.size(); ++t) {
    equations_.losses[targets[t].body] += jumps[t].loss;
  }
  for (std::size_t t = given.size(); t < targets.size(); ++t) {
    impacts_.push_back(
        {time, targets[t].body, false, 0, jumps[t].impulse.norm(), 0});
  }
  for (int i = 0; i < coupled_.size(); ++i) {
    const HingeMode mode = coupled_.mode(i);
    if (mode != HingeMode::sliding && mode != HingeMode::resting) continue;
    const Vector3d rate = equations_.rate_of(i, state.data());
    if (rate.isZero(0) || rate == equations_.rate_of(i, before.data())) {
      continue;
    }
    const Hinge& hinge = coupled_.hinge(i);
    if (hinge.rests_on >= 0 &&
        hinge.stop_rate(&state[equations_.offset(i)]) != 0) {
      leave_stop(time, i);
    }
    if (mode == HingeMode::resting) {
      change(time, i, HingeMode::sliding);
    } else {
      equations_.set_mode(i, HingeMode::sliding);
    }
    equations_.memory.hinges[i].direction = rate.normalized();
  }
  return jumps;
}

void HingeChanges::note_jumps(double time,
                              const std::vector<Impulse::Target>& targets,
                              const std::vector<Impulse::Jump>& jumps,
                              bool latches, const std::vector<double>& before) {
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const int body = targets[t].body;
    const Vector3d rate = equations_.rate_of(body, before.data());
    const std::optional<Vector3d>& along = targets[t].along;
    const double size = equations_.is_axis(body) ? rate.z() : rate.norm();
    impacts_.push_back({time, body, latches, along ? rate.dot(*along) : size,
                        jumps[t].impulse.norm(), jumps[t].loss});
  }
}

void HingeChanges::latch(double time, const std::vector<int>& bodies,
                         std::vector<double>& state) {
  std::vector<Impulse::Target> moving;
  for (const int body : bodies) {
    if (equations_.rate_of(body, state.data()).isZero(0)) continue;
    moving.push_back({body, Vector3d::Zero()});
  }
  const std::vector<double> before = state;
  note_jumps(time, moving, jump(time, moving, true, state), true, before);
  for (const int body : bodies) change(time, body, HingeMode::latched);
}

const HingeStop* HingeChanges::stop_hit(
    int body, const std::vector<double>& state) const {
  const double* s = &state[equations_.offset(body)];
  const Hinge& hinge = coupled_.hinge(body);
  const HingeStop* hit = nullptr;
  for (const HingeStop& stop : hinge.stops) {
    if (!hit || hinge.gap(stop, s) < hinge.gap(*hit, s)) hit = &stop;
  }
  return hit && hit->side * hinge.stop_rate(s) < 0 ? hit : nullptr;
}

// Puts the body exactly at its stop.
Impulse::Target HingeChanges::rebound(const HingeStop& stop,
                                      std::vector<double>& state) {
  const Hinge& hinge = coupled_.hinge(stop.body);
  double* s = &state[equations_.offset(stop.body)];
  if (hinge.is_axis) {
    s[0] = stop.angle;
    return {stop.body, {0, 0, -stop.restitution * s[1]}};
  }
  hinge.cone->put_on(stop, s);
  const auto [axis, rate, bend] = hinge.cone->turn(s);
  return {stop.body, -stop.restitution * rate * axis, axis};
}

void HingeChanges::rest_on(const HingeStop& stop) {
  const Hinge& hinge = coupled_.hinge(stop.body);
  if (hinge.is_axis) {
    equations_.set_mode(stop.body, HingeMode::resting);
  } else {
    const auto number = static_cast<int>(&stop - hinge.stops.data());
    coupled_.rest_on(stop.body, number, equations_.memory);
  }
}

void HingeChanges::fly_from(const HingeStop& stop) {
  if (coupled_.hinge(stop.body).is_axis) {
    equations_.set_mode(stop.body, HingeMode::sliding);
    equations_.memory.hinges[stop.body].direction =
        stop.side * Vector3d::UnitZ();
  } else {
    coupled_.rest_on(stop.body, -1, equations_.memory);
  }
}

void HingeChanges::hit(double time, const std::vector<int>& bodies,
                       std::vector<double>& state) {
  std::vector<Impulse::Target> targets;
  std::vector<Bounce> bounces;
  for (const int body : bodies) {
    const HingeStop* stop = stop_hit(body, state);
    if (!stop) continue;  // other impacts drove it off, or rounding
    targets.push_back(rebound(*stop, state));
    bounces.push_back({stop, targets.back().along});
  }
  const std::vector<double> before = state;
  const std::vector<Bounce> rested = at_stops(state);
  const auto jumps = jump(time, targets, true, state);
  note_jumps(time, targets, jumps, false, before);
  for (std::size_t t = 0; t < targets.size(); ++t) {
    bounces[t].response = jumps[t].response;
  }
  add_driven_off(time, rested, state, bounces);
  settle(time, bounces, state);
  for (const int body : bodies) hold_slow(time, body, state);
}

// Those that rested and were driven off their stops come back to them in
// bounces of their own, which may be too low to follow.
void HingeChanges::add_driven_off(double time,
                                  const std::vector<Bounce>& rested,
                                  const std::vector<double>& state,
                                  std::vector<Bounce>& to) {
  for (const Bounce& bounce : rested) {
    const int body = bounce.stop->body;
    const double* s = &state[equations_.offset(body)];
    if (!(bounce.stop->side * coupled_.hinge(body).stop_rate(s) > 0)) continue;
    std::vector<double> unused = state;
    const auto jumps = impulse_.apply(
        time, {{body, Vector3d::Zero(), bounce.along}}, true, unused);
    to.push_back({bounce.stop, bounce.along, jumps.front().response});
  }
}

// What is left of the velocity is at the rounding of the impulse, and has no
// direction.
void HingeChanges::hold_slow(double time, int body,
                             std::vector<double>& state) {
  const Hinge& hinge = coupled_.hinge(body);
  if (hinge.rests_on < 0 || !hinge.can_rest ||
      equations_.rate_of(body, state.data()).norm() > stop_speed_) {
    return;
  }
  stop(body, state);
  equations_.set_mode(body, HingeMode::resting);
  all_.push_back({time, body, HingeMode::sliding, HingeMode::resting,
                  is_on_stop(body, state)});
}

// The last bounces, invisibly low and hardly above the rounding of the angle,
// are not computed: the body is held for their duration, the sum of a geometric
// series under the present force.
void HingeChanges::settle(double time, std::vector<Bounce>& bounces,
                          std::vector<double>& state) {
  constexpr double low = 1e-11;  // rad
  const auto still = [&] {
    std::vector<Impulse::Target> targets;
    for (const Bounce& bounce : bounces) {
      targets.push_back({bounce.stop->body, Vector3d::Zero(), bounce.along});
    }
    return targets;
  };
  std::vector<double> held = state;
  impulse_.apply(time, still(), false, held);
  for (Bounce& bounce : bounces) {
    const int body = bounce.stop->body;
    bounce.rate = std::abs(
        coupled_.hinge(body).stop_rate(&state[equations_.offset(body)]));
    rest_on(*bounce.stop);
  }
  view_.show(time, held);
  const bool known = view_.work_out();
  std::vector<const HingeStop*> goes_on;
  std::erase_if(bounces, [&](Bounce& bounce) {
    const HingeStop& stop = *bounce.stop;
    const double moment = view_.hinges().stop_moment(stop.body);
    bounce.pressed = known ? std::max(0.0, moment * bounce.response) : 0;
    const double least = low * std::max(1.0, std::abs(stop.angle));
    // A ball joint that nothing presses on its stop does not rest there.
    const bool may_rest = !bounce.along || bounce.pressed > 0;
    const double square = bounce.rate * bounce.rate;
    if (may_rest && square <= 2 * bounce.pressed * least) return false;
    goes_on.push_back(&stop);
    return true;
  });
  for (const HingeStop* stop : goes_on) fly_from(*stop);
  jump(time, still(), false, state);
  for (const auto& [stop, along, response, rate, pressed] : bounces) {
    const double e = stop->restitution;
    const double lasts = rate > 0 && e < 1 ? 2 * rate / (pressed * (1 - e)) : 0;
    if (time + lasts > time) {
      settle_times_[stop->body] = time + lasts;
    } else {
      end_bounces(time, stop->body);
    }
  }
}

void HingeChanges::end_bounces(double time, int body) {
  settle_times_[body] = 0;
  const HingeMode mode = coupled_.mode(body);
  const HingeMode from = equations_.is_axis(body) ? HingeMode::sliding : mode;
  all_.push_back({time, body, from, mode, true});
}

void HingeChanges::leave_stop(double time, int body) {
  settle_times_[body] = 0;
  coupled_.rest_on(body, -1, equations_.memory);
  all_.push_back({time, body, coupled_.mode(body), coupled_.mode(body)});
}

bool HingeChanges::any_on_cones() const {
  int i = 0;
  while (i < coupled_.size() && !coupled_.hinge(i).slides_on_stop()) ++i;
  return i < coupled_.size();
}

void HingeChanges::put_on_cones(std::vector<double>& state) const {
  for (int i = 0; i < coupled_.size(); ++i) {
    const Hinge& hinge = coupled_.hinge(i);
    if (!hinge.slides_on_stop()) continue;
    double* s = &state[equations_.offset(i)];
    hinge.cone->put_on(hinge.stops[hinge.rests_on], s);
    hinge.cone->stop_rate(s);
  }
}

std::optional<std::string> HingeChanges::stalls(double time, int body) {
  Recent& recent = recent_[body];
  if (!(time - recent.since <= stall_span_)) recent = {time, 0};
  if (++recent.count <= stall_changes_) return {};
  const std::string hinge =
      coupled_.mode(body) == HingeMode::resting
          ? fmt::format("resting, utilisation {}", view_.utilisation(body))
          : fmt::format("sliding at {} rad/s", view_.rate_of(body).norm());
  return fmt::format(
      "at {} s: more than {} changes between rest and slip within {} s, the "
      "hinge is {}",
      time, stall_changes_, stall_span_, hinge);
}

void HingeChanges::restore(int body, double straight_from, double settle_time) {
  recent_[body] = {};
  straight_from_[body] = straight_from;
  settle_times_[body] = settle_time;
}

}  // namespace multibody
