#include <algorithm>
#include <utility>
#include <vector>

#include "multibody/motion/stepper.hpp"

namespace multibody {
namespace {

class Rk4Stepper final : public Stepper {
 public:
  Rk4Stepper(Rates rates, double step) : Stepper(std::move(rates)) {
    next_step_ = step;
  }

  void interpolate(double time, std::span<double> state) override {
    if (time == end_) {
      std::ranges::copy(to_, state.begin());
    } else {
      advance(rates_.aside, time - begin_, state);
    }
  }

  void set_next_step(double) override {}

 private:
  bool make_step(double limit) override {
    // Avoids a last step of rounding size.
    constexpr double rounding = 1e-9;
    const bool last = limit - begin_ <= (1 + rounding) * next_step_;
    end_ = last ? limit : begin_ + next_step_;
    if (!begin_known_) {
      begin_known_ = rates_.in_step(begin_, from_.data(), begin_rates_.data());
    }
    return begin_known_ && advance(rates_.in_step, end_ - begin_, to_);
  }

  // From the beginning of the step, whose rates are known.
  bool advance(const RateFunction& rates, double h, std::span<double> to) {
    const std::size_t n = from_.size();
    for (auto* v : {&k2_, &k3_, &k4_, &trial_}) v->resize(n);
    const std::vector<double>& k1 = begin_rates_;
    const auto stage = [&](const std::vector<double>& k, double share,
                           std::vector<double>& out) {
      for (std::size_t i = 0; i < n; ++i) {
        trial_[i] = from_[i] + share * h * k[i];
      }
      return rates(begin_ + share * h, trial_.data(), out.data());
    };
    if (!stage(k1, 0.5, k2_) || !stage(k2_, 0.5, k3_) || !stage(k3_, 1, k4_)) {
      return false;
    }
    for (std::size_t i = 0; i < n; ++i) {
      to[i] = from_[i] + h / 6 * (k1[i] + 2 * (k2_[i] + k3_[i]) + k4_[i]);
    }
    return true;
  }

  std::vector<double> k2_, k3_, k4_, trial_;
};

}  // namespace

std::unique_ptr<Stepper> make_rk4_stepper(Rates rates, double step) {
  return std::make_unique<Rk4Stepper>(std::move(rates), step);
}

}  // namespace multibody
