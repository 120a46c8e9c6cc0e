#include "libcontact/duty/duty_cycle.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/duty/periodic_spline.hpp"

namespace contact {
namespace {

using detail::pi;

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond turn_by(const Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Quaterniond::Identity();
  return Quaterniond(AngleAxisd(angle, vector / angle));
}

struct Least {
  double time;
  double step;  // length of the interval around it
};

// Minima of a function of period `period`, cubics squared between `times`.
template <class Function>
std::vector<Least> least_values(const Function& function,
                                const std::vector<double>& times,
                                double period) {
  // Fine enough for the three roots that a cubic may have.
  constexpr std::size_t parts = 8;
  const std::size_t size = parts * times.size();
  const auto time = [&](std::size_t i) {
    const std::size_t row = i / parts;
    const double from = row < times.size() ? times[row] : times[0] + period;
    const double to =
        row + 1 < times.size() ? times[row + 1] : times[0] + period;
    return from + static_cast<double>(i % parts) / parts * (to - from);
  };
  std::vector<Least> found;
  double before = time(size - 1) - period;
  double at_before = function(before);
  double at_here = function(time(0));
  for (std::size_t i = 0; i < size; ++i) {
    const double here = time(i);
    const double after = time(i + 1);
    const double at_after = function(after);
    if (at_before > at_here && at_here <= at_after) {
      const double span = after - here;
      // Half the digits of a double: a minimum has no more.
      const double u = boost::math::tools::brent_find_minima(
                           [&](double x) { return function(here + span * x); },
                           (before - here) / span, 1.0, 26)
                           .first;
      found.push_back({here + span * u, span * parts});
    }
    before = here;
    at_before = std::exchange(at_here, at_after);
  }
  return found;
}

}  // namespace

DutyCycle::TurnSequence::TurnSequence(std::string_view axes) {
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

Quaterniond DutyCycle::TurnSequence::turn(const Vector3d& angles) const {
  Quaterniond turn = Quaterniond::Identity();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    turn = turn * AngleAxisd(angles[static_cast<int>(i)], axes_[i]);
  }
  return turn;
}

Vector3d DutyCycle::TurnSequence::angular_velocity(
    const Vector3d& angles, const Vector3d& angle_rates) const {
  Quaterniond turn = Quaterniond::Identity();
  Vector3d rate = Vector3d::Zero();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const int k = static_cast<int>(i);
    rate += angle_rates[k] * (turn * axes_[i]);
    turn = turn * AngleAxisd(angles[k], axes_[i]);
  }
  return rate;
}

// Splines of forces, and of angles or angular velocities.
struct DutyCycle::Splines {
  PeriodicSpline forces;
  PeriodicSpline motion;

  explicit Splines(const Rows& rows)
      : forces(rows.times, rows.period.value_or(0), rows.forces),
        motion(rows.times, rows.period.value_or(0), rows.motion) {}
};

DutyCycle::DutyCycle(const Rows& rows, ForceFrame frame, TurnSequence sequence)
    : splines_(std::make_shared<const Splines>(rows)),
      frame_(frame),
      sequence_(std::move(sequence)) {
  const std::size_t count = rows.times.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const double jump =
        (rows.motion[next] - rows.motion[i]).cwiseAbs().maxCoeff();
    if (!(jump > pi)) continue;
    throw Error(detail::must_be(
        detail::message("change of angles of {:.4g} deg from {:g} s to {:g} s",
                        jump / degree, rows.times[i], rows.times[next]),
        "at most 180 deg: angles go on without a jump after a turn, and whole "
        "turns in a period need angular velocities"));
  }
}

DutyCycle::DutyCycle(const Rows& rows, ForceFrame frame)
    : splines_(std::make_shared<const Splines>(rows.filled())), frame_(frame) {
  Quaterniond turn = Quaterniond::Identity();
  for (std::size_t i = 0; i < times().size(); ++i) {
    turns_.push_back(turn);
    const double next =
        i + 1 < times().size() ? times()[i + 1] : times()[0] + period();
    turn = turned(turn, times()[i], next);
  }
  closure_ = turn.angularDistance(turns_.front());
}

