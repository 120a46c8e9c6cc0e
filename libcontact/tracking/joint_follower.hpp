#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "libcontact/base/instruction_set.hpp"
#include "libcontact/base/vector_rows.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/solution.hpp"

namespace contact {

namespace detail {
struct CapKernel;
class FollowerRows;
struct FollowerKernel;
struct FollowerLargest;
}  // namespace detail

/// Friction of several sliding joints, side by side, followed through small
/// changes of R and Dw with one evaluation of each contact: for solvers of
/// several bodies, which evaluate all joints again and again.
///
/// What the last evaluation of a contact found, and the slopes that f, c_Y and
/// c_Z had over R_n and a, tell M_t for a new R and Dw, and how it changes with
/// R: predict(), then extend() for other R nearby. evaluate() looks whether it
/// is so, with one evaluation of each contact, puts right what was missed, and
/// improves the slopes (Broyden's update). error() says how wrong M_t is likely
/// to be, largest() the same and more of all joints.
///
/// For what BallJoint and PinJoint solve in general this is no
/// substitute: it needs a solution to start from, R not too near to Dw, and
/// small changes. tracks() says whether it has all that.
///
/// R and Dw in any frame, for each joint another one if one likes; Dw of a pin
/// along its axis; of its R what is normal to that counts. No call but the
/// constructor allocates or throws.
class JointFollower {
 public:
  /// By the best instruction set.
  /// @param contacts  of balls and pins, with friction
  explicit JointFollower(std::vector<JointContact> contacts);
  /// @param set  a supported one; what it takes for the integrals of other
  ///   pressures than the cosine is the best all the same
  JointFollower(std::vector<JointContact> contacts, InstructionSet set);

  int size() const { return static_cast<int>(contacts_.size()); }

  /// Begins to follow a joint, with two evaluations for its slopes.
  /// @param solution  of this joint, sliding
  /// @param rate      Dw for which it was found
  void start(int joint, const JointSolution& solution,
             const Eigen::Vector3d& rate) noexcept;
  /// No longer: the joint is left out of evaluate().
  void forget(int joint) noexcept { *at(followed_row, joint) = 0; }
  bool follows(int joint) const noexcept {
    return *at(followed_row, joint) != 0;
  }

  /// @param rate  Dw, rad/s, not 0
  void set_rate(int joint, const Eigen::Vector3d& rate) noexcept {
    set(rate_row, joint, rate);
  }
  /// @param reaction  R on the body, N, not 0
  void set_reaction(int joint, const Eigen::Vector3d& reaction) noexcept {
    set(reaction_row, joint, reaction);
  }
  Eigen::Vector3d reaction(int joint) const noexcept {
    return get(reaction_row, joint);
  }

  /// M_t by the slopes, nothing evaluated.
  void predict() noexcept;
  /// The same for reactions close to those of the last predict(), Dw as it was
  /// there: a linear function of R.
  void extend() noexcept;
  /// M_t for reactions close to those of the last predict(), each contact
  /// evaluated once. extend() may follow.
  void evaluate() noexcept;

  /// Of all joints: what set_reaction() sets (beyond size() it is not read) and
  /// action() tells, 0 beyond size().
  VectorRows reactions() noexcept { return rows_from(reaction_row); }
  VectorRows actions() noexcept { return rows_from(action_row); }

  /// From now on predict() leaves out all joints but those chosen (and some
  /// that share lanes with them), and evaluate() does no more than extend() for
  /// the others, until all are chosen again.
  void choose(int joint) noexcept;
  /// Chooses those with an error() that is larger, or NaN; maybe none.
  void choose_worse_than(double error) noexcept;
  void choose_all() noexcept;

  /// Whether the last predict() or evaluate() stayed where the slopes are of
  /// use: moves of R, b, R_n, ... up to 10 %, no NaN, sin b above 0.01.
  bool tracks(int joint) const noexcept;
  /// M_t for R and Dw, N m.
  Eigen::Vector3d moment(int joint) const noexcept {
    return get(moment_row, joint);
  }
  /// After evaluate(), and extend(): what M_t is likely to be wrong by, over
  /// |M_t|, from how wrong the slopes were found lately: at most 0.53
  /// of it on 1200 random paths (tracking/joint_follower_test.cpp).
  double error(int joint) const noexcept;

