#include "libcontact/joint_follower.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/detail/follower_kernel.hpp"
#include "libcontact/friction_batch.hpp"
#include "libcontact/friction_exact.hpp"

namespace contact {
namespace {

using detail::FollowerRows;
using Eigen::Vector3d;
using Row = detail::FollowerRow;

// sin a and cos a of contacts are taken at least so large: what is divided by
// them tends to a constant.
constexpr double smallest = 1e-150;

// From here on a batch takes less time (measured).
constexpr int enough_for_batch = 16;

// Lanes that few joints cannot fill cost more than they bring.
InstructionSet useful(std::size_t joints) {
  const InstructionSet best = best_instruction_set();
  return best == InstructionSet::avx512 && joints <= 4 ? InstructionSet::avx2
                                                       : best;
}

FollowerRows rows_of(const std::vector<double>& numbers, std::size_t stride) {
  return {const_cast<double*>(numbers.data()), stride};
}

}  // namespace

JointFollower::JointFollower(std::vector<JointContact> contacts)
    : JointFollower(std::move(contacts), InstructionSet::baseline) {
  set_ = useful(contacts_.size());
}

JointFollower::JointFollower(std::vector<JointContact> contacts,
                             InstructionSet set)
    : contacts_(std::move(contacts)),
      followed_(contacts_.size(), false),
      set_(set),
      stride_((contacts_.size() + FollowerRows::lanes - 1) /
              FollowerRows::lanes * FollowerRows::lanes),
      numbers_(static_cast<std::size_t>(Row::count) * stride_, 1.0),
      batch_joint_(contacts_.size()),
      batch_numbers_(batch_rows * contacts_.size()) {
  const FollowerRows rows = rows_of(numbers_, stride_);
  for (int i = 0; i < size(); ++i) {
    const JointContact& contact = contacts_[i];
    rows[Row::radius][i] = contact.geometry().radius();
    rows[Row::side][i] =
        contact.geometry().inner_body() == JointBody::carrier ? 1 : -1;
    rows[Row::ball][i] = contact.geometry().kind() == JointKind::spherical;
    rows[Row::viscous][i] = contact.is_viscous();
    strengths_.push_back(contact.strength(1));
    plain_.push_back(
        contact.geometry().kind() == JointKind::spherical &&
        !contact.is_viscous() &&
        dynamic_cast<const CosinePressure*>(&contact.pressure_law()));
    plain_count_ += plain_.back();
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
  const SlipAxis inside = {std::max(axis.sin, smallest),
                           std::max(axis.cos, smallest)};
  const double half_angle = contact.half_angle(force).half_angle;
  return values(joint, force, inside,
                plain_[joint] ? exact_friction_integrals(half_angle, inside)
                              : contact.integrals(half_angle, inside));
}

void JointFollower::take(int joint, const Values& found) noexcept {
  const FollowerRows rows = rows_of(numbers_, stride_);
  rows[Row::found_friction][joint] = found.friction;
  rows[Row::found_sliding][joint] = found.sliding;
  rows[Row::found_spinning][joint] = found.spinning;
}

// Those whose friction is that of the exact integrals alone, lanes over joints
// where there are enough of them to fill lanes with like ones.
void JointFollower::evaluate_plain() noexcept {
  const FollowerRows rows = rows_of(numbers_, stride_);
  std::size_t count = 0;
  for (int i = 0; i < size(); ++i) {
    if (!followed_[i] || !plain_[i]) continue;
    batch_joint_[count] = i;
    batch_row(0)[count] =
        contacts_[i].half_angle(rows[Row::evaluated_force][i]).half_angle;
    batch_row(1)[count] = std::max(rows[Row::evaluated_axis_sine][i], smallest);
    batch_row(2)[count] =
        std::max(rows[Row::evaluated_axis_cosine][i], smallest);
    ++count;
  }
  const auto row = [&](int k) { return std::span(batch_row(k), count); };
  FrictionBatchOutput out;
  out.force = row(3);
  out.sliding = row(4);
  out.spinning = row(5);
  out.force_area = row(6);
  out.sliding_area = row(7);
  out.spinning_area = row(8);
  exact_friction_integrals({row(0), row(1), row(2)}, out);
  for (std::size_t k = 0; k < count; ++k) {
    const int i = batch_joint_[k];
    FrictionIntegrals found{};
    found.coefficient = {row(3)[k], row(4)[k], row(5)[k]};
    found.area = {row(6)[k], row(7)[k], row(8)[k]};
    take(i, values(i, rows[Row::evaluated_force][i], {row(1)[k], row(2)[k]},
                   found));
  }
}

void JointFollower::start(int joint, const JointSolution& solution,
                          const Vector3d& rate) noexcept {
  followed_[joint] =
      solution.status == Status::ok && solution.state == JointState::sliding;
  if (!followed_[joint]) return;
  const FollowerRows rows = rows_of(numbers_, stride_);
  const auto put = [&](Row row, double value) { rows[row][joint] = value; };
  const double force = solution.compressive_force;
  const SlipAxis axis = {std::abs(solution.slip_axis.sin),
                         solution.slip_axis.cos};
  const Values here = values(joint, force, axis);
  const bool ball = rows[Row::ball][joint] != 0;
  put(Row::last_reaction, solution.memory.reaction_force);
  put(Row::last_sine, solution.memory.reaction.sin);
  put(Row::last_cosine, ball ? solution.memory.reaction.cos : 0);
  put(Row::last_tangent, solution.memory.tangent);
  put(Row::last_force, force);
  put(Row::last_axis_cosine, axis.cos);
  put(Row::last_speed, rows[Row::viscous][joint] != 0 ? rate.norm() : 1);
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
  put(Row::residual_slope, solution.memory.residual_slope);
  for (const Row row :
       {Row::way_force, Row::way_cosine, Row::way_length, Row::friction_curve,
        Row::sliding_curve, Row::spinning_curve}) {
    put(row, 0);
  }
  // Not known yet.
  put(Row::slope_error, 1);
}

void JointFollower::set_rate(int joint, const Vector3d& rate) noexcept {
  const FollowerRows rows = rows_of(numbers_, stride_);
  rows[Row::rate_x][joint] = rate.x();
  rows[Row::rate_y][joint] = rate.y();
  rows[Row::rate_z][joint] = rate.z();
}

void JointFollower::set_reaction(int joint, const Vector3d& reaction) noexcept {
  const FollowerRows rows = rows_of(numbers_, stride_);
  rows[Row::reaction_x][joint] = reaction.x();
  rows[Row::reaction_y][joint] = reaction.y();
  rows[Row::reaction_z][joint] = reaction.z();
}

void JointFollower::predict() noexcept {
  detail::follower_kernel(set_).predict(rows_of(numbers_, stride_), size());
}

void JointFollower::extend() noexcept {
  detail::follower_kernel(set_).extend(rows_of(numbers_, stride_), size());
}

void JointFollower::evaluate() noexcept {
  const FollowerRows rows = rows_of(numbers_, stride_);
  const detail::FollowerKernel& kernel = detail::follower_kernel(set_);
  kernel.extend(rows, size());
  kernel.approach(rows, size());
  const bool batch = plain_count_ >= enough_for_batch;
  if (batch) evaluate_plain();
  for (int i = 0; i < size(); ++i) {
    if (!followed_[i] || (batch && plain_[i])) continue;
    take(i, values(i, rows[Row::evaluated_force][i],
                   {rows[Row::evaluated_axis_sine][i],
                    rows[Row::evaluated_axis_cosine][i]}));
  }
  kernel.settle(rows, size());
}

bool JointFollower::tracks(int joint) const noexcept {
  constexpr double largest_move = 0.1;
  constexpr double largest_sensitivity = 100;
  const FollowerRows rows = rows_of(numbers_, stride_);
  return followed_[joint] && rows[Row::move][joint] < largest_move &&
         rows[Row::sensitivity][joint] < largest_sensitivity;
}

double JointFollower::shift(int joint) const noexcept {
  return rows_of(numbers_, stride_)[Row::shift][joint];
}

Vector3d JointFollower::moment(int joint) const noexcept {
  const FollowerRows rows = rows_of(numbers_, stride_);
  return {rows[Row::moment_x][joint], rows[Row::moment_y][joint],
          rows[Row::moment_z][joint]};
}

double JointFollower::error(int joint) const noexcept {
  // The worst of 200 random joints on paths of steps of 1e-3 was wrong by 4
  // times what the misses of its slopes say.
  constexpr double safety = 5;
  return safety * rows_of(numbers_, stride_)[Row::error][joint];
}

}  // namespace contact
