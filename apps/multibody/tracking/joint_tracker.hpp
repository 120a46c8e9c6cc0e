#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "libcontact/base/vector_rows.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/solution.hpp"
#include "multibody/tracking/tracker_exchange.hpp"

namespace contact::detail {
struct CapKernel;
}

namespace multibody {

namespace detail {
struct TrackerJoints;
struct TrackerKernel;
template <class T>
struct TrackerState;
}  // namespace detail

using contact::JointContact;
using contact::JointSolution;
using contact::SlipAxis;
using contact::VectorRows;

/// Friction of several sliding joints, side by side, tracked through small
/// changes of R and Dw with one evaluation of each contact: for solvers of
/// several bodies, which evaluate all joints repeatedly.
///
/// The last evaluation of a contact and the secant slopes of f, c_Y and c_Z
/// over R_n and a predict M_t for a new R and Dw, and its slope over R:
/// predict(), then extend() for other R nearby. correct() evaluates each
/// contact at the prediction, corrects the prediction by its error, and the
/// slopes by Broyden's update. error() estimates the error of M_t, largest()
/// the largest error and other maxima over all joints.
///
/// It does not replace Joint in general: it needs a solution to start from, R
/// not too close to Dw, and small changes. is_trusted() tells whether these
/// conditions hold. Joints without clearance and with interference are tracked
/// like others while they are loaded; at R = 0, and if R changes by more than
/// 10 %, start() leaves them to the solver. Where a pin's contact lifts off,
/// its friction has a kink: in the step over it the error of M_t is the square
/// of the step, 4e-7 for a step of 1e-3, which error() does not include.
///
/// R and Dw in any frame; each joint may use its own. Dw of a pin is along its
/// axis; only the part of R normal to it has an effect. Only the constructor
/// allocates or throws. A copy continues from the same memory and shares the
/// contacts.
class JointTracker {
 public:
  /// @param contacts  of balls and pins, dry or viscous
  /// @throws Error if one has a friction stress of its own, or a seat that
  /// ends.
  explicit JointTracker(std::vector<JointContact> contacts);

  int size() const { return static_cast<int>(contacts_->size()); }

  /// Starts to track a joint, with two evaluations for its slopes.
  /// @param solution  of this joint, sliding
  /// @param rate      Dw of the solution
  void start(int joint, const JointSolution& solution,
             const Eigen::Vector3d& rate) noexcept;
  /// Stops tracking: correct() ignores the joint.
  void stop(int joint) noexcept {
    for (auto row : {&Exchange::tracked, &Exchange::asked, &Exchange::exact}) {
      at(row, joint) = 0;
    }
  }
  bool is_tracked(int joint) const noexcept {
    return at(&Exchange::tracked, joint) != 0;
  }

  /// @param rate  Dw, rad/s, not 0
  void set_rate(int joint, const Eigen::Vector3d& rate) noexcept {
    set(&Exchange::rate, joint, rate);
  }
  /// @param reaction  R on the body, N, not 0
  void set_reaction(int joint, const Eigen::Vector3d& reaction) noexcept {
    set(&Exchange::reaction, joint, reaction);
  }
  Eigen::Vector3d reaction(int joint) const noexcept {
    return get(&Exchange::reaction, joint);
  }

  /// M_t by the slopes, without an evaluation.
  /// @param enough  joints whose error() is at most this may be left to
  ///                extend(), here and in correct(); below 0: none
  void predict(double enough = -1) noexcept;
  /// M_t for reactions close to the reactions of the last predict() or
  /// correct() and the same Dw: a linear function of R.
  void extend() noexcept;
  /// M_t for R with each contact evaluated once.
  void correct() noexcept;

  /// Whether the last predict() or correct() stayed within the range of the
  /// slopes: moves of R, b, R_n, ... up to 10 %, no NaN, sin b above 0.01.
  bool is_trusted(int joint) const noexcept {
    return is_tracked(joint) && at(&Exchange::trust, joint) < 1;
  }
  /// M_t for R and Dw, N m.
  Eigen::Vector3d moment(int joint) const noexcept {
    return get(&Exchange::moment, joint);
  }
  /// Estimated relative error of M_t, from recent errors of the slopes: after
  /// correct() the true error was at most 0.62 of it on 1200 random paths
  /// (multibody/joint_tracker_test.cpp).
  double error(int joint) const noexcept { return at(&Exchange::error, joint); }

