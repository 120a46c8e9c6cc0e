#include "multibody/motion/stepper.hpp"

#include <algorithm>

namespace multibody {

void Stepper::restart(double time, std::span<const double> state) {
  ++serial_;
  begin_ = end_ = time;
  from_.assign(state.begin(), state.end());
  to_.assign(state.begin(), state.end());
  begin_rates_.resize(state.size());
  end_rates_.resize(state.size());
  begin_known_ = end_known_ = false;
}

bool Stepper::step(double limit) {
  ++serial_;
  begin_known_ = end_known_;
  begin_rates_.swap(end_rates_);
  end_known_ = false;
  begin_ = end_;
  from_ = to_;
  return make_step(limit);
}

void Stepper::estimate(double time, std::span<double> state) {
  if (time == begin_ || time == end_) {
    std::ranges::copy(time == begin_ ? from_ : to_, state.begin());
    return;
  }
  if (!begin_known_) {
    begin_known_ = rates_.aside(begin_, from_.data(), begin_rates_.data());
  }
  if (!end_known_) {
    end_known_ = rates_.aside(end_, to_.data(), end_rates_.data());
  }
  const double h = end_ - begin_;
  if (!(h > 0) || !begin_known_ || !end_known_) {
    interpolate(time, state);
    return;
  }
  const double s = (time - begin_) / h;
  const double rest = 1 - s;
  for (std::size_t i = 0; i < to_.size(); ++i) {
    state[i] =
        rest * rest * ((1 + 2 * s) * from_[i] + s * h * begin_rates_[i]) +
        s * s * ((3 - 2 * s) * to_[i] - rest * h * end_rates_[i]);
  }
}

}  // namespace multibody
