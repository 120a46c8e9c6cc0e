#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "libcontact/joint_follower.hpp"
#include "multibody/hinge_solver.hpp"
#include "multibody/loading.hpp"

namespace multibody {

/// Friction of all hinges side by side, followed from evaluation to evaluation
/// (contact::JointFollower): moments as functions of the reactions nearby,
/// with one evaluation of every contact. Load axes. A start for nothing and
/// an answer as good as error() says; where it cannot follow the HingeSolvers
/// have to be asked.
class FrictionFollower {
 public:
  explicit FrictionFollower(const std::vector<HingeFriction>& friction);

  /// From a hinge's last solution.
  /// @param rate  with which that was found
  void start(int hinge, const HingeSolver& solver, const Eigen::Vector3d& rate);
  void forget(int hinge);
  bool follows(int hinge) const;

  using Reactions = std::span<const Reaction<double>>;

  void set_rate(int hinge, const Eigen::Vector3d& rate);
  /// Moments under these reactions of all hinges: see contact::JointFollower.
  void predict(std::span<const int> hinges, Reactions reactions);
  /// In nodes the forces of the joints follow.
  void extend(std::span<const int> hinges, Reactions reactions);
  void evaluate(std::span<const int> hinges, Reactions reactions);

  /// Whether it is near enough to the last evaluation to be of use.
  bool tracks(int hinge) const;
  /// How far reactions are from those of predict().
  double shift(int hinge) const;
  /// M_t (axis: along z).
  Eigen::Vector3d moment(int hinge) const;
  /// What that is likely to be wrong by, over its size.
  double error(int hinge) const;

 private:
  struct Hinge {
    int first = 0;  ///< of its joints
    int count = 0;  ///< 0: cannot be followed
    bool is_axis = false;
    bool is_node = false;
    /// Sum of the parts of the joints' moments normal to the axis.
    double cross_x = 0;
    double cross_y = 0;
  };
  /// What a joint of a node gets of the radial and axial force, and of the
  /// moment held (JointNode::distribute()).
  struct Shares {
    double radial, moment, axial;
  };
  void set_shares(const contact::JointNode& node, int first);
  void set_reactions(std::span<const int> hinges, Reactions reactions);
  double take_cross_moments(std::span<const int> hinges);
  void settle_nodes(std::span<const int> hinges, Reactions reactions);

  std::vector<Hinge> hinges_;
  bool has_nodes_ = false;
  contact::JointFollower joints_;
  std::vector<Shares> shares_;  // of the joints
};

}  // namespace multibody
