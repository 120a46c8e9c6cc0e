#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include "multibody/motion/stepper.hpp"

namespace multibody {
namespace {

// ARKODE returns error codes; its messages would go to stderr.
void silent(int, const char*, const char*, char*, void*) {}

// Sums of stages in one pass; SUNDIALS takes one for each of them.
int combine(int count, realtype* factors, N_Vector* vectors, N_Vector to) {
  constexpr sunindextype block = 8;
  const sunindextype size = NV_LENGTH_S(to);
  for (sunindextype first = 0; first < size; first += block) {
    const sunindextype used = std::min(block, size - first);
    std::array<double, block> sum{};
    for (int i = 0; i < count; ++i) {
      const double factor = factors[i];
      const double* from = NV_DATA_S(vectors[i]) + first;
      if (used == block) {
        for (int k = 0; k < block; ++k) sum[k] += factor * from[k];
      } else {
        for (int k = 0; k < used; ++k) sum[k] += factor * from[k];
      }
    }
    std::copy_n(sum.begin(), used, NV_DATA_S(to) + first);
  }
  return 0;
}

class AdaptiveStepper final : public Stepper {
 public:
  AdaptiveStepper(Rates rates, const AdaptiveOptions& options)
      : Stepper(std::move(rates)), options_(options) {
    SUNContext_Create(nullptr, &context_);
  }
  ~AdaptiveStepper() override {
    forget();
    SUNContext_Free(&context_);
  }

  void restart(double time, std::span<const double> state) override {
    if (state.size() != to_.size()) forget();
    Stepper::restart(time, state);
    wall_ = -std::numeric_limits<double>::infinity();
    last_time_ = std::numeric_limits<double>::quiet_NaN();
    inside_.clear();
    if (memory_) {
      begin_with(next_step_);
      return;
    }
    vector_ = N_VMake_Serial(static_cast<sunindextype>(to_.size()), to_.data(),
                             context_);
    if (!vector_) throw std::bad_alloc();
    vector_->ops->nvlinearcombination = combine;
    other_ = N_VClone(vector_);
    errors_ = N_VClone(vector_);
    memory_ = ERKStepCreate(rate, time, vector_, context_);
    if (!other_ || !errors_ || !memory_) throw std::bad_alloc();
    N_VConst(0, errors_);
    ERKStepSetErrHandlerFn(memory_, silent, nullptr);
    ERKStepSetUserData(memory_, this);
    ERKStepWFtolerances(memory_, weights);
    ERKStepSetTableNum(memory_, table);
    ERKStepSetInterpolantType(memory_, ARK_INTERP_HERMITE);
    ERKStepSetInterpolantDegree(memory_, dense_degree);
    ERKStepSetMaxNumSteps(memory_, -1);
    ERKStepSetMaxErrTestFails(memory_, most_failures);
    if (std::isfinite(options_.longest_step)) {
      ERKStepSetMaxStep(memory_, options_.longest_step);
    }
    ERKStepSetInitStep(memory_, next_step_);
  }

  void interpolate(double time, std::span<double> state) override {
    if (time == end_) {
      std::ranges::copy(to_, state.begin());
      return;
    }
    // Dense output of this order needs rates inside the step, at the same
    // points for each query.
    is_aside_ = true;
    const bool known = ERKStepGetDky(memory_, time, 0, other_) >= 0;
    is_aside_ = false;
    std::copy_n(known ? N_VGetArrayPointer(other_) : to_.data(), state.size(),
                state.begin());
  }

  int degree() const override { return dense_degree; }

  int largest_error() override {
    int largest = -1;
    double share = 0;
    const double* error = N_VGetArrayPointer(errors_);
    for (int i = 0; i < static_cast<int>(to_.size()); ++i) {
      const double of_allowed = std::abs(error[i]) * weight(i, to_[i]);
      if (!(of_allowed > share)) continue;
      share = of_allowed;
      largest = i;
    }
    return largest;
  }

 private:
  bool make_step(double limit) override {
    double end = end_;
    while (!try_step(limit, end)) {
      if (!shorten()) return false;
    }
    end_ = end;
    inside_.clear();
    // The last stage of a step may be at its end.
    end_known_ = last_time_ == end_ && last_state_ == to_;
    if (end_known_) end_rates_ = last_rates_;
    // Read now, because work between steps overwrites these numbers.
    ERKStepGetEstLocalErrors(memory_, errors_);
    // A step shortened by a limit does not predict the next one.
    const double planned = end < limit ? 0 : next_step_;
    ERKStepGetCurrentStep(memory_, &next_step_);
    next_step_ = std::max(next_step_, planned);
    return true;
  }

  // From begin_, with a first step; 0: ARKODE finds one.
  void begin_with(double step) {
    ERKStepReInit(memory_, rate, begin_, vector_);
    ERKStepSetInitStep(memory_, step);
  }

