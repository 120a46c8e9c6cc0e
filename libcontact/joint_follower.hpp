#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "libcontact/instruction_set.hpp"
#include "libcontact/joint_contact.hpp"
#include "libcontact/joint_solution.hpp"

namespace contact {

/// Friction of several sliding joints, side by side, followed through small
/// changes of R and Dw with one evaluation of each contact: for solvers of
/// several bodies, which evaluate all joints again and again.
///
/// What the last evaluation of a contact found, and the slopes that f, c_Y and
/// c_Z had over R_n and a, tell M_t for a new R and Dw, and how it changes with
/// R: predict(), then extend() for other R nearby. evaluate() looks whether it
/// is so, with one evaluation of each contact, puts right what was missed, and
/// improves the slopes (Broyden's update). error() says how wrong M_t is likely
/// to be.
///
/// For what SphericalJoint and CylindricalJoint solve in general this is no
/// substitute: it needs a solution to start from, R not too near to Dw, and
/// small changes. tracks() says whether it has all that.
///
/// R and Dw in any frame, for each joint another one if one likes; Dw of a pin
/// along its axis, R normal to it. No call but the constructor allocates or
/// throws.
class JointFollower {
 public:
  /// By the instruction set that suits so many joints.
  /// @param contacts  of balls and pins, with friction
  explicit JointFollower(std::vector<JointContact> contacts);
  /// @param set  a supported one
  JointFollower(std::vector<JointContact> contacts, InstructionSet set);

  int size() const { return static_cast<int>(contacts_.size()); }

  /// Begins to follow a joint, with two evaluations for its slopes.
  /// @param solution  of this joint, sliding
  /// @param rate      Dw for which it was found
  void start(int joint, const JointSolution& solution,
             const Eigen::Vector3d& rate) noexcept;
  /// No longer: the joint is left out of evaluate().
  void forget(int joint) noexcept { followed_[joint] = false; }
  bool follows(int joint) const { return followed_[joint]; }

  /// @param rate  Dw, rad/s, not 0
  void set_rate(int joint, const Eigen::Vector3d& rate) noexcept;
  /// @param reaction  R on the load, N, not 0
  void set_reaction(int joint, const Eigen::Vector3d& reaction) noexcept;

  /// M_t of all joints by the slopes, nothing evaluated.
  void predict() noexcept;
  /// The same for reactions close to those of the last predict(), Dw as it was
  /// there: a linear function of R.
  void extend() noexcept;
  /// M_t of all joints for reactions close to those of the last predict(), each
  /// contact evaluated once. extend() may follow.
  void evaluate() noexcept;

  /// Whether the last predict() or evaluate() stayed where the slopes are of
  /// use: moves of R, b, R_n, ... up to 10 %, no NaN, sin b above 0.01.
  bool tracks(int joint) const noexcept;
  /// |change of R| since the last predict(), over R sin b.
  double shift(int joint) const noexcept;
  /// M_t for R and Dw, N m.
  Eigen::Vector3d moment(int joint) const noexcept;
  /// After evaluate(), and extend(): what M_t is likely to be wrong by, over
  /// |M_t|, from how wrong the slopes were found lately: at most 0.53
  /// of it on 1200 random paths (joint_follower_test.cpp).
  double error(int joint) const noexcept;

 private:
  struct Values {
    double friction, sliding, spinning;
  };
  Values values(int joint, double force, SlipAxis axis) const noexcept;
  Values values(int joint, double force, SlipAxis axis,
                const FrictionIntegrals& integrals) const noexcept;
  void take(int joint, const Values& found) noexcept;
  void evaluate_plain() noexcept;
  static constexpr std::size_t batch_rows = 9;
  double* batch_row(int k) {
    return batch_numbers_.data() +
           static_cast<std::size_t>(k) * contacts_.size();
  }

  std::vector<JointContact> contacts_;
  std::vector<JointContact::Strength> strengths_;  // at speed 1
  std::vector<char> plain_;                        // the exact integrals alone
  int plain_count_ = 0;
  std::vector<char> followed_;
  InstructionSet set_;
  std::size_t stride_;
  std::vector<double> numbers_;
  std::vector<int> batch_joint_;
  std::vector<double> batch_numbers_;
};

}  // namespace contact
