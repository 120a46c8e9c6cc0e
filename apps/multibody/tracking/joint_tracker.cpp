#include "multibody/tracking/joint_tracker.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/instruction_set.hpp"
#include "libcontact/friction/kernel/cap_kernel.hpp"
#include "libcontact/pressure/expansion.hpp"
#include "multibody/tracking/tracker_kernel.hpp"
#include "multibody/tracking/tracker_state.hpp"

namespace multibody {
namespace {

using contact::Error;
using contact::FrictionIntegrals;
using contact::JointBody;
using contact::JointGeometry;
using contact::JointKind;
using contact::JointState;
using contact::Status;
using Eigen::Vector3d;
using State = detail::TrackerState<double>;
using Window = detail::Window<double>;
using StateNumbers = std::array<double, sizeof(State) / sizeof(double)>;

}  // namespace

JointTracker::JointTracker(std::vector<JointContact> contacts)
    : contacts_(std::make_shared<const std::vector<JointContact>>(
          std::move(contacts))),
      kernel_(&detail::tracker_kernel(contact::instruction_set(), size())),
      integrals_(&contact::detail::cap_kernel(contact::instruction_set())),
      exchange_(packet(size() + Exchange::size - 1)),
      states_(exchange_.size() * std::tuple_size_v<StateNumbers>),
      is_plain_(contacts_->size()),
      is_smooth_(contacts_->size()) {
  static_assert(Exchange::size == contact::detail::CapKernel::few_points);
  for (int i = 0; i < size(); ++i) {
    const JointContact& contact = this->contact(i);
    if (contact.stress()) {
      throw Error(contact::detail::must_be(
          "friction of a joint that is tracked", "dry or viscous"));
    }
    const JointGeometry& geometry = contact.geometry();
    if (geometry.seat()) {
      throw Error(contact::detail::must_be(
          "the seat of a joint that is tracked", "without end"));
    }
    const JointContact::Strength strength = contact.strength(1);
    State s = state(i);
    s.radius = geometry.radius();
    s.side = geometry.side();
    s.is_ball = geometry.kind() == JointKind::ball;
    s.is_viscous = contact.is_viscous();
    is_plain_[i] =
        s.is_ball != 0 && !contact.is_viscous() &&
        contact::detail::expansion_form(contact.pressure_law()).is_cosine();
    s.is_plain = is_plain_[i];
    s.pressure_part = strength.pressure_part;
    s.area_part = strength.area_part;
    set_state(i, s);
    any_plain_ = any_plain_ || is_plain_[i];
  }
}

// The numbers of as many joints as the kernel has lanes, then the numbers of
// the next joints.
double* JointTracker::numbers_of(int joint) noexcept {
  const auto lanes = static_cast<std::size_t>(kernel_->lanes);
  const auto i = static_cast<std::size_t>(joint);
  return reinterpret_cast<double*>(states_.data()) +
         i / lanes * std::tuple_size_v<StateNumbers> * lanes + i % lanes;
}

State JointTracker::state(int joint) noexcept {
  StateNumbers numbers;
  const double* from = numbers_of(joint);
  for (std::size_t k = 0; k < numbers.size(); ++k, from += kernel_->lanes) {
    numbers[k] = *from;
  }
  return std::bit_cast<State>(numbers);
}

void JointTracker::set_state(int joint, const State& state) noexcept {
  const auto numbers = std::bit_cast<StateNumbers>(state);
  double* to = numbers_of(joint);
  for (std::size_t k = 0; k < numbers.size(); ++k, to += kernel_->lanes) {
    *to = numbers[k];
  }
}

detail::TrackerJoints JointTracker::joints() noexcept {
  return {size(), exchange_.data(), states_.data(), moment_floor_};
}

JointTracker::Values JointTracker::values(int joint, double force,
                                          SlipAxis axis,
                                          double half_angle) const noexcept {
  const JointContact& contact = this->contact(joint);
  const JointContact::Strength strength = contact.strength(1);
  axis = {std::max(axis.sin, detail::smallest_axis),
          std::max(axis.cos, detail::smallest_axis)};
  const FrictionIntegrals i = contact.integrals(half_angle, axis, {force, 1});
  const auto value = [&](double pressure, double area, double over) {
    return (strength.pressure_part * pressure +
            strength.area_part / force * area) /
           over;
  };
  return {value(i.coefficient.force, i.area.force, axis.cos),
          value(i.coefficient.sliding, i.area.sliding, axis.cos),
          value(i.coefficient.spinning, i.area.spinning, axis.sin)};
}

// Tabulates sin theta0 and cos theta0 of a ball, friction and sliding of a pin.
// @return whether the window tells the law's values: it need not be smooth
bool JointTracker::set_window(int joint, double force,
                              State& state) const noexcept {
  const bool ball = state.is_ball != 0;
  const double width = detail::trust_radius * force;
  const auto at = [&](double place) -> std::pair<double, double> {
    const double there = force + place * width;
    const double half_angle = contact(joint).half_angle(there).half_angle;
    if (ball) return {std::sin(half_angle), std::cos(half_angle)};
    const Values found = values(joint, there, {0, 1}, half_angle);
    return {found.friction, found.sliding};
  };
  Window w = {force, 1 / width, {}, {}};
  for (int i = 0; i < Window::size; ++i) {
    std::tie(w.first[i], w.second[i]) = at(Window::nodes[i]);
  }
  for (double* const f : {w.first, w.second}) {
    for (int k = 1; k < Window::size; ++k) {
      for (int i = Window::size - 1; i >= k; --i) {
        f[i] = (f[i] - f[i - 1]) / (Window::nodes[i] - Window::nodes[i - k]);
      }
    }
  }
  // Moments of all laws come out right to 2e-15 by windows (tested). A cosine
  // may be near 0.
  constexpr double tolerance = 2e-14;
  for (const double place : {-0.95, 0.0, 0.86}) {
    const auto [first, second] = at(place);
    const double second_scale = ball ? 1 : std::abs(second);
    if (!(std::abs(w.value(w.first, place) - first) <=
          tolerance * std::abs(first)) ||
        !(std::abs(w.value(w.second, place) - second) <=
          tolerance * second_scale)) {
      return false;
    }
  }
  state.window = w;
  return true;
}

// Evaluates what the window lacks: functions of R_n alone outside it; friction
// of balls that are not plain.
void JointTracker::evaluate_contact(int joint) noexcept {
  const double force = at(&Exchange::force, joint);
  double& sine = at(&Exchange::half_angle_sin, joint);
  double& cosine = at(&Exchange::half_angle_cos, joint);
  if (at(&Exchange::outside, joint) != 0) {
    const double half_angle = contact(joint).half_angle(force).half_angle;
    sine = std::sin(half_angle);
    cosine = std::cos(half_angle);
    // Its 15 evaluations are worth it if some contacts stay within.
    State s = state(joint);
    if (is_smooth_[joint] && std::abs(force * s.inverse_force - 1) < 0.01) {
      is_smooth_[joint] = set_window(joint, force, s);
      set_state(joint, s);
    }
  }
  if (is_plain_[joint]) return;
  const Values found =
      values(joint, force,
             {at(&Exchange::axis_sin, joint), at(&Exchange::axis_cos, joint)},
             std::atan2(sine, cosine));
  at(&Exchange::friction, joint) = found.friction;
  at(&Exchange::sliding, joint) = found.sliding;
  at(&Exchange::spinning, joint) = found.spinning;
}

void JointTracker::start(int joint, const JointSolution& solution,
                         const Vector3d& rate) noexcept {
  stop(joint);
  if (solution.status != Status::ok || solution.state != JointState::sliding) {
    return;
  }
  // Sliding under interference alone: logarithms of R_n have no value.
  if (solution.normal_force == 0) return;
  State s = state(joint);
  const bool ball = s.is_ball != 0;
  const double force = solution.normal_force;
  const SlipAxis axis = {std::abs(solution.slip_axis.sin),
                         solution.slip_axis.cos};
  const auto values_at = [&](double at_force, SlipAxis at_axis) {
    return values(joint, at_force, at_axis,
                  contact(joint).half_angle(at_force).half_angle);
  };
  // Slopes by differences: balances rounding (4e-15/h) against curvature (h).
  constexpr double h = 1e-6;
  const Values here = values_at(force, axis);
  const Values pressed = values_at(force * (1 + h), axis);
  const Values turned =
      ball ? values_at(force,
                       {std::hypot(axis.sin, axis.cos * std::sqrt(h * (2 - h))),
                        axis.cos * (1 - h)})
           : here;
  const auto secants = [&](double Values::*value) -> detail::Secants<double> {
    const auto growth = [&](const Values& there) {
      return here.*value > 0 ? std::log(there.*value / here.*value) : 0;
    };
    return {here.*value, growth(pressed) / std::log1p(h),
            growth(turned) / (2 * std::log1p(-h)), 0};
  };
  s.friction = secants(&Values::friction);
  s.sliding = secants(&Values::sliding);
  s.spinning = secants(&Values::spinning);
  s.inverse_force = 1 / force;
  s.inverse_axis_cosine = 1 / axis.cos;
  s.last_move = {0, 0};
  s.inverse_square = 0;
  s.slope_error = 1;  // not known yet
  s.is_known = 0;
  s.window.inverse_half_width = std::numeric_limits<double>::quiet_NaN();
  is_smooth_[joint] = true;

  const JointSolution::Memory& memory = solution.memory;
  s.last_inverse_reaction = 1 / memory.reaction_force;
  s.last_sine = memory.reaction.sin;
  s.last_cosine = ball ? memory.reaction.cos : 0;
  s.last_speed = s.is_viscous != 0 ? rate.norm() : 1;
  s.last_tangent = memory.tangent;
  s.last_residual = std::log(memory.tangent / (here.friction * s.last_speed));
  s.tangent_by_reaction = memory.force_response;
  s.tangent_by_angle = memory.angle_response;
  s.slip.inverse_slope = 1 / memory.residual_slope;
  set_state(joint, s);
  at(&Exchange::tracked, joint) = 1;
}

void JointTracker::predict(double enough) noexcept {
  largest_ = kernel_->predict(joints(), enough);
}

void JointTracker::extend() noexcept { largest_ = kernel_->extend(joints()); }

void JointTracker::correct() noexcept {
  const double uncorrected = kernel_->prepare(joints()).residual;
  for (int i = 0; i < size(); ++i) {
    if (at(&Exchange::asked, i) != 0) evaluate_contact(i);
  }
  for (int i = 0; any_plain_ && i < size(); i += Exchange::size) {
    Exchange& e = exchange_[packet(i)];
    integrals_->few(e.half_angle_sin, e.half_angle_cos, e.axis_sin, e.axis_cos,
                    e.exact, std::min(Exchange::size, size() - i),
                    e.integrals[0]);
  }
  largest_ = kernel_->correct(joints());
  largest_.uncorrected = uncorrected;
}

void JointTracker::apply() noexcept { kernel_->step(joints()); }

void JointTracker::keep() noexcept { kernel_->keep(joints()); }

void JointTracker::extrapolate(double share) noexcept {
  kernel_->extrapolate(joints(), share);
}

}  // namespace multibody