const std::vector<double>& DutyCycle::times() const {
  return splines_->motion.times();
}

double DutyCycle::period() const { return splines_->motion.period(); }

namespace {

// How far a spline goes beyond its rows, over their range.
double overshoot(const PeriodicSpline& spline) {
  constexpr int parts = 16;
  const std::vector<double>& times = spline.times();
  Eigen::Array3d low = spline.value(times[0]);
  Eigen::Array3d high = low;
  Eigen::Array3d lowest = low;
  Eigen::Array3d highest = low;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double next =
        i + 1 < times.size() ? times[i + 1] : times[0] + spline.period();
    for (int k = 0; k < parts; ++k) {
      const Eigen::Array3d value =
          spline.value(times[i] + k * (next - times[i]) / parts);
      lowest = lowest.min(value);
      highest = highest.max(value);
      if (k > 0) continue;
      low = low.min(value);
      high = high.max(value);
    }
  }
  const double range = (high - low).maxCoeff();
  const double beyond = (low - lowest).max(highest - high).maxCoeff();
  return range > 0 ? beyond / range : 0;
}

// On angles that may be degrees which were taken for radians, or "".
std::string angles_note(const PeriodicSpline& spline) {
  constexpr double furthest = 2 * std::numbers::pi * (1 + 1e-9);
  constexpr double longest = 1;  // from row to row
  double largest = 0;
  double step = 0;
  Eigen::Array3d before = spline.value(spline.times()[0]);
  for (const double time : spline.times()) {
    const Eigen::Array3d angles = spline.value(time);
    largest = std::max(largest, angles.abs().maxCoeff());
    step = std::max(step, (angles - before).abs().maxCoeff());
    before = angles;
  }
  if (!(largest > furthest || step > longest)) return {};
  return detail::message(
      "the angles reach {:.4g} rad and change by up to {:.3g} rad from row to "
      "row: are these degrees read as radians, or too few rows?",
      largest, step);
}

}  // namespace

std::vector<std::string> DutyCycle::notes(bool is_pin) const {
  std::vector<std::string> notes;
  const auto add_overshoot = [&](const char* what, const PeriodicSpline& of) {
    constexpr double negligible = 0.01;
    const double beyond = overshoot(of);
    if (!(beyond > negligible)) return;
    notes.push_back(
        detail::message("between the rows the {} exceeds their range by {:.3g} "
                        "%: splines overshoot where rows jump; add rows there",
                        what, 100 * beyond));
  };
  add_overshoot("force", splines_->forces);
  if (sequence_) {
    const std::string note = angles_note(splines_->motion);
    if (!note.empty()) notes.push_back(note);
  }
  add_overshoot(sequence_ ? "angle" : "angular velocity", splines_->motion);
  if (closure_ > 0.1 * degree) {
    notes.push_back(detail::message(
        "the rates turn the body by {:.3g} deg more or less than whole turns: "
        "its wear map and forces in its axes do not belong to a closed cycle",
        closure_ / degree));
  }
  if (!is_pin) return notes;
  double axial = 0;
  for (const double time : times()) {
    axial = std::max(axial, std::abs(at(time).reaction.z()));
  }
  if (axial > 0) {
    notes.push_back(
        detail::message("a pin carries no force along its axis: R_z of up to "
                        "{:.4g} N is ignored",
                        axial));
  }
  return notes;
}

// Q' = [Dw] Q.
Quaterniond DutyCycle::turned(Quaterniond turn, double from, double to) const {
  constexpr int steps = 4;
  const double step = (to - from) / steps;
  const double half_width = step / (2 * std::sqrt(3.0));
  for (int i = 0; i < steps; ++i) {
    const double middle = from + (i + 0.5) * step;
    const Vector3d one = splines_->motion.value(middle - half_width);
    const Vector3d two = splines_->motion.value(middle + half_width);
    turn = turn_by(step / 2 * (one + two) +
                   step * half_width / 2 * two.cross(one)) *
           turn;
  }
  return turn.normalized();
}