  bool try_step(double limit, double& end) {
    failed_at_ = std::numeric_limits<double>::quiet_NaN();
    if (std::isfinite(limit)) ERKStepSetStopTime(memory_, limit);
    return ERKStepEvolve(memory_, std::isfinite(limit) ? limit : begin_ + 1,
                         vector_, &end, ARK_ONE_STEP) >= 0;
  }

  // Shortens a step in which the rates do not exist. ERKStep would take it for
  // the end, although the solution may never reach the trial state. If it does,
  // steps approach it to this fraction of the step that met it first.
  bool shorten() {
    constexpr double near = 1e-3;
    const double way = failed_at_ - begin_;
    if (!(way > 0)) return false;
    if (wall_ <= begin_) first_way_ = way;
    wall_ = failed_at_;
    if (way <= near * first_way_) return false;
    to_ = from_;
    begin_with(way / 2);
    return true;
  }

  // Order 5 with an embedded fourth order. Of the tables up to order 8 whose
  // dense output has sufficient order it needed the fewest evaluations at
  // tolerances of 1e-6 to 1e-12.
  static constexpr ARKODE_ERKTableID table = ARKODE_DORMAND_PRINCE_7_4_5;

  static constexpr int dense_degree = 5;

  // Failures in a row. Friction may reverse within microseconds of the opening
  // of a lock, after steps of a tenth of a second; each failure makes the step
  // a few times shorter.
  static constexpr int most_failures = 60;

  static int rate(realtype time, N_Vector state, N_Vector to, void* self) {
    auto* stepper = static_cast<AdaptiveStepper*>(self);
    const double* y = N_VGetArrayPointer(state);
    double* f = N_VGetArrayPointer(to);
    if (stepper->is_aside_) return stepper->rate_inside(time, y, f) ? 0 : 1;
    const bool done = stepper->rates_.in_step(time, y, f);
    if (done) {
      stepper->remember(time, y, f);
    } else {
      stepper->failed_at_ = time;
    }
    return done ? 0 : 1;
  }

  // Known from the first look into a step on.
  bool rate_inside(double time, const double* y, double* f) {
    const std::span<const double> state(y, to_.size());
    const auto known = std::ranges::find_if(inside_, [&](const Inside& i) {
      return i.time == time && std::ranges::equal(i.state, state);
    });
    if (known != inside_.end()) {
      std::ranges::copy(known->rates, f);
      return true;
    }
    if (!rates_.aside(time, y, f)) return false;
    inside_.push_back({time, {y, y + state.size()}, {f, f + state.size()}});
    return true;
  }

  // Reciprocals of the tolerances.
  static int weights(N_Vector state, N_Vector to, void* self) {
    const auto* stepper = static_cast<AdaptiveStepper*>(self);
    const double* y = N_VGetArrayPointer(state);
    double* w = N_VGetArrayPointer(to);
    const auto size = static_cast<int>(stepper->to_.size());
    for (int i = 0; i < size; ++i) w[i] = stepper->weight(i, y[i]);
    return 0;
  }
  double weight(int i, double y) const {
    const AdaptiveOptions& o = options_;
    return i < static_cast<int>(to_.size()) - o.coarse
               ? 1 / (o.relative_tolerance * std::abs(y) + o.absolute_tolerance)
               : 1 / o.coarse_tolerance;
  }

  void remember(double time, const double* y, const double* f) {
    if (!begin_known_ && time == begin_ &&
        std::equal(from_.begin(), from_.end(), y)) {
      begin_rates_.assign(f, f + from_.size());
      begin_known_ = true;
      return;
    }
    last_time_ = time;
    last_state_.assign(y, y + from_.size());
    last_rates_.assign(f, f + from_.size());
  }

  void forget() {
    if (memory_) ERKStepFree(&memory_);
    if (vector_) N_VDestroy(vector_);
    if (other_) N_VDestroy(other_);
    if (errors_) N_VDestroy(errors_);
    memory_ = nullptr;
    vector_ = other_ = errors_ = nullptr;
  }

  AdaptiveOptions options_;
  SUNContext context_ = nullptr;
  void* memory_ = nullptr;
  N_Vector vector_ = nullptr;  // has the numbers of to_
  N_Vector other_ = nullptr;
  N_Vector errors_ = nullptr;  // errors of the last step
  // The last evaluation in a step.
  double last_time_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> last_state_, last_rates_;
  bool is_aside_ = false;
  struct Inside {
    double time;
    std::vector<double> state, rates;
  };
  std::vector<Inside> inside_;  ///< rates that dense output has asked for
  // Time of the last try without rates; the same of the last step that had one,
  // and the distance at which such steps began before it.
  double failed_at_ = std::numeric_limits<double>::quiet_NaN();
  double wall_ = -std::numeric_limits<double>::infinity();
  double first_way_ = 0;
};

}  // namespace

std::unique_ptr<Stepper> make_adaptive_stepper(Rates rates,
                                               const AdaptiveOptions& options) {
  return std::make_unique<AdaptiveStepper>(std::move(rates), options);
}

}  // namespace multibody
