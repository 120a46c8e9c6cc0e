#include "libcontact/tracking/joint_follower.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/friction/exact.hpp"
#include "libcontact/friction/kernel/cap_kernel.hpp"
#include "libcontact/friction/kernel/exact_call.hpp"
#include "libcontact/pressure/cosine.hpp"
#include "libcontact/tracking/follower_kernel.hpp"

namespace contact {
namespace {

using detail::FollowerRows;
using Eigen::Vector3d;
using Row = detail::FollowerRow;

// See follower_kernel_impl.hpp.
constexpr double smallest = 1e-150;

// The worst of 200 random joints on paths of steps of 1e-3 was wrong by 4 times
// what the misses of its slopes say.
constexpr double error_safety = 5;

// Coefficients of the window's polynomial through these values at its nodes.
using Window = std::array<double, detail::FollowerWindow::size>;
Window window_through(Window values) {
  constexpr auto& nodes = detail::FollowerWindow::nodes;
  constexpr int size = detail::FollowerWindow::size;
  // Newton's divided differences, then his form multiplied out.
  for (int k = 1; k < size; ++k) {
    for (int i = size - 1; i >= k; --i) {
      values[i] = (values[i] - values[i - 1]) / (nodes[i] - nodes[i - k]);
    }
  }
  for (int k = size - 2; k >= 0; --k) {
    for (int i = k; i < size - 1; ++i) values[i] -= nodes[k] * values[i + 1];
  }
  return values;
}

}  // namespace

JointFollower::JointFollower(std::vector<JointContact> contacts)
    : JointFollower(std::move(contacts), best_instruction_set()) {}

JointFollower::JointFollower(std::vector<JointContact> contacts,
                             InstructionSet set)
    : contacts_(std::move(contacts)),
      kernel_(&detail::follower_kernel(set, size())),
      integrals_(&detail::cap_kernel(set)),
      row_count_(FollowerRows::count),
      numbers_((contacts_.size() + lanes - 1) / lanes * row_count_),
      smooth_(contacts_.size()),
      chosen_((contacts_.size() + lanes - 1) / lanes) {
  static_assert(lanes == FollowerRows::lanes);
  static_assert(lanes == detail::CapKernel::few_points);
  static_assert(reaction_row == static_cast<int>(Row::reaction_x));
  static_assert(rate_row == static_cast<int>(Row::rate_x));
  static_assert(moment_row == static_cast<int>(Row::moment_x));
  static_assert(acting_row == static_cast<int>(Row::acting_x));
  static_assert(action_row == static_cast<int>(Row::action_x));
  static_assert(followed_row == static_cast<int>(Row::followed));
  // Numbers that lanes without a joint can reckon with, where they do not act.
  for (LaneRow& row : numbers_) std::ranges::fill(row.of, 1.0);
  const FollowerRows rows = all_rows();
  const auto places = static_cast<int>(numbers_.size() / row_count_) * lanes;
  for (int i = 0; i < places; ++i) {
    forget(i);
    for (const Row row : {Row::action_x, Row::action_y, Row::action_z,
                          Row::feedback, Row::plain}) {
      rows(row, i) = 0;
    }
  }
  for (int i = 0; i < size(); ++i) {
    const JointContact& contact = contacts_[i];
    rows(Row::radius, i) = contact.geometry().radius();
    rows(Row::side, i) =
        contact.geometry().inner_body() == JointBody::carrier ? 1 : -1;
    rows(Row::ball, i) = contact.geometry().kind() == JointKind::ball;
    rows(Row::viscous, i) = contact.is_viscous();
    strengths_.push_back(contact.strength(1));
    rows(Row::pressure_part, i) = strengths_.back().pressure_part;
    rows(Row::area_part, i) = strengths_.back().area_part;
    rows(Row::plain, i) =
        contact.geometry().kind() == JointKind::ball && !contact.is_viscous() &&
        dynamic_cast<const CosinePressure*>(&contact.pressure_law());
    any_plain_ = any_plain_ || rows(Row::plain, i) != 0;
  }
}

JointFollower::Values JointFollower::values(
    int joint, double force, SlipAxis axis,
    const FrictionIntegrals& i) const noexcept {
  const double pressure = strengths_[joint].pressure_part;
  const double area = strengths_[joint].area_part / force;
  const double over_cosine = 1 / axis.cos;
  return {
      (pressure * i.coefficient.force + area * i.area.force) * over_cosine,
      (pressure * i.coefficient.sliding + area * i.area.sliding) * over_cosine,
      (pressure * i.coefficient.spinning + area * i.area.spinning) / axis.sin};
}

JointFollower::Values JointFollower::values(int joint, double force,
                                            SlipAxis axis) const noexcept {
  const JointContact& contact = contacts_[joint];
  const bool plain = all_rows()(Row::plain, joint) != 0;
  const SlipAxis inside = {std::max(axis.sin, smallest),
                           std::max(axis.cos, smallest)};
  const double half_angle = contact.half_angle(force).half_angle;
  return values(joint, force, inside,
                plain ? detail::exact_point(
                            *integrals_,
                            detail::prepare(half_angle, inside.sin, inside.cos))
                      : contact.integrals(half_angle, inside));
}

void JointFollower::take(int joint, const Values& found) noexcept {
  const FollowerRows rows = all_rows();
  rows(Row::found_friction, joint) = found.friction;
  rows(Row::found_sliding, joint) = found.sliding;
  rows(Row::found_spinning, joint) = found.spinning;
}

// @return whether it tells the law's values
bool JointFollower::set_window(int joint, double force) noexcept {
  using detail::FollowerWindow;
  constexpr int size = FollowerWindow::size;
  const FollowerRows rows = all_rows();
  const bool ball = rows(Row::ball, joint) != 0;
  const double width = FollowerWindow::half_width * force;
  const auto at = [&](double place) -> std::array<double, 2> {
    const double there = force + place * width;
    if (ball) {
      const double half_angle = contacts_[joint].half_angle(there).half_angle;
      return {std::sin(half_angle), std::cos(half_angle)};
    }
    const Values found = values(joint, there, {0, 1});
    return {found.friction, found.sliding};
  };
  std::array<Window, 2> window;
  for (int i = 0; i < size; ++i) {
    const auto values = at(FollowerWindow::nodes[i]);
    for (int f = 0; f < 2; ++f) window[f][i] = values[f];
  }
  for (Window& w : window) w = window_through(w);
  // A law need not be smooth. A cosine may be near 0.
  constexpr double tolerance = 2e-14;
  for (const double place : {-0.95, 0.0, 0.86}) {
    const auto expected = at(place);
    for (int f = 0; f < 2; ++f) {
      double sum = 0;
      for (int k = size - 1; k >= 0; --k) sum = sum * place + window[f][k];
      const double scale = ball && f == 1 ? 1 : std::abs(expected[f]);
      if (!(std::abs(sum - expected[f]) <= tolerance * scale)) return false;
    }
  }
  rows(Row::window_middle, joint) = force;
  rows(Row::window_scale, joint) = 1 / width;
  for (int k = 0; k < size; ++k) {
    rows(static_cast<Row>(static_cast<int>(Row::window_1) + k), joint) =
        window[0][k];
    rows(static_cast<Row>(static_cast<int>(Row::window_2) + k), joint) =
        window[1][k];
  }
  return true;
}

// What the window does not know: what depends on R_n alone, outside; friction
// of balls that are not plain.
void JointFollower::evaluate_contact(int joint) noexcept {
  const FollowerRows rows = all_rows();
  const double force = rows(Row::evaluated_force, joint);
  const bool inside = std::abs(rows(Row::window_place, joint)) <= 1;
  const bool ball = rows(Row::ball, joint) != 0;
  if (inside && !ball) return;
  double& sine = rows(Row::half_angle_sin, joint);
  double& cosine = rows(Row::half_angle_cos, joint);
  if (!inside) {
    const double half_angle = contacts_[joint].half_angle(force).half_angle;
    sine = std::sin(half_angle);
    cosine = std::cos(half_angle);
    // Worth it if some evaluations stay within.
    constexpr double slow = 0.1 * detail::FollowerWindow::half_width;
    if (smooth_[joint] &&
        std::abs(force * rows(Row::last_inverse_force, joint) - 1) < slow) {
      smooth_[joint] = set_window(joint, force);
    }
  }
  if (rows(Row::plain, joint) != 0) return;
  const SlipAxis axis = {rows(Row::evaluated_axis_sine, joint),
                         rows(Row::evaluated_axis_cosine, joint)};
  const double half_angle = std::atan2(sine, cosine);
  take(joint, values(joint, force, axis,
                     contacts_[joint].integrals(half_angle, axis)));
}

void JointFollower::start(int joint, const JointSolution& solution,
                          const Vector3d& rate) noexcept {
  forget(joint);
  if (solution.status != Status::ok || solution.state != JointState::sliding) {
    return;
  }
  const FollowerRows rows = all_rows();
  const auto put = [&](Row row, double value) { rows(row, joint) = value; };
  const double force = solution.normal_force;
  const SlipAxis axis = {std::abs(solution.slip_axis.sin),
                         solution.slip_axis.cos};
  const Values here = values(joint, force, axis);
  const bool ball = rows(Row::ball, joint) != 0;
  put(Row::last_inverse_reaction, 1 / solution.memory.reaction_force);
  put(Row::last_sine, solution.memory.reaction.sin);
  put(Row::last_cosine, ball ? solution.memory.reaction.cos : 0);
  const double speed = rows(Row::viscous, joint) != 0 ? rate.norm() : 1;
  put(Row::last_tangent, solution.memory.tangent);
  put(Row::last_residual,
      std::log(solution.memory.tangent / (here.friction * speed)));
  put(Row::last_inverse_force, 1 / force);
  put(Row::last_inverse_axis_cosine, 1 / axis.cos);
  put(Row::last_speed, speed);
  put(Row::friction, here.friction);
  put(Row::sliding, here.sliding);
  put(Row::spinning, here.spinning);

  // Slopes by differences: balances rounding (4e-15/h) against curvature (h).
  constexpr double h = 1e-6;
  const Values pressed = values(joint, force * (1 + h), axis);
  const Values turned =
      ball ? values(joint, force,
                    {std::hypot(axis.sin, axis.cos * std::sqrt(h * (2 - h))),
                     axis.cos * (1 - h)})
           : here;
  const auto slopes = [&](Row by_force, Row by_cosine, double Values::*value) {
    const auto growth = [&](const Values& there) {
      return here.*value > 0 ? std::log(there.*value / here.*value) : 0;
    };
    put(by_force, growth(pressed) / std::log1p(h));
    put(by_cosine, growth(turned) / (2 * std::log1p(-h)));
  };
  slopes(Row::friction_by_force, Row::friction_by_cosine, &Values::friction);
  slopes(Row::sliding_by_force, Row::sliding_by_cosine, &Values::sliding);
  slopes(Row::spinning_by_force, Row::spinning_by_cosine, &Values::spinning);
  put(Row::tangent_by_along, solution.memory.force_response);
  put(Row::tangent_by_tilt, solution.memory.angle_response);
  put(Row::inverse_slope, 1 / solution.memory.residual_slope);
  for (const Row row :
       {Row::way_force, Row::way_cosine, Row::way_length, Row::friction_curve,
        Row::sliding_curve, Row::spinning_curve}) {
    put(row, 0);
  }
  for (int k = 0; k < 9; ++k) {
    put(static_cast<Row>(static_cast<int>(Row::answer_xx) + k), 0);
  }
  // None yet: nothing is within.
  put(Row::window_scale, std::numeric_limits<double>::quiet_NaN());
  smooth_[joint] = true;
  // Not known yet.
  put(Row::slope_error, 1);
  put(Row::followed, 1);
}

detail::FollowerRows JointFollower::all_rows() const noexcept {
  return FollowerRows(
      reinterpret_cast<double*>(const_cast<LaneRow*>(numbers_.data())));
}

// f(rows, first joint, number of joints) of all packets that are chosen; f
// tells the largest numbers of its joints.
template <class F>
void JointFollower::for_chosen(F f) noexcept {
  if (all_chosen_) {
    set_largest(f(all_rows(), 0, size()));
    return;
  }
  for (int first = 0; first < size(); first += lanes) {
    if (!chosen_[static_cast<std::size_t>(first / lanes)]) continue;
    f(FollowerRows(all_rows().at(static_cast<Row>(0), first)), first,
      std::min(lanes, size() - first));
  }
  set_largest(kernel_->largest(all_rows(), size(), moment_floor_));
}

void JointFollower::choose_all() noexcept {
  all_chosen_ = true;
  std::ranges::fill(chosen_, false);
}

void JointFollower::choose(int joint) noexcept {
  all_chosen_ = false;
  chosen_[static_cast<std::size_t>(joint / lanes)] = true;
}

void JointFollower::choose_worse_than(double limit) noexcept {
  all_chosen_ = false;
  for (int i = 0; i < size(); ++i) {
    if (follows(i) && !(error(i) <= limit)) choose(i);
  }
}

void JointFollower::predict() noexcept {
  for_chosen([&](FollowerRows rows, int, int count) {
    return kernel_->predict(rows, count, moment_floor_);
  });
}

void JointFollower::extend() noexcept {
  set_largest(kernel_->extend(all_rows(), size(), moment_floor_));
}

void JointFollower::evaluate() noexcept {
  if (!all_chosen_) extend();
  for_chosen([&](FollowerRows rows, int first, int count) {
    if (kernel_->approach(rows, count)) {
      for (int i = 0; i < count; ++i) {
        if (follows(first + i)) evaluate_contact(first + i);
      }
    }
    for (int i = 0; any_plain_ && i < count; i += lanes) {
      const auto at = [&](Row row) { return rows.at(row, i); };
      integrals_->few(at(Row::half_angle_sin), at(Row::half_angle_cos),
                      at(Row::evaluated_axis_sine),
                      at(Row::evaluated_axis_cosine), at(Row::plain),
                      std::min(lanes, count - i), at(Row::integral_force));
    }
    return kernel_->settle(rows, count, moment_floor_);
  });
}

bool JointFollower::tracks(int joint) const noexcept {
  return follows(joint) && all_rows()(Row::reach, joint) < 1;
}

double JointFollower::error(int joint) const noexcept {
  return error_safety * all_rows()(Row::error, joint);
}

void JointFollower::set_largest(const detail::FollowerLargest& found) noexcept {
  largest_ = {found.reach < 1,
              found.shift,
              error_safety * found.error,
              std::sqrt(found.miss),
              0,
              0,
              0};
  if (found.moved == 0) return;
  largest_.moved = std::sqrt(found.moved);
  largest_.contraction = std::sqrt(found.answered / found.moved);
  largest_.gain = largest_.miss / largest_.moved;
}

void JointFollower::remember() noexcept {
  kernel_->remember(all_rows(), size());
}

void JointFollower::extrapolate(double share) noexcept {
  kernel_->extrapolate(all_rows(), size(), share);
}

void JointFollower::set_feedback(int joint, double s) noexcept {
  all_rows()(Row::feedback, joint) = s;
}

void JointFollower::act() noexcept { kernel_->act(all_rows(), size()); }

}  // namespace contact