DutyCycle::State DutyCycle::at(double time) const {
  State state;
  const Vector3d motion = splines_->motion.value(time);
  state.angular_velocity = angular_velocity(time);
  if (sequence_) {
    state.turn = sequence_->turn(motion);
  } else {
    const double first = times().front();
    const double within =
        time - period() * std::floor((time - first) / period());
    const auto after =
        std::upper_bound(times().begin() + 1, times().end(), within);
    const std::size_t before =
        static_cast<std::size_t>(after - times().begin()) - 1;
    state.turn = turned(turns_[before], times()[before], within);
  }
  state.reaction = splines_->forces.value(time);
  if (frame_.axes == JointBody::body) {
    state.reaction = state.turn * state.reaction;
  }
  if (frame_.on == JointBody::carrier) state.reaction = -state.reaction;
  return state;
}

Vector3d DutyCycle::angular_velocity(double time) const {
  const Vector3d motion = splines_->motion.value(time);
  return sequence_
             ? sequence_->angular_velocity(motion, splines_->motion.slope(time))
             : motion;
}

// Ends of intervals at the least values of |Dw| that are 0 or small. Near one
// that is not 0, |Dw| is like sqrt(d^2 + t^2) and its direction turns in the
// time d: intervals as short as that beside it, each three times as long as the
// one before, leave 1e-10 with eight points.
std::vector<double> DutyCycle::reversals(bool is_pin) const {
  constexpr double growth = 3;
  // A turn in less than this share of an interval is taken for a kink; the
  // error is the square of the share.
  constexpr double kink = 1e-6;
  const auto vector = [&](double time) {
    const Vector3d all = angular_velocity(time);
    return is_pin ? Vector3d(0, 0, all.z()) : all;
  };
  std::vector<double> found;
  for (const auto& [least, step] :
       least_values([&](double time) { return vector(time).squaredNorm(); },
                    times(), period())) {
    const double difference = 1e-4 * step;
    const Vector3d change =
        vector(least + difference) - vector(least - difference);
    const double near = vector(least).norm() * 2 * difference / change.norm();
    if (!(near < step)) continue;  // smooth
    found.push_back(least);
    if (near < kink * step) continue;
    for (double far = near; far < step; far *= growth) {
      found.push_back(least - far);
      found.push_back(least + far);
    }
  }
  for (double& time : found) {
    time -= period() * std::floor((time - times()[0]) / period());
  }
  return found;
}

std::vector<DutyCycle::GaussPoint> DutyCycle::gauss_points(bool is_pin) const {
  std::vector<double> ends = times();
  ends.push_back(times().front() + period());
  const std::size_t count = ends.size();
  const std::vector<double> more = reversals(is_pin);
  ends.insert(ends.end(), more.begin(), more.end());
  // The edge of a pin's contact passes all points of a line at once: a kink in
  // their wear, which finer intervals make up for.
  constexpr int quarters = 4;
  for (std::size_t i = 1; i < count && is_pin; ++i) {
    for (int k = 1; k < quarters; ++k) {
      ends.push_back(ends[i - 1] + k * (ends[i] - ends[i - 1]) / quarters);
    }
  }
  std::sort(ends.begin(), ends.end());
  const detail::GaussLegendre rule(is_pin ? 4 : 8);
  std::vector<GaussPoint> points;
  points.reserve((ends.size() - 1) *
                 static_cast<std::size_t>(rule.node.size()));
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double middle = (ends[i] + ends[i - 1]) / 2;
    const double half = (ends[i] - ends[i - 1]) / 2;
    for (int k = 0; k < rule.node.size(); ++k) {
      points.push_back({middle + half * rule.node(k), half * rule.weight(k)});
    }
  }
  return points;
}

}  // namespace contact
