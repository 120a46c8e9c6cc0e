#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "libcontact/base/root_finding.hpp"
#include "multibody/motion/motion_impl.hpp"

namespace multibody {

using Kind = MotionImpl::Watch::Kind;

double MotionImpl::value(const Watch& watch) {
  const int i = watch.index;
  switch (watch.kind) {
    case Kind::slip_ends:
      return rate_of(i, view_state.data()).dot(slip_directions[i]);
    case Kind::slows_down:
      return rate_of(i, view_state.data()).norm() - stop_speed;
    case Kind::speeds_up:
      return rate_of(i, view_state.data()).norm() - 2 * straight_from[i];
    case Kind::slip_turns:
      return rate_of(i, view_state.data())
          .dot(rate_of(i, stepper->begin_state().data()));
    case Kind::rest_ends: {
      if (!work_out()) return std::numeric_limits<double>::quiet_NaN();
      // Without any reaction tau is infinite.
      constexpr double most = 1e6;
      return std::min(coupled.utilisation(i), most) - coupled.slip_limit(i);
    }
    case Kind::user:
      return events[i].function(sample);
  }
  return 0;
}

double MotionImpl::value_at(const Watch& watch, double time) {
  stepper->interpolate(time, trial_);
  look_at(time, trial_);
  return value(watch);
}

// The highest value within a step that is negative at both ends, and its time;
// only as far as it may be of interest.
std::pair<double, double> MotionImpl::peak_between(const Watch& watch,
                                                   double low, double low_value,
                                                   double high,
                                                   double high_value) {
  const double middle = low + (high - low) / 2;
  const double value = value_at(watch, middle);
  if (value > 0) return {middle, value};
  // The parabola through the three: does it have a peak inside, that comes
  // near 0? Steps follow what hinges hold, so that it is not far from it.
  constexpr double near = 0.1;
  const double bend = 2 * value - low_value - high_value;
  const double slope = high_value - low_value;
  const bool inside = bend > 0 && std::abs(slope) < 2 * bend;
  if (!inside || value + slope * slope / (8 * bend) < -near) {
    return {middle, value};
  }
  constexpr int bits = 20;  // of time: values there differ by 1e-12 from it
  std::uintmax_t steps = 40;
  const auto [time, below] = boost::math::tools::brent_find_minima(
      [&](double t) { return -value_at(watch, t); }, low, high, bits, steps);
  return {time, -below};
}

double MotionImpl::locate(const Watch& watch, double low, double low_value,
                          double high, double high_value) {
  if (low_value == 0) return low;
  if (high_value == 0) return high;
  const auto at = [&](double time) { return value_at(watch, time); };
  // To the rounding of time; the far side, where it has happened. (Where a
  // trial state has no forces its value is NaN.)
  return contact::shrink_bracket(at, low, high, low_value, high_value, 50).high;
}

// Fixed steps do not get shorter towards a stop: it comes where one implicit
// step would end the motion.
bool MotionImpl::stops_in_step(int body) {
  const double h = stepper->end() - stepper->begin();
  look_at(stepper->begin(), stepper->begin_state());
  if (!work_out()) return false;
  const Eigen::Vector3d rate = rate_of(body, view_state.data());
  const Eigen::Vector3d alpha = relative_acceleration(body);
  // What follows is some work.
  constexpr double near = 10;
  return rate.norm() < near * h * alpha.norm() &&
         coupled.stops_within(body, rate, h);
}

// Where a resting hinge holds no longer, or has a contact without a value,
// whose tau is NaN: resolve_rest() tells the two apart.
std::optional<double> MotionImpl::rest_end(const Watch& watch, double end) {
  const double t0 = stepper->begin();
  look_at(t0, stepper->begin_state());
  const double begin = value(watch);
  if (!(begin <= 0)) return t0;
  double last = stepper->end();
  // Of a joint without body tau jumps from 0 to infinity where a moment begins
  // to grow: that is known to the shortest step that can be made, which has
  // some roundings of time.
  const double soon = std::max(1e-10 * (last - t0), 1e-14 * std::abs(t0));
  const auto passed = [&](double time, double at_time) {
    return std::max(t0 + soon, locate(watch, t0, begin, time, at_time));
  };
  double last_value = end;
  std::optional<double> lost;
  for (;;) {
    if (std::isnan(last_value)) {
      // Not to the rounding of time: so far on that it is NaN again when the
      // step is made to end there.
      constexpr int bits = 25;
      double known = t0;
      lost = last;
      for (int i = 0; i < bits; ++i) {
        const double middle = known + (*lost - known) / 2;
        (std::isnan(value_at(watch, middle)) ? *lost : known) = middle;
      }
      last = known;
      last_value = value_at(watch, known);
    }
    if (last_value > 0) return passed(last, last_value);
    const auto peak = peak_between(watch, t0, begin, last, last_value);
    if (peak.second > 0) return passed(peak.first, peak.second);
    if (!std::isnan(peak.second)) return lost;
    std::tie(last, last_value) = peak;
  }
}

std::optional<double> MotionImpl::crossing(const Watch& watch) {
  const double t0 = stepper->begin();
  const double t1 = stepper->end();
  const auto at_begin = [&] {
    look_at(t0, stepper->begin_state());
    return value(watch);
  };
  const auto at_end = [&] {
    look_at(t1, stepper->end_state());
    return value(watch);
  };
  const double end = at_end();
  switch (watch.kind) {
    case Kind::slows_down: {
      if (options.integrator == Integrator::rk4 && stops_in_step(watch.index)) {
        return t0;
      }
      if (!(end <= 0)) return {};
      const double begin = at_begin();
      if (begin > 0) return locate(watch, t0, begin, t1, end);
      // So slow all along: it counts when it does not become faster.
      return end <= begin ? std::optional(t1) : std::nullopt;
    }
    case Kind::speeds_up: {
      if (!(end > 0)) return {};
      const double begin = at_begin();
      return begin > 0 ? t0 : locate(watch, t0, begin, t1, end);
    }
    case Kind::slip_turns: {
      if (!(end < 0)) return {};
      const double time = locate(watch, t0, at_begin(), t1, end);
      const double before =
          rate_of(watch.index, stepper->begin_state().data()).norm();
      const double then = rate_of(watch.index, view_state.data()).norm();
      // It may turn about without coming to a stop.
      constexpr double stopped = 0.1;
      return then <= stopped * before ? std::optional(time) : std::nullopt;
    }
    case Kind::rest_ends:
      return rest_end(watch, end);
    case Kind::slip_ends:
    case Kind::user:
      break;  // motion_crossings.cpp
  }
  return {};
}

std::optional<MotionImpl::Found> MotionImpl::find_event() {
  trial_.resize(number_count());
  sample_step();
  std::optional<Found> first;
  const auto add = [&](const Found& found) {
    if (!first || found.time < first->time) first = found;
  };
  const auto look_for = [&](Kind kind, int index) {
    const Watch watch{kind, index};
    if (const auto time = crossing(watch)) add({*time, watch});
  };
  for (int i = 0; i < size(); ++i) {
    if (coupled.mode(i) == HingeMode::sliding && coupled.hinge(i).can_rest) {
      if (is_axis(i) || coupled.hinge(i).straight) {
        if (const auto time = slip_end(i)) add({*time, {Kind::slip_ends, i}});
        if (!is_axis(i)) look_for(Kind::speeds_up, i);
      } else {
        look_for(Kind::slows_down, i);
        look_for(Kind::slip_turns, i);
      }
    } else if (coupled.mode(i) == HingeMode::resting) {
      look_for(Kind::rest_ends, i);
    }
  }
  for (int i = 0; i < static_cast<int>(events.size()); ++i) {
    const auto crossed = crossings[i] = user_crossing(i);
    if (crossed) add({crossed->time, {Kind::user, i}, crossed->rises});
  }
  return first;
}

// Whether a hinge changes so often that time does not get on: a failure.
bool MotionImpl::stalls(int body) {
  Recent& recent = recent_[body];
  if (!(now - recent.since <= options.stall_span)) recent = {now, 0};
  if (++recent.count <= options.stall_changes) return false;
  const bool rests = coupled.mode(body) == HingeMode::resting;
  const double speed = rate_of(body, view_state.data()).norm();
  const std::string hinge =
      rests ? fmt::format("resting, utilisation {}",
                          work_out() ? coupled.utilisation(body) : NAN)
            : fmt::format("sliding at {} rad/s", speed);
  set_failure({.status = CoupledStatus::not_converged, .body = body}, now);
  failure->reason = fmt::format(
      "at {} s: more than {} changes between rest and slip within {} s, the "
      "hinge is {}",
      now, options.stall_changes, options.stall_span, hinge);
  return true;
}

// True: an event of the application, or an end.
bool MotionImpl::handle(const Found& found) {
  now = found.time;
  look_at(now, stepper->end_state());
  const int i = found.watch.index;
  if (found.watch.kind == Kind::user) {
    note_user_values();
    user_values[i] = found.rises ? just_crossed : -just_crossed;
    event = i;
    return true;
  }
  if (changes_time != now) changes_here = 0;
  changes_time = now;
  if (++changes_here > 8 * size() + 16) {
    set_failure({.status = CoupledStatus::not_converged, .body = i}, now);
    return true;
  }
  std::vector<double> state = view_state;
  if (stalls(i)) return true;
  bool resolved = true;
  switch (found.watch.kind) {
    case Kind::slows_down:
    case Kind::speeds_up: {
      const Eigen::Vector3d rate = rate_of(i, state.data());
      straight_from[i] = rate.norm();
      coupled.set_direction(i, rate.normalized());
      coupled.slide_straight(i, found.watch.kind == Kind::slows_down);
      break;
    }
    case Kind::rest_ends:
      resolved = resolve_rest(state, i);
      break;
    default:
      stop_hinge(i, state);
      changes.push_back({now, i, HingeMode::sliding, HingeMode::resting});
      change_mode(i, HingeMode::resting);
      resolved = resolve_rest(state, -1);
  }
  if (!resolved) return true;
  restart(std::move(state));
  const std::optional<int> jumped = user_jump();
  if (!jumped) return false;
  event = *jumped;
  return true;
}

}  // namespace multibody
