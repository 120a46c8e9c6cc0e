#include "libcontact/joint/step.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Motion and moment of a joint.
struct Move {
  Vector3d angular_velocity;
  Vector3d moment;
  Status status = Status::ok;
};

Move hold(const Vector3d& moment) { return {Vector3d::Zero(), moment}; }

// The moment of a sliding joint as its rate has it, and -dM_t/dDw.
struct Resistance {
  Vector3d moment;
  Matrix3d slope;
};

// M_t = -k Dw about u.
Move viscous_about(const Vector3d& u, double k, double inertia, double free) {
  const double rate = free * inertia / (inertia + k);
  return {rate * u, -k * rate * u};
}

// A moment of a given size about u.
Move dry_about(const Vector3d& u, double size, double inertia, double free) {
  if (std::abs(inertia * free) <= size) return hold(-inertia * free * u);
  const double moment = -std::copysign(size, free);
  return {(free + moment / inertia) * u, moment * u};
}

// Slip that friction leaves of a free motion, once n, R_n and theta0 are known.
class Sliding {
 public:
  // @param rate  of the solution, rad/s
  Sliding(const Joint& joint, const JointSolution& solution,
          const Vector3d& rate)
      : joint_(joint), solution_(solution), rate_(rate) {}

  Move about(const Vector3d& u, double inertia, double free) const {
    const double size = std::abs(solution_.friction_moment.dot(u));
    return joint_.contact().is_viscous()
               ? viscous_about(u, size / rate_.norm(), inertia, free)
               : dry_about(u, size, inertia, free);
  }

  Move of_ball(const Matrix3d& inertia, const Vector3d& free) const {
    if (solution_.state == JointState::unloaded) {
      return {free, Vector3d::Zero()};
    }
    if (joint_.contact().is_viscous()) {
      const Matrix3d k = viscosity();
      const Vector3d rate = (inertia + k).llt().solve(inertia * free);
      return {rate, -k * rate};
    }
    const MomentSet set = joint_.moment_set(solution_);
    const double scale = scale_of(set);
    const MomentSet::Prox prox = set.prox(inertia / scale, free, rate_);
    return {prox.angular_velocity, scale * prox.moment, prox.status};
  }

  // About the axis of a pin, in the corner of the slope.
  Resistance about(const Vector3d& u, double rate) const {
    const double size = std::abs(solution_.friction_moment.dot(u));
    const double k = joint_.contact().is_viscous() ? size / rate_.norm() : 0;
    const double moment = k > 0 ? -k * rate : -std::copysign(size, rate);
    return {moment * u, Vector3d(k, 0, 0).asDiagonal()};
  }

  Resistance of_ball(const Vector3d& rate) const {
    if (solution_.state == JointState::unloaded) {
      return {Vector3d::Zero(), Matrix3d::Zero()};
    }
    if (joint_.contact().is_viscous()) {
      const Matrix3d k = viscosity();
      return {-k * rate, k};
    }
    const MomentSet set = joint_.moment_set(solution_);
    const double scale = scale_of(set);
    const double size = rate.norm();
    return {scale * set.moment(rate),
            scale / size * set.curvature(rate / size)};
  }

 private:
  // M_t = -K Dw, K round about n.
  Matrix3d viscosity() const {
    const Vector3d& n = solution_.normal;
    const auto size = [&](const Vector3d& u) {
      return joint_.solve_contact({solution_.normal_force * n, u})
          .friction_moment.norm();
    };
    const double across = size(n.unitOrthogonal());
    return across * Matrix3d::Identity() +
           (size(n) - across) * n * n.transpose();
  }
  // A friction stress makes the set that of rest, its size that of the speed.
  double scale_of(const MomentSet& set) const {
    return joint_.contact().stress()
               ? solution_.friction_moment.norm() / set.moment(rate_).norm()
               : 1;
  }

  const Joint& joint_;
  const JointSolution& solution_;
  const Vector3d& rate_;
};

