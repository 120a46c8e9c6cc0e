#include "multibody/motion/force_kinks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multibody {
namespace {

// The error of a force near a kink grows with the square of this distance.
double near(double kink) {
  constexpr double share = 1e-10;
  return share * std::max(1.0, std::abs(kink));
}

bool is_at(double value, double kink) {
  return std::abs(value - kink) <= near(kink);
}

}  // namespace

bool ForceKinks::sample(Stepper& stepper) {
  if (!equations_.forces) return false;
  const double begin = stepper.begin();
  const double end = stepper.end();
  const auto look = [&](double time) {
    view_.show_estimate(stepper, time);
    now_.clear();
    equations_.forces->add_kinks(begin + (end - begin) / 2, view_.motions(),
                                 now_);
  };
  now_.clear();
  equations_.forces->add_kinks(begin + (end - begin) / 2, view_.motions(),
                               now_);
  if (now_.empty() || !(begin < end)) return false;
  tracks_.resize(now_.size());
  for (int k = 0; k <= StepFunction::last; ++k) {
    look(StepFunction::point(k, begin, end));
    for (std::size_t i = 0; i < now_.size(); ++i) {
      tracks_[i].kinks = now_[i].kinks;
      tracks_[i].values[k] = now_[i].value;
    }
  }
  // Direction of motion away from a kink.
  constexpr double soon = 1e-4;
  look(begin + soon * (end - begin));
  for (std::size_t i = 0; i < now_.size(); ++i) tracks_[i].soon = now_[i].value;
  return true;
}

std::optional<double> ForceKinks::first(Stepper& stepper) {
  if (!sample(stepper)) return {};
  std::optional<double> first;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const auto time = leaves(stepper, i);
    if (time && (!first || *time < *first)) first = time;
  }
  return first;
}

// Time at which the variable leaves the piece between two kinks in which the
// step begins. At a kink its motion decides the piece.
std::optional<double> ForceKinks::leaves(Stepper& stepper, std::size_t i) {
  const auto& [kinks, values, soon] = tracks_[i];
  const double begin = values[0];
  const auto above = std::ranges::find_if(
      kinks, [&](double kink) { return kink > begin + near(kink); });
  const bool at_kink = above != kinks.begin() && is_at(begin, *(above - 1));
  const auto below = above - (at_kink ? 1 : 0);
  std::optional<double> first;
  const auto note = [&](double kink, double before) {
    const auto time = passes(stepper, i, kink, before);
    if (time && (!first || *time < *first)) first = time;
  };
  int side = 0;
  if (at_kink) {
    const auto off = std::ranges::find_if(
        values, [&](double value) { return !is_at(value, *below); });
    // A held hinge stays at the kink.
    if (off == values.end()) return {};
    const double next = !is_at(soon, *below) ? soon : *off;
    side = next < *below ? -1 : 1;
    note(*below, side * just_crossed);
  }
  if (side >= 0 && above != kinks.end()) note(*above, begin - *above);
  if (side <= 0 && below != kinks.begin()) {
    note(*(below - 1), begin - *(below - 1));
  }
  return first;
}

// Before the end of the step, that is.
std::optional<double> ForceKinks::passes(Stepper& stepper, std::size_t i,
                                         double kink, double before) {
  StepFunction::Values values = tracks_[i].values;
  for (double& value : values) value -= kink;
  const double begin = stepper.begin();
  const double end = stepper.end();
  const StepFunction function(begin, end, [&](double time) {
    view_.show(stepper, time);
    now_.clear();
    equations_.forces->add_kinks(begin + (end - begin) / 2, view_.motions(),
                                 now_);
    return now_[i].value - kink;
  });
  const auto crossed =
      function.first_crossing(values, before, MotionEvent::Crossing::either);
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  if (!crossed || end - crossed->time <= rounding * std::abs(end)) return {};
  const auto ends = [&](double time) {
    return std::abs(function(time)) <= near(kink);
  };
  if (ends(end) && ends(crossed->time + (end - crossed->time) / 2)) return {};
  return crossed->time;
}

}  // namespace multibody
