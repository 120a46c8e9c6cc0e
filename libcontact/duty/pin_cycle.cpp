#include "libcontact/duty/pin_cycle.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/duty/over_cycle.hpp"
#include "libcontact/duty/periodic_spline.hpp"

namespace contact {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

PinCycle::Instant checked(PinCycle::Instant instant) {
  if (instant.solution.contact.status == Status::ok) return instant;
  throw Error(detail::must_be(
      detail::message("the reaction at {:.6g} s, {:.6g} N", instant.time,
                      instant.state.reaction.head<2>().norm()),
      "one under which the pin that ends has a contact"));
}

}  // namespace

PinCycle::Lies PinCycle::loaded_at(double place) {
  return [place](const DutyCycle::State& /*state*/, double /*time*/) {
    return Lie{.place = place};
  };
}

PinCycle::Lies PinCycle::tilted_with_load(const Vector2d& tilt) {
  return [tilt](const DutyCycle::State& state, double /*time*/) {
    const Vector2d force = state.reaction.head<2>();
    if (force.isZero(0)) return Lie{.tilt = tilt};
    const Vector2d x = force.stableNormalized();
    return Lie{.tilt = tilt.x() * x + tilt.y() * Vector2d(-x.y(), x.x())};
  };
}

PinCycle::Lies PinCycle::tilted(const std::vector<double>& times, double period,
                                const std::vector<Vector2d>& tilts) {
  std::vector<Vector3d> values;
  for (const Vector2d& tilt : tilts) values.emplace_back(tilt.x(), tilt.y(), 0);
  const auto spline =
      std::make_shared<const PeriodicSpline>(times, period, values);
  return [spline](const DutyCycle::State& /*state*/, double time) {
    return Lie{.tilt = spline->value(time).head<2>()};
  };
}

PinCycle::Lies PinCycle::loaded(const std::vector<double>& times, double period,
                                const std::vector<double>& places) {
  std::vector<Vector3d> values;
  for (const double place : places) values.emplace_back(place, 0, 0);
  const auto spline =
      std::make_shared<const PeriodicSpline>(times, period, values);
  return [spline](const DutyCycle::State& /*state*/, double time) {
    return Lie{.place = spline->value(time).x()};
  };
}

PinCycle::PinCycle(DutyCycle cycle, const JointSpec& joint, Lies lies)
    : cycle_(std::move(cycle)), pin_(joint), lies_(std::move(lies)) {
  rows_.reserve(cycle_.times().size());
  for (const double time : cycle_.times()) rows_.push_back(checked(at(time)));
  const auto points = cycle_.gauss_points(true);
  gauss_points_.reserve(points.size());
  for (const auto& [time, weight] : points) {
    gauss_points_.push_back(checked(at(time)));
    gauss_points_.back().weight = weight;
  }
}

PinCycle::Instant PinCycle::at(double time) const noexcept {
  Instant instant{time, 0, cycle_.at(time), {}, 0};
  const DutyCycle::State& state = instant.state;
  const FinitePin::Motion motion{state.angular_velocity.z()};
  const Vector2d reaction = state.reaction.head<2>();
  const Lie lie = lies_(state, time);
  instant.solution = lie.place ? pin_.solve_at(reaction, *lie.place, motion)
                               : pin_.solve(reaction, lie.tilt, motion);
  instant.slip_speed = pin_.slip_speed(motion);
  return instant;
}

double PinCycle::integral(const Quantity& quantity) const {
  return detail::integral_of(gauss_points_, quantity);
}

PinCycle::Instant PinCycle::largest(const Quantity& quantity) const {
  return detail::largest_of(
      rows_, cycle_.period(), [this](double time) { return at(time); },
      quantity);
}

PinCycle::Instant PinCycle::largest_pv() const {
  return largest([](const Instant& i) { return i.largest_pv(); });
}

PinCycle::Instant PinCycle::largest_peak() const {
  return largest(
      [](const Instant& i) { return i.solution.contact.peak_pressure; });
}

PinCycle::Instant PinCycle::largest_half_angle() const {
  return largest(
      [](const Instant& i) { return i.solution.contact.largest_half_angle; });
}

LargestContact PinCycle::largest_contact() const {
  LargestContact all;
  all.add(largest_half_angle().solution.contact.largest());
  all.add(largest_peak().solution.contact.largest());
  return all;
}

PinCycle::Along PinCycle::along(double z) const {
  Along found{0, std::numeric_limits<double>::quiet_NaN(), 0, 0};
  for (const auto* points : {&rows_, &gauss_points_}) {
    for (const Instant& i : *points) {
      const FinitePin::Slice s = pin_.slice(i.solution.contact, z);
      if (!(s.force > 0)) continue;
      const double pv = s.peak * i.slip_speed;
      if (pv > found.largest_pv) {
        found.largest_pv = pv;
        found.time = i.time;
      }
      found.mean_pv += i.weight * pv / cycle_.period();
      found.pv_per_length += i.weight * i.slip_speed * s.force * s.force_ratio;
    }
  }
  return found;
}

std::vector<double> PinCycle::pv_integrals(JointBody body, double z,
                                           int count) const {
  const auto size = static_cast<std::size_t>(count);
  std::vector<double> sums(size), theta(size), p(size);
  for (const Instant& i : gauss_points_) {
    if (!(i.slip_speed > 0)) continue;
    const double turn = body == JointBody::body
                            ? 2 * std::atan2(i.state.turn.z(), i.state.turn.w())
                            : 0;
    for (std::size_t k = 0; k < size; ++k) {
      theta[k] = 2 * pi * static_cast<double>(k) / count - pi + turn;
    }
    pin_.pressures(i.solution.contact, z, theta, p);
    for (std::size_t k = 0; k < size; ++k) {
      sums[k] += i.weight * i.slip_speed * p[k];
    }
  }
  return sums;
}

}  // namespace contact
