#include "libcontact/joint/step.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/joint/contact_model.hpp"

namespace contact {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

using detail::infinity;
using detail::nan;

// Motion and moment of a joint.
struct Move {
  Vector3d angular_velocity;
  Vector3d moment;
  Status status = Status::ok;
};

Move hold(const Vector3d& moment) { return {Vector3d::Zero(), moment}; }

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
      const Vector3d rate =
          detail::solve_positive(Matrix3d(inertia + k), inertia * free);
      return {rate, -k * rate};
    }
    const MomentSet set = joint_.moment_set(solution_);
    const double scale = scale_of(set);
    const MomentSet::Prox prox = set.prox(inertia / scale, free, rate_);
    return {prox.angular_velocity, scale * prox.moment, prox.status};
  }

  // The moment at another rate, about the axis of a pin or of a ball.
  double moment(const Vector3d& u, double rate) const {
    const double size = std::abs(solution_.friction_moment.dot(u));
    const double k = slope(u);
    return k > 0 ? -k * rate : -std::copysign(size, rate);
  }
  Vector3d moment(const Vector3d& rate) const {
    if (solution_.state == JointState::unloaded) return Vector3d::Zero();
    if (joint_.contact().is_viscous()) return -viscosity() * rate;
    const MomentSet set = joint_.moment_set(solution_);
    return scale_of(set) * set.moment(rate);
  }

  // -dM_t/dDw.
  double slope(const Vector3d& u) const {
    if (!joint_.contact().is_viscous()) return 0;
    return std::abs(solution_.friction_moment.dot(u)) / rate_.norm();
  }
  Matrix3d slope(const Vector3d& rate, const Vector3d& moment_there) const {
    if (solution_.state == JointState::unloaded) return Matrix3d::Zero();
    if (joint_.contact().is_viscous()) return viscosity();
    const MomentSet set = joint_.moment_set(solution_);
    const double scale = scale_of(set);
    const double size = rate.norm();
    return scale / size * set.curvature(rate / size, moment_there / scale);
  }

 private:
  // M_t = -K Dw, K round about n but at a rim.
  Matrix3d viscosity() const {
    if (const auto moments = detail::moments_of(joint_, solution_)) {
      Matrix3d k;
      for (int i = 0; i < 3; ++i)
        k.col(i) = -moments->moment(Vector3d::Unit(i));
      return k;
    }
    const Vector3d& n = solution_.normal;
    const auto size = [&](const Vector3d& u) {
      return joint_.solve_contact({solution_.normal_force * n, u})
          .friction_moment.norm();
    };
    const double across = size(n.unitOrthogonal());
    return across * Matrix3d::Identity() +
           (size(n) - across) * n * n.transpose();
  }
  // With a friction stress the set belongs to rest, and its size to the speed.
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
      {start.reaction, start.angular_velocity, start.axis, start.placement},
      step.solution);
  step.status = step.solution.status;
}

// Whether a resting joint holds a moment; if not, how it slides is looked for.
bool holds(const Joint& joint, const StepStart& start, const Vector3d& axis,
           const Vector3d& moment, JointStep& step) {
  step.rest =
      joint.at_rest({start.reaction, moment, axis, start.placement}, step.rest);
  step.status = step.rest.status;
  if (!(step.rest.utilisation > 1)) return true;
  // If nothing is held the free motion gives the direction of slip.
  step.solution =
      std::isinf(step.rest.utilisation)
          ? joint.solve({start.reaction, start.free, axis, start.placement})
          : step.rest.slip;
  return false;
}

bool has_no_numbers(Status status) {
  return status == Status::out_of_range || status == Status::out_of_seat;
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
  const bool is_finite =
      next.moment.allFinite() && next.angular_velocity.allFinite();
  if (!is_finite && step.status != Status::out_of_seat) {
    step.status = Status::out_of_range;
  }
  if (has_no_numbers(step.status)) {
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
    for (Eigen::Index k = 0; k <= i; ++k) {
      if (!std::isfinite(w(i, k)) || !std::isfinite(w(k, i))) return false;
      size = std::max({size, std::abs(w(i, k)), std::abs(w(k, i))});
      difference = std::max(difference, std::abs(w(i, k) - w(k, i)));
    }
  }
  return difference <= 1e-6 * size;
}