// Begins a step with friction at its start, if the joint does not rest.
void begin(const Joint& joint, const StepStart& start, JointStep& step) {
  step.status = Status::ok;
  if (start.angular_velocity.isZero(0)) return;
  step.solution = joint.solve(
      {start.reaction, start.angular_velocity, start.axis}, step.solution);
  step.status = step.solution.status;
}

// Whether a resting joint holds a moment; if not, how it slides is looked for.
bool holds(const Joint& joint, const StepStart& start, const Vector3d& axis,
           const Vector3d& moment, JointStep& step) {
  step.rest = joint.at_rest({start.reaction, moment, axis}, step.rest);
  step.status = step.rest.status;
  if (!(step.rest.utilisation > 1)) return true;
  // If nothing is held the free motion gives the direction of slip.
  step.solution = std::isinf(step.rest.utilisation)
                      ? joint.solve({start.reaction, start.free, axis})
                      : step.rest.slip;
  return false;
}

// A rate to which the solution of a step belongs, if the joint slides.
const Vector3d& rate_of(const StepStart& start, const JointStep& step) {
  if (!start.angular_velocity.isZero(0)) return start.angular_velocity;
  return std::isinf(step.rest.utilisation) ? start.free : step.rest.direction;
}

// Goes on from begin(), with an inertia and a free motion that may change from
// sweep to sweep.
// @param held   the moment that would hold the joint
// @param slide  Move of a Sliding
template <class Slide>
void go_on(const Joint& joint, const StepStart& start, const Vector3d& axis,
           const Vector3d& held, const Slide& slide, JointStep& step) {
  const bool rests = start.angular_velocity.isZero(0);
  Move next = hold(held);
  if (!rests || !holds(joint, start, axis, held, step)) {
    next = slide(Sliding(joint, step.solution, rate_of(start, step)));
    step.status = std::max(step.status, next.status);
  }
  if (!next.moment.allFinite() || !next.angular_velocity.allFinite()) {
    step.status = Status::out_of_range;
  }
  if (step.status == Status::out_of_range) {
    next.angular_velocity = next.moment = Vector3d::Constant(nan);
  }
  step.angular_velocity = next.angular_velocity;
  step.moment = next.moment;
  step.holds = next.angular_velocity.isZero(0);
}

void go_on(const Joint& pin, const StepStart& start, const Vector3d& axis,
           double inertia, double free, JointStep& step) {
  const auto slide = [&](const Sliding& sliding) {
    return sliding.about(axis, inertia, free);
  };
  go_on(pin, start, axis, -inertia * free * axis, slide, step);
}

void go_on(const Joint& ball, const StepStart& start, const Matrix3d& inertia,
           const Vector3d& free, JointStep& step) {
  const auto slide = [&](const Sliding& sliding) {
    return sliding.of_ball(inertia, free);
  };
  go_on(ball, start, Vector3d::Zero(), -(inertia * free), slide, step);
}

Vector3d axis_of(const StepStart& start) {
  if (!start.axis.isZero(0)) return start.axis;
  return start.angular_velocity.isZero(0)
             ? start.free.stableNormalized()
             : start.angular_velocity.stableNormalized();
}

// |w - w^T| <= 1e-6 |w|, false for NaN.
template <class Matrix>
bool is_symmetric(const Matrix& w) {
  double size = 0;
  double difference = 0;
  for (Eigen::Index i = 0; i < w.rows(); ++i) {
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      if (!std::isfinite(w(i, k))) return false;
      size = std::max(size, std::abs(w(i, k)));
      difference = std::max(difference, std::abs(w(i, k) - w(k, i)));
    }
  }
  return difference <= 1e-6 * size;
}

bool is_inertia_of_ball(const Matrix3d& w) {
  return is_symmetric(w) && w.llt().info() == Eigen::Success;
}

}  // namespace