  /// For those who bring M_t together with the motion that it causes: the
  /// moment with which that has been worked out, N m.
  void set_acting_moment(int joint, const Eigen::Vector3d& moment) noexcept {
    set(acting_row, joint, moment);
  }
  Eigen::Vector3d acting_moment(int joint) const noexcept {
    return get(acting_row, joint);
  }
  /// What the last predict(), extend() or evaluate() left: of the joints
  /// followed the largest, infinity for NaN.
  struct Largest {
    bool tracks;   ///< tracks() of all
    double shift;  ///< |change of R| since the last predict(), over R sin b
    double error;  ///< error()
    double miss;   ///< of the acting moments, over sqrt(4 M_t^2 + floor^2)
    double moved;  ///< the same: their change by act(), 0 after predict()
    /// Over those changes: what M_t answered, and what is missed now.
    double contraction, gain;
  };
  const Largest& largest() const noexcept { return largest_; }
  /// @param floor  > 0, N m; 1e-100 at first
  void set_moment_floor(double floor) noexcept {
    moment_floor_ = floor * floor;
  }
  /// R of this joint answers to its own acting moment by s z x M_t, 1/m: in a
  /// node, whose joints have moments across the axis z to hold.
  void set_feedback(int joint, double s) noexcept;
  /// Changes the acting moments to those that will fit, each joint for itself:
  /// by its feedback and by what M_t answered to earlier changes (Broyden's
  /// update).
  void act() noexcept;
  /// What act() changed, N m; 0 of a joint that is not followed.
  Eigen::Vector3d action(int joint) const noexcept {
    return get(action_row, joint);
  }
  /// Keeps the acting moments, as the end of a stretch that began with the last
  /// ones kept.
  void remember() noexcept;
  /// Acting moments beyond that end, by this share of the stretch.
  void extrapolate(double share) noexcept;

 private:
  struct Values {
    double friction, sliding, spinning;
  };
  Values values(int joint, double force, SlipAxis axis) const noexcept;
  Values values(int joint, double force, SlipAxis axis,
                const FrictionIntegrals& integrals) const noexcept;
  void take(int joint, const Values& found) noexcept;
  bool set_window(int joint, double force) noexcept;
  void evaluate_contact(int joint) noexcept;
  void set_largest(const detail::FollowerLargest& found) noexcept;
  template <class F>
  void for_chosen(F f) noexcept;

  // Numbers of joints in packets of lanes, one row for each kind of number; the
  // rows that are asked for and set from outside come first.
  static constexpr int lanes = VectorRows::lanes;
  struct alignas(lanes * sizeof(double)) LaneRow {
    double of[lanes];
  };
  enum OuterRow {
    reaction_row = 0,
    rate_row = 3,
    moment_row = 6,
    acting_row = 9,
    action_row = 12,
    followed_row = 15
  };
  double* at(int row, int joint) noexcept {
    return numbers_[static_cast<unsigned>(joint) / lanes * row_count_ + row]
               .of +
           static_cast<unsigned>(joint) % lanes;
  }
  const double* at(int row, int joint) const noexcept {
    return numbers_[static_cast<unsigned>(joint) / lanes * row_count_ + row]
               .of +
           static_cast<unsigned>(joint) % lanes;
  }
  void set(int row, int joint, const Eigen::Vector3d& v) noexcept {
    double* const to = at(row, joint);
    to[0] = v.x();
    to[lanes] = v.y();
    to[2 * lanes] = v.z();
  }
  Eigen::Vector3d get(int row, int joint) const noexcept {
    const double* const from = at(row, joint);
    return {from[0], from[lanes], from[2 * lanes]};
  }
  VectorRows rows_from(int row) noexcept {
    return {at(row, 0), static_cast<std::ptrdiff_t>(row_count_) * lanes};
  }
  detail::FollowerRows all_rows() const noexcept;

  std::vector<JointContact> contacts_;
  std::vector<JointContact::Strength> strengths_;  // at speed 1
  const detail::FollowerKernel* kernel_;
  const detail::CapKernel* integrals_;
  unsigned row_count_;  // of a packet
  std::vector<LaneRow> numbers_;
  bool any_plain_ = false;    // contacts that need the exact integrals
  std::vector<char> smooth_;  // its law is, as far as it has been seen
  std::vector<char> chosen_;  // packets
  bool all_chosen_ = true;
  double moment_floor_ = 1e-200;  // squared
  Largest largest_{};
};

}  // namespace contact
