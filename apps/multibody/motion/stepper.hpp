#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace multibody {

/// d(state)/dt at a time; false if there is none.
using RateFunction =
    std::function<bool(double time, const double* state, double* rates)>;

/// Hermite's cubic through states and rates at the ends of a step.
/// @param h  length of the step, s
/// @param s  share of it, 0 to 1
inline void hermite(std::span<const double> from,
                    std::span<const double> from_rates,
                    std::span<const double> to,
                    std::span<const double> to_rates, double h, double s,
                    std::span<double> state) {
  const double rest = 1 - s;
  for (std::size_t i = 0; i < to.size(); ++i) {
    state[i] = rest * rest * ((1 + 2 * s) * from[i] + s * h * from_rates[i]) +
               s * s * ((3 - 2 * s) * to[i] - rest * h * to_rates[i]);
  }
}

/// Steps through time, one at a time. One step lies between start and end.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// From here on, possibly with another number of unknowns.
  virtual void restart(double time, std::span<const double> state) = 0;
  /// One step, which ends at `limit` at the latest.
  /// @return false if it cannot be made
  virtual bool step(double limit) = 0;
  virtual double begin() const = 0;
  virtual double end() const = 0;
  virtual std::span<const double> begin_state() const = 0;
  virtual std::span<const double> end_state() const = 0;
  /// In the last step, begin() <= time <= end().
  virtual void interpolate(double time, std::span<double> state) = 0;
  /// The same as nearly as it can be had for next to nothing.
  void estimate(double time, std::span<double> state) {
    if (time == begin()) {
      std::ranges::copy(begin_state(), state.begin());
    } else if (time == end()) {
      std::ranges::copy(end_state(), state.begin());
    } else {
      estimate_inside(time, state);
    }
  }
  /// The number of the state whose error in the last step is the largest
  /// against what is allowed: what keeps steps short. -1: errors are not known.
  virtual int largest_error() = 0;
  /// Length of the next step, s; for a later restart.
  virtual double next_step() const = 0;
  virtual void set_next_step(double step) = 0;
  /// From the beginning of the last step, or from its end, again.
  void restart_at_begin() { restart(begin(), copy(begin_state())); }
  void restart_at_end() { restart(end(), copy(end_state())); }

 private:
  static std::vector<double> copy(std::span<const double> state) {
    return {state.begin(), state.end()};
  }
  virtual void estimate_inside(double time, std::span<double> state) = 0;
};

/// Classical Runge-Kutta of fourth order with a fixed step; between, the same
/// formula with a shorter step.
std::unique_ptr<Stepper> make_rk4_stepper(RateFunction rates, double step);

struct AdaptiveOptions {
  double relative_tolerance;
  double absolute_tolerance;
  double longest_step = std::numeric_limits<double>::infinity();
  /// So many numbers at the end of a state need an absolute tolerance only:
  int coarse = 0;
  double coarse_tolerance = 1e-6;
};

/// Explicit Runge-Kutta of order 5 with error control and dense output, by
/// ARKODE of SUNDIALS.
std::unique_ptr<Stepper> make_adaptive_stepper(RateFunction rates,
                                               const AdaptiveOptions& options);

}  // namespace multibody