bool is_inertia_of_ball(const Matrix3d& w) {
  return is_symmetric(w) && detail::is_positive(w);
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
// which hardly change; B = W^-1 of the moving joints gives their response to a
// moment. If other joints hold, W must be made again.
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
  // Newton's steps halve what is left: from rates that are guessed, and where
  // that fails or a joint rested from those that moments so far cause.
  void fit(double tolerance) {
    fits_ = false;
    if (is_other_) {
      divide();
      fits_ = guess() && newton(tolerance);
      if (fits_) return;
      factor_ = weight_;
      detail::factor_positive(factor_);
      Eigen::VectorXd rates = (moment_ + pull_)(moving_);
      detail::solve_factored(factor_, rates);
      rate_(moving_) = rates;
    }
    fits_ = newton(tolerance);
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
    if (is_other_) return infinity;
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

  // W of those that move.
  void divide() {
    moving_.clear();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      for (Eigen::Index k = 0; k < size_of(*joints_[i]) && !holds_[i]; ++k) {
        moving_.push_back(at_[i] + k);
      }
    }
    if (static_cast<Eigen::Index>(moving_.size()) == inertia_.rows()) {
      weight_ = inertia_;
    } else {
      weight_ = inertia_(moving_, moving_);
    }
    has_answer_ = is_other_ = false;
    rate_.setZero(inertia_.rows());
  }

  // Rates to begin from, if it is the first time and all that move did so.
  bool guess() {
    if (has_guessed_) return false;
    has_guessed_ = true;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (holds_[i]) continue;
      if (starts_[i].angular_velocity.isZero(0)) return false;
      const Vector3d& guess = steps_[i].angular_velocity;
      const bool has_one = guess.squaredNorm() > 0;
      put(i, has_one ? guess : starts_[i].angular_velocity, rate_);
    }
    return true;
  }

  // A slope serves as long as each step by it leaves no more than this share.
  static constexpr double good_share = 0.05;

  bool newton(double tolerance) {
    const double small = tolerance / 10 * size_;
    const Eigen::VectorXd pull = pull_(moving_);
    Eigen::VectorXd rate = rate_(moving_);
    Eigen::MatrixXd slope;  // its Cholesky factor
    for (double left = infinity;;) {
      const Eigen::VectorXd moments = resist(rate);
      const Eigen::VectorXd change = moments + pull - weight_ * rate;
      const double now = change.norm();
      if (!(now <= left / 2)) return false;
      rate_(moving_) = rate;
      moment_(moving_) = moments - change;
      if (now <= small) {
        take(moments);
        return true;
      }
      const double share = now / left;
      const bool is_good = left < infinity && share <= good_share;
      if (!is_good) {
        slope = sloped(rate, moments);
        detail::factor_positive(slope);
      }
      Eigen::VectorXd step = change;
      detail::solve_factored(slope, step);
      rate += step;
      if (is_good && share * now <= small / 100) {
        rate_(moving_) = rate;
        take(moments - change + weight_ * step);
        return true;
      }
      left = now;
    }
  }

  // B, 0 in rows and columns of those that hold.
  void invert() {
    answer_.setZero(inertia_.rows(), inertia_.rows());
    const auto rows = weight_.rows();
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(rows, rows);
    detail::solve_factored(factor_, inverse);
    answer_(moving_, moving_) = inverse;
    has_answer_ = true;
  }

  // Calls what is given with each joint that moves, its first row among those
  // that do, and how it slides.
  template <class Work>
  void each_moving(const Work& work) const {
    Eigen::Index at = 0;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (holds_[i]) continue;
      work(i, at,
           Sliding(*joints_[i], steps_[i].solution,
                   rate_of(starts_[i], steps_[i])));
      at += size_of(*joints_[i]);
    }
  }

  // Moments of those that move at their rates.
  Eigen::VectorXd resist(const Eigen::VectorXd& rate) const {
    Eigen::VectorXd moments(rate.size());
    each_moving([&](std::size_t i, Eigen::Index at, const Sliding& sliding) {
      if (joints_[i]->is_pin()) {
        moments[at] = sliding.moment(starts_[i].axis, rate[at]);
      } else {
        moments.segment<3>(at) = sliding.moment(rate.segment<3>(at));
      }
    });
    return moments;
  }

  // W - dM/dDw of those that move.
  Eigen::MatrixXd sloped(const Eigen::VectorXd& rate,
                         const Eigen::VectorXd& moments) const {
    Eigen::MatrixXd all = weight_;
    each_moving([&](std::size_t i, Eigen::Index at, const Sliding& sliding) {
      if (joints_[i]->is_pin()) {
        all(at, at) += sliding.slope(starts_[i].axis);
      } else {
        all.block<3, 3>(at, at) +=
            sliding.slope(rate.segment<3>(at), moments.segment<3>(at));
      }
    });
    return all;
  }

  // Takes over what fits.
  void take(const Eigen::VectorXd& moments) {
    moment_(moving_) = moments;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (holds_[i]) continue;
      steps_[i].angular_velocity = get(i, rate_);
      steps_[i].moment = get(i, moment_);
      steps_[i].holds = false;
    }
  }

  // The step of joint i; the change of its moment beyond what rounding leaves.
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
      free = -solve(w, held);
    } else {
      if (!has_answer_) invert();
      const Block b = answer_.block<rows, rows>(at, at);
      w = inverse_of(b);
      free = rate_.segment<rows>(at) - b * moment_.segment<rows>(at);
    }
    step_of(i, w, free);
    const Part before = moment_.segment<rows>(at);
    put(i, steps_[i].moment, moment_);
    const Part change = moment_.segment<rows>(at) - before;
    if (!holds_[i]) rate_ += answer_.middleCols<rows>(at) * change;
    is_other_ = is_other_ || holds_[i] != steps_[i].holds;
    holds_[i] = steps_[i].holds;
    // Rounding leaves small contacts more than any tolerance; both moments have
    // some of it.
    const Vector3d& found = steps_[i].angular_velocity;
    Part rate;
    if constexpr (rows == 1) {
      rate[0] = found.dot(starts_[i].axis);
    } else {
      rate = found;
    }
    const double left = (w * (rate - free) - moment_.segment<rows>(at)).norm();
    return std::max(0.0, change.norm() - 4 * left);
  }

  using Number = Eigen::Matrix<double, 1, 1>;
  static Number solve(const Number& w, const Number& of) { return of / w[0]; }
  static Vector3d solve(const Matrix3d& w, const Vector3d& of) {
    return detail::solve_positive(w, of);
  }
  static Number inverse_of(const Number& b) { return Number(1 / b[0]); }
  static Matrix3d inverse_of(const Matrix3d& b) {
    return detail::inverse_of_positive(b);
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
  bool is_other_ = true;              // W belongs to other held joints
  bool fits_ = false;                 // the moving ones fit each other
  bool has_guessed_ = false;
  bool has_answer_ = false;
  double size_ = 0;  // largest W_ii free
  Status status_ = Status::ok;
  Eigen::VectorXd pull_;    // W free
  Eigen::VectorXd moment_;  // M
  Eigen::VectorXd rate_;    // Dw
  Eigen::MatrixXd weight_;  // W of those that move
  Eigen::MatrixXd factor_;  // Cholesky's
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
    if (has_no_numbers(result.status) || result.residual <= tolerance) {
      return result;
    }
    if (result.sweeps == sweep_limit) {
      result.status = Status::not_converged;
      return result;
    }
  }
}

}  // namespace contact
