#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace multibody {

/// d(state)/dt at a time; false if it does not exist.
using RateFunction =
    std::function<bool(double time, const double* state, double* rates)>;

/// The same function twice: along the motion, where earlier results may change
/// the last bits, and for queries, without side effects.
struct Rates {
  RateFunction in_step, aside;
};

/// Steps through time, one at a time. One step lies between start and end.
class Stepper {
 public:
  explicit Stepper(Rates rates) : rates_(std::move(rates)) {}
  virtual ~Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  /// Restarts here, possibly with another number of unknowns.
  virtual void restart(double time, std::span<const double> state);
  /// Restarts from the beginning of the last step, or from its end.
  void restart_at_begin() { restart(begin_, std::vector(from_)); }
  void restart_at_end() { restart(end_, std::vector(to_)); }
  /// One step, which ends at `limit` at the latest.
  /// @return false if the step fails
  bool step(double limit);
  double begin() const { return begin_; }
  double end() const { return end_; }
  std::span<const double> begin_state() const { return from_; }
  std::span<const double> end_state() const { return to_; }
  /// State in the last step, begin() <= time <= end(); no side effects, as for
  /// estimate().
  virtual void interpolate(double time, std::span<double> state) = 0;
  /// Approximate state at hardly any cost: Hermite's cubic between the ends.
  void estimate(double time, std::span<double> state);
  /// Degree of interpolate() as a polynomial in time; -1: no polynomial.
  virtual int degree() const { return -1; }
  /// Different for every computed step, including repeated steps.
  long serial() const { return serial_; }
  /// Index of the state's number with the largest error in the last step
  /// relative to the tolerance, which limits the step. -1: errors are unknown.
  virtual int largest_error() { return -1; }
  /// Length of the next step, s; for a later restart.
  double next_step() const { return next_step_; }
  virtual void set_next_step(double step) { next_step_ = step; }

 protected:
  /// Steps from begin_ and from_ to end_ and to_.
  virtual bool make_step(double limit) = 0;

  const Rates rates_;
  double begin_ = 0;
  double end_ = 0;
  double next_step_ = 0;
  long serial_ = 0;
  std::vector<double> from_, to_;
  // Rates at the ends of a step.
  bool begin_known_ = false, end_known_ = false;
  std::vector<double> begin_rates_, end_rates_;
};

/// Classical Runge-Kutta of fourth order with a fixed step; between, the same
/// formula with a shorter step.
std::unique_ptr<Stepper> make_rk4_stepper(Rates rates, double step);

struct AdaptiveOptions {
  double relative_tolerance;
  double absolute_tolerance;
  double longest_step = std::numeric_limits<double>::infinity();
  /// Numbers at the end of a state that need an absolute tolerance only:
  int coarse = 0;
  double coarse_tolerance = 1e-6;
};

/// Explicit Runge-Kutta of order 5 with error control and dense output, by
/// ARKODE of SUNDIALS.
std::unique_ptr<Stepper> make_adaptive_stepper(Rates rates,
                                               const AdaptiveOptions& options);

}  // namespace multibody
