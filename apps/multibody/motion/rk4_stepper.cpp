#include <algorithm>
#include <utility>
#include <vector>

#include "multibody/motion/stepper.hpp"

namespace multibody {
namespace {

class Rk4Stepper final : public Stepper {
 public:
  Rk4Stepper(RateFunction rates, double step)
      : rates_(std::move(rates)), step_(step) {}

  void restart(double time, std::span<const double> state) override {
    begin_ = end_ = time;
    from_.assign(state.begin(), state.end());
    to_ = from_;
    end_known_ = false;
    for (auto* v : {&k1_, &k2_, &k3_, &k4_, &trial_}) v->resize(state.size());
  }

  bool step(double limit) override {
    begin_ = end_;
    from_ = to_;
    // Not a step that is nothing but rounding at the end.
    constexpr double rounding = 1e-9;
    const bool last = limit - begin_ <= (1 + rounding) * step_;
    end_ = last ? limit : begin_ + step_;
    if (end_known_) {
      std::swap(k1_, end_rates_);
    } else if (!rates_(begin_, from_.data(), k1_.data())) {
      return false;
    }
    end_known_ = false;
    return rest_of_step(end_ - begin_, to_);
  }

  double begin() const override { return begin_; }
  double end() const override { return end_; }
  std::span<const double> begin_state() const override { return from_; }
  std::span<const double> end_state() const override { return to_; }

  void interpolate(double time, std::span<double> state) override {
    if (time == end_) {
      std::ranges::copy(to_, state.begin());
      return;
    }
    result_.resize(from_.size());
    rest_of_step(time - begin_, result_);
    std::ranges::copy(result_, state.begin());
  }

  // Hermite's cubic between the ends, whose last rates are the first of the
  // next step.
  void estimate_inside(double time, std::span<double> state) override {
    const double h = end_ - begin_;
    if (!end_known_) {
      end_rates_.resize(to_.size());
      end_known_ = h > 0 && rates_(end_, to_.data(), end_rates_.data());
    }
    if (!end_known_) {
      interpolate(time, state);
      return;
    }
    hermite(from_, k1_, to_, end_rates_, h, (time - begin_) / h, state);
  }

  int largest_error() override { return -1; }
  double next_step() const override { return step_; }
  void set_next_step(double) override {}

 private:
  // With k1 in place.
  bool rest_of_step(double h, std::vector<double>& to) {
    const std::size_t n = from_.size();
    const auto stage = [&](const std::vector<double>& k, double share,
                           std::vector<double>& out) {
      for (std::size_t i = 0; i < n; ++i) {
        trial_[i] = from_[i] + share * h * k[i];
      }
      return rates_(begin_ + share * h, trial_.data(), out.data());
    };
    if (!stage(k1_, 0.5, k2_) || !stage(k2_, 0.5, k3_) || !stage(k3_, 1, k4_)) {
      return false;
    }
    for (std::size_t i = 0; i < n; ++i) {
      to[i] = from_[i] + h / 6 * (k1_[i] + 2 * (k2_[i] + k3_[i]) + k4_[i]);
    }
    return true;
  }

  RateFunction rates_;
  double step_;
  double begin_ = 0;
  double end_ = 0;
  std::vector<double> from_, to_, k1_, k2_, k3_, k4_, trial_, result_;
  std::vector<double> end_rates_;  // at the end of the last step
  bool end_known_ = false;
};

}  // namespace

std::unique_ptr<Stepper> make_rk4_stepper(RateFunction rates, double step) {
  return std::make_unique<Rk4Stepper>(std::move(rates), step);
}

}  // namespace multibody
