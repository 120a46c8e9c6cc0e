#include "multibody/motion/hinge_events.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "multibody/system/eigen_conversion.hpp"

namespace multibody {

using Eigen::Vector3d;

namespace {

// The highest value within a step of a function that is negative at both ends,
// and its time; only if it may be near 0.
// @param unit  size that counts as far from 0
std::pair<double, double> peak_between(const StepFunction& tau, double low,
                                       double low_value, double high,
                                       double high_value, double unit) {
  const double middle = low + (high - low) / 2;
  const double value = tau(middle);
  if (value > 0) return {middle, value};
  // Does the parabola through the three values have a maximum inside, near 0?
  // Steps resolve the held loads, so that it is accurate enough.
  constexpr double near = 0.1;
  const double bend = 2 * value - low_value - high_value;
  const double slope = high_value - low_value;
  const bool inside = bend > 0 && std::abs(slope) < 2 * bend;
  if (!inside || value + slope * slope / (8 * bend) < -near * unit) {
    return {middle, value};
  }
  constexpr int bits = 20;  // in time: values there differ by 1e-12
  std::uintmax_t steps = 40;
  const auto [time, below] = boost::math::tools::brent_find_minima(
      [&](double t) { return -tau(t); }, low, high, bits, steps);
  return {time, -below};
}

}  // namespace

HingeEvents::HingeEvents(Equations& equations, MotionSample& view,
                         Stepper& stepper, const HingeChanges& hinges,
                         const MotionOptions& options)
    : view_(view),
      equations_(equations),
      coupled_(equations.coupled),
      stepper_(stepper),
      hinges_(hinges),
      fixed_steps_(options.integrator == Integrator::rk4),
      slips_(equations.size()),
      gaps_(equations.size()) {}

template <class Value>
StepFunction HingeEvents::function(Value value) {
  return {stepper_.begin(), stepper_.end(), [this, value](double time) {
            if (time == stepper_.begin()) {
              view_.show(time, stepper_.begin_state());
            } else {
              view_.show(stepper_, time);
            }
            return value();
          }};
}

bool HingeEvents::slides_to_stop(int body) const {
  const Hinge& hinge = coupled_.hinge(body);
  return hinge.mode == HingeMode::sliding && hinge.can_rest &&
         (hinge.is_axis || hinge.straight);
}

void HingeEvents::sample() {
  std::vector<int> bodies, stopped;
  for (int i = 0; i < equations_.size(); ++i) {
    const Hinge& hinge = coupled_.hinge(i);
    if (hinge.mode == HingeMode::sliding && !hinge.stops.empty()) {
      stopped.push_back(i);
    }
    if (!slides_to_stop(i)) continue;
    bodies.push_back(i);
    slips_[i].direction = equations_.memory.hinges[i].direction;
    // Direction at the beginning of the step.
    const Vector3d rate = equations_.rate_of(i, stepper_.begin_state().data());
    if (hinge.follows && !rate.isZero(0)) {
      slips_[i].direction = rate.normalized();
    }
  }
  trial_.resize(equations_.number_count());
  for (const int k : {6, 3, 0, 1, 2, 4, 5}) {
    if (bodies.empty() && stopped.empty()) return;
    stepper_.estimate(StepFunction::point(k, stepper_.begin(), stepper_.end()),
                      trial_);
    for (const int i : bodies) {
      slips_[i].rates[k] =
          equations_.rate_of(i, trial_.data()).dot(slips_[i].direction);
    }
    for (const int i : stopped) {
      const Hinge& hinge = coupled_.hinge(i);
      gaps_[i].resize(hinge.stops.size());
      for (std::size_t stop = 0; stop < hinge.stops.size(); ++stop) {
        gaps_[i][stop][k] =
            hinge.gap(hinge.stops[stop], &trial_[equations_.offset(i)]);
      }
    }
  }
}

// Time at which sliding in a known direction passes 0.
std::optional<double> HingeEvents::slip_end(int body) {
  const StepFunction along = function(
      [this, body] { return view_.rate_of(body).dot(slips_[body].direction); });
  StepFunction::Values values = slips_[body].rates;
  const double t0 = stepper_.begin();
  const double t1 = stepper_.end();
  if (!(values[0] > 0)) {
    if (values.back() <= 0) {
      // The joint began and stopped within the step, or never moved. In a
      // deeper tree rounding of the neighbours' motion moves it this much.
      const double least = equations_.system.is_star() ? 0 : 1e-10;
      for (double part = t1 - t0; t0 + part > t0; part /= 2) {
        const double way = along(t0 + part);
        if (way > least) return along.locate(t0 + part, way, t1, values.back());
      }
      if (values.back() > -least) return {};
      return t0;
    }
    values[0] = just_crossed;
  }
  const auto crossed =
      along.first_crossing(values, values[0], MotionEvent::Crossing::falling);
  return crossed ? std::optional(crossed->time) : std::nullopt;
}

// Fixed steps do not shorten towards a stop: the joint stops when one implicit
// step would end its motion.
bool HingeEvents::stops_in_step(int body) {
  const double h = stepper_.end() - stepper_.begin();
  view_.show(stepper_.begin(), stepper_.begin_state());
  if (!view_.work_out()) return false;
  const Vector3d rate = view_.rate_of(body);
  const Vector3d alpha = view_.hinges().acceleration(body);
  // The test below takes some work.
  constexpr double near = 10;
  return rate.norm() < near * h * alpha.norm() &&
         CoupledDynamics::stops_within(body, rate, h, view_.hinges());
}

std::optional<double> HingeEvents::slowing(int body) {
  const StepFunction excess = function([this, body] {
    return view_.rate_of(body).norm() - hinges_.stop_speed();
  });
  const double end = excess.at_end();
  if (fixed_steps_ && stops_in_step(body)) return stepper_.begin();
  if (!(end <= 0)) return {};
  const double begin = excess.at_begin();
  if (begin > 0) return excess.locate(begin, end);
  // Slow during the whole step: counts as stopped unless it accelerates.
  return end <= begin ? std::optional(stepper_.end()) : std::nullopt;
}

std::optional<double> HingeEvents::speeding(int body) {
  const StepFunction excess = function([this, body] {
    return view_.rate_of(body).norm() - 2 * hinges_.straight_from(body);
  });
  const double end = excess.at_end();
  if (!(end > 0)) return {};
  const double begin = excess.at_begin();
  return begin > 0 ? stepper_.begin() : excess.locate(begin, end);
}

std::optional<double> HingeEvents::turning(int body) {
  const Vector3d before =
      equations_.rate_of(body, stepper_.begin_state().data());
  const StepFunction along = function(
      [this, body, &before] { return view_.rate_of(body).dot(before); });
  const double end = along.at_end();
  if (!(end < 0)) return {};
  const double time = along.locate(along.at_begin(), end);
  // The joint may reverse without stopping.
  constexpr double stopped = 0.1;
  return view_.rate_of(body).norm() <= stopped * before.norm()
             ? std::optional(time)
             : std::nullopt;
}

// Excess of the moment on a resting hinge over its limit: above 0 it slides. On
// a stop in N m, so that it is smooth where the stop ceases to press.
double HingeEvents::excess(int body) {
  if (coupled_.mode(body) == HingeMode::sliding) return pull(body);
  const double utilisation = view_.utilisation(body);
  if (std::isnan(utilisation)) return utilisation;
  const double limit = coupled_.slip_limit(body, view_.hinges());
  if (equations_.is_axis(body) &&
      coupled_.can_push(body, view_.state().data())) {
    const double held = std::abs(view_.hinges().reaction(body).moment.z);
    return utilisation > 0 ? held * (1 - limit / utilisation) : -held;
  }
  // Infinite without any reaction.
  constexpr double most = 1e6;
  return std::min(utilisation, most) - limit;
}

// Moment with which its stop would have to pull a ball joint, beyond rounding,
// N m.
double HingeEvents::pull(int body) {
  if (!view_.work_out()) return std::numeric_limits<double>::quiet_NaN();
  Hinges hinges = view_.hinges();
  return -hinges.stop_moment(body) - hinges.uncertain_moment();
}

// Time from which a resting hinge no longer holds, or a stop does not press, or
// has a contact without a solution, whose tau is NaN; resolve_rest()
// distinguishes the two.
std::optional<double> HingeEvents::rest_end(int body) {
  const StepFunction tau = function([this, body] { return excess(body); });
  const double t0 = stepper_.begin();
  double last_value = tau.at_end();
  const double begin = tau.at_begin();
  if (!(begin <= 0)) return t0;
  const bool on_stop = coupled_.can_push(body, stepper_.begin_state().data());
  const bool is_moment = on_stop && (equations_.is_axis(body) ||
                                     coupled_.mode(body) != HingeMode::resting);
  const double unit = is_moment ? -begin : 1;
  double last = stepper_.end();
  // For a hinge without load tau jumps from 0 to infinity when a moment begins;
  // it is located to the shortest possible step.
  const double soon = std::max(1e-10 * (last - t0), 1e-14 * std::abs(t0));
  const auto passed = [&](double time, double at_time) {
    return std::max(t0 + soon, tau.locate(t0, begin, time, at_time));
  };
  std::optional<double> lost;
  for (;;) {
    if (std::isnan(last_value)) {
      // Located less closely than the rounding of time: the value must again be
      // NaN in a step that ends there.
      constexpr int bits = 25;
      double known = t0;
      lost = last;
      for (int i = 0; i < bits; ++i) {
        const double middle = known + (*lost - known) / 2;
        (std::isnan(tau(middle)) ? *lost : known) = middle;
      }
      last = known;
      last_value = tau(known);
    }
    if (last_value > 0) return passed(last, last_value);
    const auto peak = peak_between(tau, t0, begin, last, last_value, unit);
    if (peak.second > 0) return passed(peak.first, peak.second);
    if (!std::isnan(peak.second)) return lost;
    std::tie(last, last_value) = peak;
  }
}

// Time at which the body reaches a stop. A body at a stop leaves it, regardless
// of rounding, unless something drives it back at once.
std::optional<double> HingeEvents::hit(int body) {
  std::optional<double> first;
  const Hinge& hinge = coupled_.hinge(body);
  for (std::size_t k = 0; k < hinge.stops.size(); ++k) {
    if (static_cast<int>(k) == hinge.rests_on) continue;
    const auto time = reaches(body, k);
    if (time && !(first && *first <= *time)) first = time;
  }
  return first;
}

std::optional<double> HingeEvents::reaches(int body, std::size_t number) {
  const Hinge& hinge = coupled_.hinge(body);
  const HingeStop& stop = hinge.stops[number];
  const int at = equations_.offset(body);
  const StepFunction gap = function([this, &hinge, &stop, at] {
    return hinge.gap(stop, &view_.state()[at]);
  });
  StepFunction::Values values = gaps_[body][number];
  const double rate = stop.side * hinge.stop_rate(&stepper_.begin_state()[at]);
  // Shorter than the resolution of time.
  constexpr double rounding = 1e-15;
  const double soon = rounding * (std::max(1.0, std::abs(stop.angle)) -
                                  rate * std::abs(stepper_.begin()));
  if (rate < 0 && values[0] <= soon) return stepper_.begin();
  if (!(values[0] > 0)) values[0] = just_crossed;
  return comes_back(gap, values, body, stop.side);
}

// Time at which a gap that opens at `from` has closed: the first sample at
// which it is closed.
std::optional<double> HingeEvents::short_flight(const StepFunction& gap,
                                                double from) {
  for (int k = 1; k <= StepFunction::last; ++k) {
    double high = StepFunction::point(k, gap.begin(), gap.end());
    double high_value = high > from ? gap(high) : 0;
    if (!(high_value < 0)) continue;
    for (double part = (high - from) / 2; from + part > from; part /= 2) {
      const double value = gap(from + part);
      if (value > 0) return gap.locate(from + part, value, high, high_value);
      high = from + part;
      high_value = value;
    }
    return {};
  }
  return {};
}

// Time at which a gap closes. While it opens, rounding may show it just behind
// a stop; then the rest of the step is examined. At such a slow departure it
// may seem to come back, too.
std::optional<double> HingeEvents::comes_back(const StepFunction& gap,
                                              StepFunction::Values values,
                                              int body, int side) {
  double from = stepper_.begin();
  const double end = stepper_.end();
  const auto comes = [&](double time) {
    view_.show(stepper_, time);
    const double* s = &view_.state()[equations_.offset(body)];
    return side * coupled_.hinge(body).stop_rate(s) < 0;
  };
  constexpr int most = 10;
  for (int i = 0; i < most && from < end; ++i) {
    const StepFunction rest(from, end, [&](double t) { return gap(t); });
    const auto crossed =
        rest.first_crossing(values, values[0], MotionEvent::Crossing::falling);
    if (crossed && comes(crossed->time)) return crossed->time;
    const auto time = short_flight(rest, crossed ? crossed->time : from);
    if (time && comes(*time)) return time;
    if (!crossed) return {};
    from = crossed->time;
    values[0] = just_crossed;
    for (int k = 1; k <= StepFunction::last; ++k) {
      values[k] = gap(StepFunction::point(k, from, end));
    }
  }
  return {};
}

// Time at which it rests on a stop after its last bounces.
std::optional<double> HingeEvents::settling(int body) const {
  const double time = hinges_.settle_time(body);
  return 0 < time && time <= stepper_.end() ? std::optional(time)
                                            : std::nullopt;
}

std::vector<StepEvent> HingeEvents::first() {
  sample();
  std::vector<StepEvent> found;
  const auto add = [&](Kind kind, int body, std::optional<double> time) {
    if (time) found.push_back({kind, body, *time});
  };
  for (int i = 0; i < equations_.size(); ++i) {
    const Hinge& hinge = coupled_.hinge(i);
    if (slides_to_stop(i)) {
      add(Kind::slip_ends, i, slip_end(i));
      if (!hinge.is_axis) add(Kind::speeds_up, i, speeding(i));
    } else if (hinge.mode == HingeMode::sliding && hinge.can_rest) {
      add(Kind::slows_down, i, slowing(i));
      add(Kind::slip_turns, i, turning(i));
    } else if (hinge.mode == HingeMode::resting) {
      add(Kind::rest_ends, i, rest_end(i));
      add(Kind::settles, i, settling(i));
    }
    if (hinge.slides_on_stop()) {
      add(Kind::leaves_stop, i, rest_end(i));
      add(Kind::settles, i, settling(i));
    }
    if (hinge.mode == HingeMode::sliding && !hinge.stops.empty()) {
      add(Kind::hits_stop, i, hit(i));
    }
  }
  if (found.empty()) return found;
  std::ranges::stable_sort(found, {}, &StepEvent::time);
  const double first = found.front().time;
  constexpr double instant = 1e-12;
  std::vector<StepEvent> together;
  for (const StepEvent& event : found) {
    if (event.time > first + instant * (1 + std::abs(first))) break;
    // Later events of a hinge depend on its first one.
    const bool is_new = std::ranges::find(together, event.index,
                                          &StepEvent::index) == together.end();
    if (is_new) together.push_back(event);
  }
  return together;
}

}  // namespace multibody