bool is_inertia(const Joint& joint, const StepStart& start,
                const Matrix3d& inertia) noexcept {
  if (!joint.is_pin()) return is_inertia_of_ball(inertia);
  const Vector3d u = axis_of(start);
  const double about = u.dot(inertia * u);
  // Without motion there is no axis, and nothing to refuse.
  return (about > 0 && std::isfinite(about)) || u.isZero(0) || !u.allFinite();
}

JointStep step(const Joint& joint, const StepStart& start,
               const Matrix3d& inertia, const JointStep& last) noexcept {
  JointStep result = last;
  if (!is_inertia(joint, start, inertia)) {
    result.status = Status::out_of_range;
    result.angular_velocity = result.moment = Vector3d::Constant(nan);
    result.holds = false;
    return result;
  }
  begin(joint, start, result);
  if (joint.is_pin()) {
    const Vector3d u = axis_of(start);
    go_on(joint, start, u, u.dot(inertia * u), u.dot(start.free), result);
  } else {
    go_on(joint, start, inertia, start.free, result);
  }
  return result;
}

namespace {

// Rows of a joint in the matrix of all.
Eigen::Index size_of(const Joint& joint) { return joint.is_pin() ? 1 : 3; }

void check(std::span<const Joint* const> joints,
           std::span<const StepStart> starts,
           const Eigen::Ref<const Eigen::MatrixXd>& inertia,
           std::size_t steps) {
  const Eigen::Index rows = inertia.rows();
  const Eigen::Index columns = inertia.cols();
  Eigen::Index size = 0;
  for (const Joint* joint : joints) size += size_of(*joint);
  if (starts.size() != joints.size() || steps != joints.size()) {
    throw Error("step: starts and steps must be as many as the joints");
  }
  if (rows != size || columns != size) {
    throw Error(detail::must_be(
        detail::message("step: inertia of {} by {}", rows, columns),
        detail::message("{} by {}, three rows of a ball and one of a pin", size,
                        size)));
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i]->is_pin() && starts[i].axis.isZero(0)) {
      throw Error(detail::message("step: pin {} requires axis", i));
    }
  }
  if (!is_symmetric(inertia)) {
    throw Error(detail::must_be("step: inertia", "finite and symmetric"));
  }
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i]->is_pin()
            ? !(inertia(at, at) > 0)
            : !is_inertia_of_ball(inertia.block<3, 3>(at, at))) {
      throw Error(
          detail::must_be(detail::message("step: inertia of joint {}", i),
                          "positive definite"));
    }
    at += size_of(*joints[i]);
  }
}

// Newton's method for the joints that move, and one joint after the other where
// it ends, until their moments fit:
//
//     W (Dw - free) = M,   Dw = 0 of those that hold.
//
// Those that move make the smallest of a convex function, whose solution is the
// only one. In a sweep each takes its step with the moments of the others,
// which hardly change; B = W^-1, of those that move, says how they answer to a
// moment. A change of who holds needs another W.
class Mechanism {
 public:
  Mechanism(std::span<const Joint* const> joints,
            std::span<const StepStart> starts,
            const Eigen::Ref<const Eigen::MatrixXd>& inertia,
            std::span<JointStep> steps)
      : joints_(joints),
        starts_(starts),
        inertia_(inertia),
        steps_(steps),
        moment_(Eigen::VectorXd::Zero(inertia.rows())) {
    Eigen::VectorXd free(inertia.rows());
    for (std::size_t i = 0; i < joints.size(); ++i) {
      at_.push_back(i == 0 ? 0 : at_.back() + size_of(*joints[i - 1]));
      put(i, starts[i].free, free);
      holds_.push_back(starts[i].angular_velocity.isZero(0));
      if (!holds_[i]) put(i, steps[i].solution.friction_moment, moment_);
      const auto rows = size_of(*joints[i]);
      size_ = std::max(size_, (inertia.block(at_[i], at_[i], rows, rows) *
                               free.segment(at_[i], rows))
                                  .norm());
    }
    pull_ = inertia * free;
  }

