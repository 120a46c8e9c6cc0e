#include "multibody/motion/stepper.hpp"

#include <algorithm>
#include <limits>

namespace multibody {

void Stepper::restart(double time, std::span<const double> state) {
  begin_ = end_ = time;
  from_.assign(state.begin(), state.end());
  to_.assign(state.begin(), state.end());
  begin_rates_.resize(state.size());
  begin_known_ = false;
  last_time_ = std::numeric_limits<double>::quiet_NaN();
}

bool Stepper::step(double limit) {
  begin_known_ = last_time_ == end_ && last_state_ == to_;
  if (begin_known_) begin_rates_ = last_rates_;
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
    begin_known_ = rates_(begin_, from_.data(), begin_rates_.data());
  }
  // The last stage of a step may be at its end.
  if (last_time_ != end_ || last_state_ != to_) {
    last_state_ = to_;
    last_rates_.resize(to_.size());
    last_time_ = rates_(end_, to_.data(), last_rates_.data())
                     ? end_
                     : std::numeric_limits<double>::quiet_NaN();
  }
  const double h = end_ - begin_;
  if (!(h > 0) || !begin_known_ || last_time_ != end_) {
    interpolate(time, state);
    return;
  }
  const double s = (time - begin_) / h;
  const double rest = 1 - s;
  for (std::size_t i = 0; i < to_.size(); ++i) {
    state[i] =
        rest * rest * ((1 + 2 * s) * from_[i] + s * h * begin_rates_[i]) +
        s * s * ((3 - 2 * s) * to_[i] - rest * h * last_rates_[i]);
  }
}

}  // namespace multibody
