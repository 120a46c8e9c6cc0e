#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "multibody/motion/motion_impl.hpp"

// Crossings within a step, those included that come back before its end.
//
// A function is looked at in 7 Chebyshev points of the step, 5 of them inside:
// what is a polynomial of degree 6 in time is known from them for certain, and
// steps that meet a tolerance leave little else. That polynomial is halved
// until its Bernstein coefficients tell where it crosses 0 or comes near it;
// the function itself is asked there. What needs forces is looked at in the
// middle first.
namespace multibody {
namespace {

using Values = MotionImpl::StepSamples::Values;
constexpr int last = MotionImpl::StepSamples::last;
constexpr int middle = last / 2;

// Chebyshev points of the second kind in [0, 1], increasing.
const Values nodes = [] {
  Values x{};
  for (int k = 0; k <= last; ++k) {
    const double sine = std::sin(std::numbers::pi * k / (2 * last));
    x[k] = sine * sine;
  }
  x[middle] = 0.5;
  return x;
}();

// Bernstein coefficients of the polynomial through the values, on [0, 1]. By
// divided differences from the beginning on: of a long step it keeps what
// happens in its first moments.
Values bernstein(const Values& values) {
  Values newton = values;
  for (int order = 1; order <= last; ++order) {
    for (int k = last; k >= order; --k) {
      newton[k] = (newton[k] - newton[k - 1]) / (nodes[k] - nodes[k - order]);
    }
  }
  Values power{};
  for (int k = last; k >= 0; --k) {
    for (int j = last; j >= 0; --j) {
      power[j] = (j > 0 ? power[j - 1] : 0) - nodes[k] * power[j];
    }
    power[0] += newton[k];
  }
  Values result{};
  for (int i = 0; i <= last; ++i) {
    double share = 1;  // of binomials i over j and last over j
    for (int j = 0; j <= i; ++j) {
      result[i] += share * power[j];
      share *= static_cast<double>(i - j) / (last - j);
    }
  }
  return result;
}

// The halves of a polynomial, by de Casteljau.
std::pair<Values, Values> halves(Values c) {
  Values left{};
  Values right{};
  for (int round = 0; round <= last; ++round) {
    left[round] = c[0];
    right[last - round] = c[last - round];
    for (int i = 0; i < last - round; ++i) c[i] = (c[i] + c[i + 1]) / 2;
  }
  return {left, right};
}

double polynomial(Values c, double s) {
  for (int n = last; n > 0; --n) {
    for (int i = 0; i < n; ++i) c[i] += s * (c[i + 1] - c[i]);
  }
  return c[0];
}

// At most so many times the polynomial turns from rising to falling or back.
int turns_of(const Values& c) {
  int count = 0;
  double before = 0;
  for (int i = 1; i <= last; ++i) {
    const double step = c[i] - c[i - 1];
    if ((before < 0 && step > 0) || (before > 0 && step < 0)) ++count;
    if (step != 0) before = step;
  }
  return count;
}

// Size of what the polynomial has in its two highest degrees: what the values
// do not say of the function is hardly more.
double uncertainty(const Values& values) {
  double sum = 0;
  for (const int degree : {last - 1, last}) {
    double c = 0;
    for (int k = 0; k <= last; ++k) {
      const double share = k == 0 || k == last ? 0.5 : 1;
      c += share * values[k] *
           std::cos(degree * std::numbers::pi * (last - k) / last);
    }
    sum += std::abs(2 * c / last);
  }
  return sum;
}

struct Point {
  double time, value;
};

// Points of a function between which it crosses 0 once at most, as far as the
// polynomial through its values tells.
class Separation {
 public:
  Separation(std::function<double(double)> function, double begin, double end,
             double unsure)
      : function_(std::move(function)),
        begin_(begin),
        end_(end),
        unsure_(unsure) {}

  void look(const Values& c, double low, double high) {
    const double sign = c[0] > 0 || (c[0] == 0 && c[last] > 0) ? 1 : -1;
    const bool same = sign * c[last] > 0;
    const int turns = turns_of(c);
    if (same) {
      if (turns == 0 || std::ranges::all_of(
                            c, [&](double x) { return sign * x > unsure_; })) {
        return;
      }
      if (turns == 1) {
        add_extremum(c, low, high, sign);
        return;
      }
    } else if (turns <= 1) {
      add(low);
      add(high);
      // From 0 up and through it again: the top tells the two apart.
      if (turns == 1) {
        add(low + extremum(c, sign).first * (high - low));
        add(low + extremum(c, -sign).first * (high - low));
      }
      return;
    }
    const double half = low + (high - low) / 2;
    if (!(low < half && half < high)) return;
    const auto [left, right] = halves(c);
    look(left, low, half);
    look(right, half, high);
  }