  /// Moment of the computed motion, N m, for iterations of M_t with the motion
  /// that it causes.
  void set_applied_moment(int joint, const Eigen::Vector3d& moment) noexcept {
    set(&Exchange::applied, joint, moment);
  }
  Eigen::Vector3d applied_moment(int joint) const noexcept {
    return get(&Exchange::applied, joint);
  }
  /// Largest values over the joints tracked after the last predict(), extend()
  /// or correct(), infinity for NaN.
  using Largest = detail::TrackerLargest;
  const Largest& largest() const noexcept { return largest_; }
  /// @param floor  > 0, N m; 1e-100 at first
  void set_moment_floor(double floor) noexcept {
    moment_floor_ = floor * floor;
  }
  /// Applies the moments M_t.
  void apply() noexcept;
  /// Change by apply(), N m; 0 for joints that are not tracked.
  Eigen::Vector3d step(int joint) const noexcept {
    return get(&Exchange::step, joint);
  }
  /// Keeps the applied moments as the end of an interval that began with the
  /// moments kept before.
  void keep() noexcept;
  /// Extrapolates the applied moments beyond that end, by this fraction of the
  /// interval.
  void extrapolate(double share) noexcept;

  /// Rows of all joints: values from set_reaction() and set_applied_moment()
  /// (not read beyond size()) and of step(), 0 beyond size().
  VectorRows reactions() noexcept { return rows(&Exchange::reaction); }
  VectorRows applied_moments() noexcept { return rows(&Exchange::applied); }
  VectorRows steps() noexcept { return rows(&Exchange::step); }

 private:
  using Exchange = detail::TrackerExchange;
  using Vectors = Exchange::Vectors;
  struct Values {  // f/cos a, c_Y/cos a, c_Z/sin a
    double friction, sliding, spinning;
  };
  Values values(int joint, double force, SlipAxis axis,
                double half_angle) const noexcept;
  bool set_window(int joint, double force,
                  detail::TrackerState<double>& state) const noexcept;
  void evaluate_contact(int joint) noexcept;
  detail::TrackerJoints joints() noexcept;
  double* numbers_of(int joint) noexcept;
  detail::TrackerState<double> state(int joint) noexcept;
  void set_state(int joint, const detail::TrackerState<double>& state) noexcept;

  // 8 joints are one exchange.
  static std::size_t packet(int joint) {
    return static_cast<unsigned>(joint) / Exchange::size;
  }
  static unsigned lane(int joint) {
    return static_cast<unsigned>(joint) % Exchange::size;
  }
  double& at(Exchange::Row Exchange::*row, int joint) noexcept {
    return (exchange_[packet(joint)].*row)[lane(joint)];
  }
  double at(Exchange::Row Exchange::*row, int joint) const noexcept {
    return (exchange_[packet(joint)].*row)[lane(joint)];
  }
  Eigen::Vector3d get(Vectors Exchange::*v, int joint) const noexcept {
    const Vectors& from = exchange_[packet(joint)].*v;
    const unsigned k = lane(joint);
    return {from.x[k], from.y[k], from.z[k]};
  }
  void set(Vectors Exchange::*v, int joint, const Eigen::Vector3d& x) noexcept {
    Vectors& to = exchange_[packet(joint)].*v;
    const unsigned k = lane(joint);
    to.x[k] = x.x();
    to.y[k] = x.y();
    to.z[k] = x.z();
  }
  VectorRows rows(Vectors Exchange::*v) noexcept {
    return {(exchange_[0].*v).x, sizeof(Exchange) / sizeof(double)};
  }

  struct alignas(64) Line {
    double of[8];
  };
  const JointContact& contact(int joint) const { return (*contacts_)[joint]; }

  std::shared_ptr<const std::vector<JointContact>> contacts_;
  const detail::TrackerKernel* kernel_;
  const contact::detail::CapKernel* integrals_;
  std::vector<Exchange> exchange_;
  std::vector<Line> states_;  // TrackerState in lanes of the kernel
  bool any_plain_ = false;
  std::vector<char> is_plain_;    // needs only the exact integrals
  std::vector<char> is_smooth_;   // its law is, as far as it has been seen
  double moment_floor_ = 1e-200;  // squared
  Largest largest_{};
};

}  // namespace multibody
