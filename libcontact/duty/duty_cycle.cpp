#include "libcontact/duty/duty_cycle.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/root_finding.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond turn_by(const Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Quaterniond::Identity();
  return Quaterniond(AngleAxisd(angle, vector / angle));
}

}  // namespace

TurnSequence::TurnSequence(std::string_view axes) {
  bool good = axes.size() == 1 || axes.size() == 3;
  for (std::size_t i = 0; i < axes.size() && good; ++i) {
    good =
        axes[i] >= 'x' && axes[i] <= 'z' && (i == 0 || axes[i] != axes[i - 1]);
    if (good) axes_.emplace_back(Vector3d::Unit(axes[i] - 'x'));
  }
  if (good) return;
  throw Error(detail::must_be(
      detail::message("sequence {}", axes),
      "three of the axes x, y, z, neighbours not alike, such as zxy"));
}

Quaterniond TurnSequence::turn(const Vector3d& angles) const {
  Quaterniond turn = Quaterniond::Identity();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    turn = turn * AngleAxisd(angles[static_cast<int>(i)], axes_[i]);
  }
  return turn;
}

Vector3d TurnSequence::rate(const Vector3d& angles,
                            const Vector3d& angle_rates) const {
  Quaterniond turn = Quaterniond::Identity();
  Vector3d rate = Vector3d::Zero();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const int k = static_cast<int>(i);
    rate += angle_rates[k] * (turn * axes_[i]);
    turn = turn * AngleAxisd(angles[k], axes_[i]);
  }
  return rate;
}

DutyCycle::DutyCycle(PeriodicSpline forces, ForceFrame frame,
                     PeriodicSpline angles, TurnSequence sequence)
    : forces_(std::move(forces)),
      frame_(frame),
      motion_(std::move(angles)),
      sequence_(std::move(sequence)) {}

DutyCycle::DutyCycle(PeriodicSpline forces, ForceFrame frame,
                     PeriodicSpline rates)
    : forces_(std::move(forces)), frame_(frame), motion_(std::move(rates)) {
  Quaterniond turn = Quaterniond::Identity();
  for (std::size_t i = 0; i < times().size(); ++i) {
    turns_.push_back(turn);
    const double next =
        i + 1 < times().size() ? times()[i + 1] : times()[0] + period();
    turn = turned(turn, times()[i], next);
  }
  closure_ = turn.angularDistance(turns_.front());
}

// Q' = [Dw] Q.
Quaterniond DutyCycle::turned(Quaterniond turn, double from, double to) const {
  constexpr int steps = 4;
  const double step = (to - from) / steps;
  const double half_width = step / (2 * std::sqrt(3.0));
  for (int i = 0; i < steps; ++i) {
    const double middle = from + (i + 0.5) * step;
    const Vector3d one = motion_.value(middle - half_width);
    const Vector3d two = motion_.value(middle + half_width);
    turn = turn_by(step / 2 * (one + two) +
                   step * half_width / 2 * two.cross(one)) *
           turn;
  }
  return turn.normalized();
}

CycleState DutyCycle::at(double time) const {
  CycleState state;
  const Vector3d motion = motion_.value(time);
  if (sequence_) {
    state.turn = sequence_->turn(motion);
    state.rate = sequence_->rate(motion, motion_.slope(time));
  } else {
    const double first = times().front();
    const double within =
        time - period() * std::floor((time - first) / period());
    const auto after =
        std::upper_bound(times().begin() + 1, times().end(), within);
    const std::size_t before =
        static_cast<std::size_t>(after - times().begin()) - 1;
    state.turn = turned(turns_[before], times()[before], within);
    state.rate = motion;
  }
  state.reaction = forces_.value(time);
  if (frame_.axes == JointBody::body) {
    state.reaction = state.turn * state.reaction;
  }
  if (frame_.on == JointBody::carrier) state.reaction = -state.reaction;
  return state;
}

std::vector<DutyCycle::Node> DutyCycle::nodes(bool is_pin) const {
  std::vector<double> ends = times();
  ends.push_back(times().front() + period());
  if (is_pin) {
    const auto rate = [this](double time) {
      return sequence_ ? motion_.slope(time)[0] : motion_.value(time).z();
    };
    // Fine enough for the three roots that a cubic may have.
    constexpr int parts = 8;
    // The edge of a pin's contact passes all points of a line at once: a kink
    // in their wear, which finer intervals make up for.
    constexpr int every = 2;
    const std::size_t count = ends.size();
    for (std::size_t i = 1; i < count; ++i) {
      for (int k = 0; k < parts; ++k) {
        const double width = (ends[i] - ends[i - 1]) / parts;
        const double low = ends[i - 1] + k * width;
        const double at_low = rate(low);
        const double at_high = rate(low + width);
        if (k > 0 && k % every == 0) ends.push_back(low);
        if (!(at_low * at_high < 0)) continue;
        ends.push_back(
            shrink_bracket(rate, low, low + width, at_low, at_high, 53)
                .middle());
      }
    }
    std::sort(ends.begin(), ends.end());
  }
  using Four = boost::math::quadrature::gauss<double, 4>;
  using Eight = boost::math::quadrature::gauss<double, 8>;
  const auto& places = is_pin ? Four::abscissa() : Eight::abscissa();
  const auto& weights = is_pin ? Four::weights() : Eight::weights();
  std::vector<Node> nodes;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double middle = (ends[i] + ends[i - 1]) / 2;
    const double half = (ends[i] - ends[i - 1]) / 2;
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (const double side : {-half, half}) {
        nodes.push_back({middle + side * places[k], half * weights[k]});
      }
    }
  }
  return nodes;
}

}  // namespace contact