  std::vector<Point> points;

 private:
  double time(double s) const { return begin_ + s * (end_ - begin_); }
  double add(double s) {
    if (s <= 0 || s >= 1) return 0;  // known
    points.push_back({time(s), function_(time(s))});
    return points.back().value;
  }
  static std::pair<double, double> extremum(const Values& c, double sign) {
    std::uintmax_t steps = 60;
    return boost::math::tools::brent_find_minima(
        [&](double x) { return sign * polynomial(c, x); }, 0., 1., bits, steps);
  }
  void add_extremum(const Values& c, double low, double high, double sign) {
    const auto [s, least] = extremum(c, sign);
    if (least > unsure_) return;
    if (sign * add(low + s * (high - low)) <= 0) return;
    std::uintmax_t steps = 30;
    const auto [t, value] = boost::math::tools::brent_find_minima(
        [&](double x) { return sign * function_(x); }, time(low), time(high),
        bits, steps);
    points.push_back({t, sign * value});
  }

  static constexpr int bits = 26;  // of time: values differ by 1e-15 of it
  std::function<double(double)> function_;
  double begin_, end_;
  double unsure_;
};

struct Range {
  double nearest;  // to 0
  double spread;
  bool one_sign;
};
template <class Container>
Range range_of(const Container& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {std::min(std::abs(*low), std::abs(*high)), *high - *low,
          *low > 0 || *high < 0};
}

bool wanted(double before, double after, MotionEvent::Crossing way) {
  return (before < 0 && after >= 0 && way != MotionEvent::Crossing::falling) ||
         (before > 0 && after <= 0 && way != MotionEvent::Crossing::rising);
}

}  // namespace

double MotionImpl::sample_time(int k) const {
  const double t0 = stepper->begin();
  const double t1 = stepper->end();
  if (k == last) return t1;
  return t0 + nodes[k] * (t1 - t0);
}

// Values of the application's events and of what may end sliding at points of
// the last step.
void MotionImpl::sample_step() {
  const auto user = static_cast<int>(events.size());
  samples.slip.resize(size());
  samples.full.assign(user, true);
  bool slips = false;
  for (int i = 0; i < size(); ++i) slips = slips || slides_to_stop(i);
  if (user == 0 && !slips) return;
  for (int i = 0; slips && i < size(); ++i) {
    slip_directions[i] = coupled.direction(i);
    if (!coupled.hinge(i).follows) continue;
    // Where it was going when the step began.
    const Eigen::Vector3d rate = rate_of(i, stepper->begin_state().data());
    if (!rate.isZero(0)) slip_directions[i] = rate.normalized();
  }
  const auto look = [&](int k, auto&& which) {
    if (k == 0) {
      std::ranges::copy(stepper->begin_state(), trial_.begin());
    } else if (k == last) {
      std::ranges::copy(stepper->end_state(), trial_.begin());
    } else {
      stepper->estimate(sample_time(k), trial_);
    }
    for (int i = 0; slips && i < size(); ++i) {
      if (slides_to_stop(i)) {
        samples.slip[i][k] = rate_of(i, trial_.data()).dot(slip_directions[i]);
      }
    }
    if (std::ranges::none_of(samples.full, which)) return;
    look_at(sample_time(k), trial_);
    for (int i = 0; i < user; ++i) {
      if (!which(samples.full[i])) continue;
      forces_asked_ = false;
      samples.user[i][k] = events[i].function(sample);
      if (forces_asked_) needs_forces[i] = true;
    }
  };
  const auto every = [](char) { return true; };
  look(last, every);
  look(middle, every);
  for (int i = 0; i < user; ++i) {
    if (!needs_forces[i]) continue;
    // As long as it is further from 0 than it moves, three points are enough.
    const Values& v = samples.user[i];
    const Range range =
        range_of(std::array<double, 3>{user_values[i], v[middle], v[last]});
    samples.full[i] = !(range.one_sign && range.nearest > range.spread);
  }
  const auto full = [](char is) { return is != 0; };
  for (const int k : {0, 1, 2, 4, 5}) look(k, full);
}

// The first wanted crossing of a function whose values at the nodes are known.
// `before` is its value before the step: if that has another sign than the
// first one it has crossed at once, unless it has just been reported.
std::optional<MotionImpl::Crossed> MotionImpl::first_crossing(
    const Watch& watch, Values values, double before,
    MotionEvent::Crossing way) {
  if (before * values[0] <= 0) {
    if (std::abs(before) == just_crossed) {
      values[0] = before;
    } else if (wanted(before, values[0], way)) {
      return Crossed{stepper->begin(), before < 0};
    } else {
      before = values[0];
    }
  }
  const Range range = range_of(values);
  if (range.one_sign && range.nearest > range.spread &&
      before * values[0] > 0) {
    return {};
  }
  const double t0 = stepper->begin();
  const double t1 = stepper->end();
  const auto at = [&](double time) { return value_at(watch, time); };
  // Between the ends states are estimates, worst in the middle. What the
  // integrator itself says costs some evaluations.
  double miss = std::abs(at(sample_time(middle)) - values[middle]);
  constexpr double rough = 1e-3;
  if (!(miss <= rough * range.spread)) {
    for (int k = 1; k < last; ++k) values[k] = at(sample_time(k));
    miss = 0;
  }
  Separation separation(at, t0, t1, uncertainty(values) + 2 * miss);
  std::vector<Point>& points = separation.points;
  for (int k = 1; k <= last; ++k) points.push_back({sample_time(k), values[k]});
  separation.look(bernstein(values), 0, 1);
  std::ranges::sort(points, {}, &Point::time);
  double from = t0;
  for (const Point& point : points) {
    if (wanted(before, point.value, way)) {
      const bool rises = before < 0;
      // By the steps' own formula, where the points are estimates.
      const double low = from == t0 ? values[0] : at(from);
      const double high = point.time == t1 ? values[last] : at(point.time);
      if (low * high <= 0) {
        return Crossed{locate(watch, from, low, point.time, high), rises};
      }
    }
    if (point.value > 0 || point.value < 0) {
      before = point.value;
      from = point.time;
    }
  }
  return {};
}

std::optional<MotionImpl::Crossed> MotionImpl::user_crossing(int index) {
  if (!samples.full[index]) return {};
  return first_crossing({Watch::Kind::user, index}, samples.user[index],
                        user_values[index], events[index].crossing);
}

// Where sliding in a known direction passes 0.
std::optional<double> MotionImpl::slip_end(int body) {
  const Watch watch{Watch::Kind::slip_ends, body};
  Values values = samples.slip[body];
  const double t0 = stepper->begin();
  const double t1 = stepper->end();
  if (!(values[0] > 0)) {
    if (values[last] <= 0) {
      // Begun and stopped within the step; or it never got under way.
      for (double part = t1 - t0; t0 + part > t0; part /= 2) {
        const double way = value_at(watch, t0 + part);
        if (way > 0) {
          return locate(watch, t0 + part, way, t1, values[last]);
        }
      }
      return t0;
    }
    values[0] = just_crossed;
  }
  const auto crossed =
      first_crossing(watch, values, values[0], MotionEvent::Crossing::falling);
  return crossed ? std::optional(crossed->time) : std::nullopt;
}

// What the application's events are now. One that has crossed 0 since, as
// wanted, keeps the old value: the crossing is reported in the next step. One
// that is just at 0, where rounding would say which side that is, counts as on
// the side that it crosses from.
void MotionImpl::note_user_values() {
  for (std::size_t i = 0; i < events.size(); ++i) {
    note_user_value(static_cast<int>(i), events[i].function(sample));
  }
}

void MotionImpl::note_user_value(int index, double value) {
  double& before = user_values[index];
  constexpr double rounding = 1e-12;
  const Values& seen = samples.user[index];
  const double size = std::max(std::abs(seen[middle]), std::abs(seen[last]));
  if (std::abs(value) <= rounding * size) {
    const auto& crossed = crossings[index];
    if (crossed) before = crossed->rises ? -just_crossed : just_crossed;
  } else if (!wanted(before, value, events[index].crossing)) {
    before = value;
  }
}

// An event whose function jumped over 0 when a hinge changed.
std::optional<int> MotionImpl::user_jump() {
  std::optional<int> first;
  for (int i = 0; i < static_cast<int>(events.size()); ++i) {
    const double after = events[i].function(sample);
    if (!first && wanted(user_values[i], after, events[i].crossing)) {
      first = i;
      user_values[i] = after;
    } else {
      note_user_value(i, after);
    }
  }
  return first;
}

}  // namespace multibody
