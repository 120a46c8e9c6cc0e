#include "libcontact/joint/steps/mechanism_step.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/base/text.hpp"

namespace contact {

using Eigen::MatrixXd;
using Eigen::Ref;
using Eigen::Vector3d;
using Eigen::VectorXd;

MechanismStep::MechanismStep(const std::vector<MechanismJoint>& joints,
                             int size) {
  std::vector<bool> is_own(std::max(size, 0));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto& [joint, first] = joints[i];
    joints_.push_back(joint);
    first_.push_back(first);
    const int count = joint->is_pin() ? 1 : 3;
    const bool fits = first >= 0 && first <= size - count;
    for (int k = first; k < first + count; ++k) {
      if (!fits || is_own[k]) {
        throw Error(detail::must_be(
            detail::message("MechanismStep: the rates of joint {}", i),
            detail::message("among {} and of no other joint", size)));
      }
      is_own[k] = true;
      own_.push_back(k);
    }
  }
  for (int k = 0; k < size; ++k) {
    if (!is_own[k]) other_.push_back(k);
  }
  starts_.resize(joints_.size());
  placements_.resize(joints_.size());
  steps_.resize(joints_.size());
}

void MechanismStep::check(const char* name, Eigen::Index found) const {
  const Eigen::Index size = std::ssize(own_) + std::ssize(other_);
  if (found == size) return;
  throw Error(
      detail::must_be(detail::message("MechanismStep: the size of {}", name),
                      detail::message("{}, not {}", size, found)));
}

void MechanismStep::weigh(const Ref<const MatrixXd>& inertia,
                          const Ref<const MatrixXd>& rows,
                          const Ref<const VectorXd>& stiffness,
                          double time_step) {
  check("inertia", inertia.rows());
  check("inertia", inertia.cols());
  if (rows.rows() > 0) check("rows", rows.cols());
  if (stiffness.size() != rows.rows()) {
    throw Error(
        detail::must_be("MechanismStep: stiffness", "one for each row"));
  }
  if (!(time_step > 0)) {
    throw Error(detail::must_be("MechanismStep: time_step", "above 0"));
  }
  const MatrixXd h = inertia + rows.transpose() * stiffness.asDiagonal() * rows;
  weight_ = h(own_, own_);
  if (!other_.empty()) {
    const MatrixXd across = h(other_, own_);
    weight_ -=
        across.transpose() * detail::solve_positive(h(other_, other_), across);
  }
  weight_ /= time_step;
}

// Dw of a joint from generalized rates.
Vector3d MechanismStep::rate_of(std::size_t i,
                                const Ref<const VectorXd>& q) const {
  if (is_pin(i)) return q[first_[i]] * starts_[i].axis;
  return q.segment<3>(first_[i]);
}

void MechanismStep::begin(std::span<const MechanismStart> starts,
                          const Ref<const VectorXd>& rates,
                          const Ref<const VectorXd>& likely) {
  check("rates", rates.size());
  check("likely", likely.size());
  if (starts.size() != joints_.size()) {
    throw Error(detail::must_be("MechanismStep: starts", "of all joints"));
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const MechanismStart& s = starts[i];
    constexpr double single = 1e-5;  // for hosts in single precision
    if (!s.from_seat.isUnitary(single) || !(s.from_seat.determinant() > 0)) {
      throw Error(detail::must_be(
          detail::message("MechanismStep: from_seat of joint {}", i),
          "a rotation"));
    }
    starts_[i].reaction = s.reaction;
    starts_[i].axis = s.axis;
    // A placement would turn a pin into a finite-length pin.
    placements_[i].from_seat = s.from_seat;
    const bool is_turned = !is_pin(i) && !s.from_seat.isIdentity(0);
    starts_[i].placement = is_turned ? &placements_[i] : nullptr;
    starts_[i].angular_velocity = rate_of(i, rates);
    steps_[i].angular_velocity = rate_of(i, likely);
  }
  has_begun_ = true;
}

double MechanismStep::turn(const Ref<const VectorXd>& rates_at_end,
                           Ref<VectorXd> force) {
  check("rates_at_end", rates_at_end.size());
  check("force", force.size());
  if (weight_.rows() < std::ssize(own_) || !has_begun_) {
    throw Error("MechanismStep: weigh() and begin() must come before turn()");
  }
  const VectorXd before = force(own_);
  // The rates without this friction.
  VectorXd free = rates_at_end;
  if (!before.isZero(0)) {
    free(own_) -= detail::solve_positive(weight_, before).col(0);
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    starts_[i].free = rate_of(i, free);
  }
  sweeps_ = step(joints_, starts_, weight_, steps_);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Vector3d& moment = steps_[i].moment;
    if (is_pin(i)) {
      force[first_[i]] = moment.dot(starts_[i].axis);
    } else {
      force.segment<3>(first_[i]) = moment;
    }
  }
  const VectorXd after = force(own_);
  const double change = (after - before).norm();
  return change == 0 ? 0 : change / after.norm();
}

VectorXd MechanismStep::holding_force(
    const Ref<const VectorXd>& rates,
    const Ref<const VectorXd>& rates_at_end) const {
  check("rates", rates.size());
  check("rates_at_end", rates_at_end.size());
  if (weight_.rows() < std::ssize(own_)) {
    throw Error("MechanismStep: weigh() must come before holding_force()");
  }
  VectorXd force = VectorXd::Zero(rates.size());
  force(own_) = weight_ * (rates - rates_at_end)(own_);
  return force;
}

}  // namespace contact