  // Moments of those that move from the rates that they cause, as far as
  // Newton's steps halve what is left.
  void fit(double tolerance) {
    if (is_other_) divide();
    double left = std::numeric_limits<double>::infinity();
    Eigen::VectorXd rate = rate_;
    Eigen::VectorXd moment = moment_;
    for (fits_ = false; !fits_;) {
      Eigen::MatrixXd slope = weight_;
      const Eigen::VectorXd moments = resist(rate, slope);
      const Eigen::VectorXd change = moments - moment(moving_);
      const double now = change.norm();
      if (!(now <= left / 2)) return;
      left = now;
      fits_ = now <= tolerance / 10 * size_;
      rate_ = rate;
      moment_ = moment;
      if (fits_) {
        moment_(moving_) = moments;
        for (std::size_t i = 0; i < joints_.size(); ++i) take(i);
      } else {
        const Eigen::VectorXd step = slope.llt().solve(change);
        rate(moving_) += step;
        moment(moving_) += weight_ * step;
      }
    }
  }

  // Largest change of a moment over the largest W_ii free; infinite where
  // other joints hold than before. Those that fit are left alone.
  double sweep() {
    status_ = Status::ok;
    double change = 0;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const bool held = holds_[i];
      if (!fits_ || held || starts_[i].angular_velocity.isZero(0)) {
        const double turned = joints_[i]->is_pin() ? turn<1>(i) : turn<3>(i);
        if (!(fits_ && held)) change = std::max(change, turned);
      }
      status_ = std::max(status_, steps_[i].status);
    }
    if (is_other_) return std::numeric_limits<double>::infinity();
    return size_ > 0 ? change / size_ : 0;
  }

  Status status() const { return status_; }

 private:
  void put(std::size_t i, const Vector3d& v, Eigen::VectorXd& to) const {
    if (joints_[i]->is_pin()) {
      to[at_[i]] = v.dot(starts_[i].axis);
    } else {
      to.segment<3>(at_[i]) = v;
    }
  }

  Vector3d get(std::size_t i, const Eigen::VectorXd& from) const {
    if (joints_[i]->is_pin()) return from[at_[i]] * starts_[i].axis;
    return from.segment<3>(at_[i]);
  }

  // W and Dw of those that move.
  void divide() {
    moving_.clear();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      for (Eigen::Index k = 0; k < size_of(*joints_[i]) && !holds_[i]; ++k) {
        moving_.push_back(at_[i] + k);
      }
    }
    weight_ = inertia_(moving_, moving_);
    factor_.compute(weight_);
    has_answer_ = is_other_ = false;
    rate_.setZero(inertia_.rows());
    const Eigen::VectorXd forces = (moment_ + pull_)(moving_);
    const Eigen::VectorXd rates = factor_.solve(forces);
    rate_(moving_) = rates;
  }

  // B, 0 in rows and columns of those that hold.
  void invert() {
    answer_.setZero(inertia_.rows(), inertia_.rows());
    const auto rows = weight_.rows();
    const Eigen::MatrixXd inverse =
        factor_.solve(Eigen::MatrixXd::Identity(rows, rows));
    answer_(moving_, moving_) = inverse;
    has_answer_ = true;
  }

  // Moments of those that move, and W - dM/dDw in the place of W.
  Eigen::VectorXd resist(const Eigen::VectorXd& rate,
                         Eigen::MatrixXd& slope) const {
    Eigen::VectorXd moments(slope.rows());
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (holds_[i]) continue;
      const Sliding sliding(*joints_[i], steps_[i].solution,
                            rate_of(starts_[i], steps_[i]));
      if (joints_[i]->is_pin()) {
        const auto r = sliding.about(starts_[i].axis, rate[at_[i]]);
        moments[at] = r.moment.dot(starts_[i].axis);
        slope(at, at) += r.slope(0, 0);
      } else {
        const auto r = sliding.of_ball(Vector3d(rate.segment<3>(at_[i])));
        moments.segment<3>(at) = r.moment;
        slope.block<3, 3>(at, at) += r.slope;
      }
      at += size_of(*joints_[i]);
    }
    return moments;
  }

  // Takes over what fits, if joint i moves.
  void take(std::size_t i) {
    if (holds_[i]) return;
    steps_[i].angular_velocity = get(i, rate_);
    steps_[i].moment = get(i, moment_);
    steps_[i].holds = false;
  }

  // The step of joint i; the change of its moment.
  template <int rows>
  double turn(std::size_t i) {
    using Block = Eigen::Matrix<double, rows, rows>;
    using Part = Eigen::Matrix<double, rows, 1>;
    const Eigen::Index at = at_[i];
    Block w;
    Part free;
    if (holds_[i]) {
      const Part held =
          inertia_.middleRows<rows>(at) * rate_ - pull_.segment<rows>(at);
      w = inertia_.block<rows, rows>(at, at);
      free = -w.llt().solve(held);
    } else {
      if (!has_answer_) invert();
      const Block b = answer_.block<rows, rows>(at, at);
      w = b.llt().solve(Block::Identity());
      free = rate_.segment<rows>(at) - b * moment_.segment<rows>(at);
    }
    step_of(i, w, free);
    const Part before = moment_.segment<rows>(at);
    put(i, steps_[i].moment, moment_);
    const Part change = moment_.segment<rows>(at) - before;
    if (!holds_[i]) rate_ += answer_.middleCols<rows>(at) * change;
    is_other_ = is_other_ || holds_[i] != steps_[i].holds;
    holds_[i] = steps_[i].holds;
    return change.norm();
  }

  void step_of(std::size_t i, const Eigen::Matrix<double, 1, 1>& w,
               const Eigen::Matrix<double, 1, 1>& free) {
    go_on(*joints_[i], starts_[i], starts_[i].axis, w[0], free[0], steps_[i]);
  }
  void step_of(std::size_t i, const Matrix3d& w, const Vector3d& free) {
    go_on(*joints_[i], starts_[i], w, free, steps_[i]);
  }

  std::span<const Joint* const> joints_;
  std::span<const StepStart> starts_;
  const Eigen::Ref<const Eigen::MatrixXd>& inertia_;
  std::span<JointStep> steps_;
  std::vector<Eigen::Index> at_;  // first rows
  std::vector<char> holds_;
  std::vector<Eigen::Index> moving_;  // rows
  bool is_other_ = true;              // others hold than those of W
  bool fits_ = false;                 // the moving ones fit each other
  bool has_answer_ = false;
  double size_ = 0;  // largest W_ii free
  Status status_ = Status::ok;
  Eigen::VectorXd pull_;    // W free
  Eigen::VectorXd moment_;  // M
  Eigen::VectorXd rate_;    // Dw
  Eigen::MatrixXd weight_;  // W of those that move
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::MatrixXd answer_;  // B
};

}  // namespace

StepSweeps step(std::span<const Joint* const> joints,
                std::span<const StepStart> starts,
                const Eigen::Ref<const Eigen::MatrixXd>& inertia,
                std::span<JointStep> steps, double tolerance) {
  check(joints, starts, inertia, steps.size());
  if (joints.size() == 1 && !joints[0]->is_pin()) {
    steps[0] = step(*joints[0], starts[0], Matrix3d(inertia), steps[0]);
    return {steps[0].status, 1, 0};
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    begin(*joints[i], starts[i], steps[i]);
  }
  Mechanism mechanism(joints, starts, inertia, steps);
  constexpr int sweep_limit = 1000;
  StepSweeps result;
  for (result.sweeps = 1;; ++result.sweeps) {
    mechanism.fit(tolerance);
    result.residual = mechanism.sweep();
    result.status = mechanism.status();
    if (result.status == Status::out_of_range || result.residual <= tolerance) {
      return result;
    }
    if (result.sweeps == sweep_limit) {
      result.status = Status::not_converged;
      return result;
    }
  }
}

}  // namespace contact
