#include "multibody/motion/user_events.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace multibody {

int UserEvents::add(MotionEvent event) {
  assert(!event.speed || event.crossing == MotionEvent::Crossing::rising);
  const double value = event.function(view_);
  all_.push_back({std::move(event), value});
  return static_cast<int>(all_.size()) - 1;
}

void UserEvents::restart() {
  for (Watched& w : all_) w.before = w.event.function(view_);
}

// Functions that use forces are evaluated only in the middle and at the end
// while their distance from 0 exceeds their change in the step.
void UserEvents::sample(Stepper& stepper) {
  if (all_.empty()) return;
  for (Watched& w : all_) w.full = true;
  const auto look = [&](int k, bool all) {
    const auto is_due = [&](const Watched& w) { return all || w.full; };
    if (std::ranges::none_of(all_, is_due)) return;
    view_.show_estimate(stepper,
                        StepFunction::point(k, stepper.begin(), stepper.end()));
    for (Watched& w : all_) {
      if (!is_due(w)) continue;
      view_.was_asked();
      w.values[k] = w.event.function(view_);
      w.needs_forces |= view_.was_asked();
    }
  };
  using F = StepFunction;
  look(F::last, true);
  look(F::middle, true);
  for (Watched& w : all_) {
    const std::array three{w.before, w.values[F::middle], w.values[F::last]};
    w.full = !w.event.speed && (!w.needs_forces || !F::is_far(three));
  }
  for (const int k : {0, 1, 2, 4, 5}) look(k, false);
}

std::optional<StepEvent> UserEvents::first(Stepper& stepper) {
  std::optional<StepEvent> first;
  for (int i = 0; i < static_cast<int>(all_.size()); ++i) {
    Watched& w = all_[i];
    w.crossed.reset();
    if (w.event.speed) {
      w.crossed = first_rise(w, stepper);
    } else if (w.full) {
      const StepFunction function(stepper.begin(), stepper.end(),
                                  [&](double time) {
                                    view_.show(stepper, time);
                                    return w.event.function(view_);
                                  });
      w.crossed = function.first_crossing(w.values, w.before, w.event.crossing);
    }
    if (w.crossed && (!first || w.crossed->time < first->time)) {
      first = {StepEvent::Kind::user, i, w.crossed->time, w.crossed->rises};
    }
  }
  return first;
}

// Bisects the step where the function may rise above 0, according to its speed
// plus the difference of the speeds at the ends.
std::optional<StepFunction::Crossed> UserEvents::first_rise(const Watched& w,
                                                            Stepper& stepper) {
  struct Point {
    double time, value, speed;
  };
  // A value that stays just below 0 would need as many evaluations as there are
  // negligible pieces in its path.
  constexpr int many = 300;
  double least = w.event.negligible;
  int looks = 0;
  const auto look = [&](double time) -> Point {
    if (++looks > many) least *= 1.1;
    view_.show(stepper, time);
    return {time, w.event.function(view_), w.event.speed(view_)};
  };
  const auto search = [&](const auto& self, const Point& from,
                          const Point& to) -> std::optional<double> {
    const double way =
        (to.time - from.time) *
        (std::max(from.speed, to.speed) + std::abs(from.speed - to.speed));
    const bool may_rise =
        to.value >= 0
            ? from.value < 0
            : from.value >= 0 || from.value + to.value + way > 2 * least;
    if (!may_rise) return {};
    const double time = from.time + (to.time - from.time) / 2;
    if (!(from.time < time && time < to.time)) {
      return to.value >= 0 ? std::optional(to.time) : std::nullopt;
    }
    const Point middle = look(time);
    const auto found = self(self, from, middle);
    return found ? found : self(self, middle, to);
  };
  const Point begin = look(stepper.begin());
  if (begin.value >= 0 && w.before < 0) {
    return StepFunction::Crossed{begin.time, true};
  }
  const auto time = search(search, begin, look(stepper.end()));
  if (!time) return {};
  return StepFunction::Crossed{*time, true};
}

void UserEvents::go_on() {
  for (Watched& w : all_) note(w, w.values.back());
}

void UserEvents::go_on_from_view() {
  for (Watched& w : all_) note(w, w.event.function(view_));
}

void UserEvents::report(const StepEvent& event) {
  go_on_from_view();
  all_[event.index].before = event.rises ? just_crossed : -just_crossed;
}

// Takes the function's present value. An event that has crossed 0 since, in its
// direction, keeps the old one: the crossing is reported in the next step. A
// value just at 0, where rounding would decide the side, counts as on the side
// that it crosses from.
void UserEvents::note(Watched& w, double value) {
  constexpr double rounding = 1e-12;
  const double size = std::max(std::abs(w.values[StepFunction::middle]),
                               std::abs(w.values[StepFunction::last]));
  if (std::abs(value) <= rounding * size) {
    if (w.crossed) w.before = w.crossed->rises ? -just_crossed : just_crossed;
  } else if (!is_crossing(w.before, value, w.event.crossing)) {
    w.before = value;
  }
}

std::optional<int> UserEvents::jumped() {
  std::optional<int> first;
  for (int i = 0; i < static_cast<int>(all_.size()); ++i) {
    Watched& w = all_[i];
    const double after = w.event.function(view_);
    if (!first && is_crossing(w.before, after, w.event.crossing)) {
      first = i;
      w.before = after;
    } else {
      note(w, after);
    }
  }
  return first;
}

}  // namespace multibody
