#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "libcontact/tracking/joint_follower.hpp"
#include "multibody/dynamics/dynamics.hpp"
#include "multibody/friction/hinge_solver.hpp"
#include "multibody/system/active_forces.hpp"

namespace multibody {

/// Friction of all hinges side by side, followed from evaluation to evaluation
/// (contact::JointFollower): moments as functions of the reactions nearby,
/// with one evaluation of every contact. Link axes. A start for nothing and
/// an answer as good as error() says; where it cannot follow the HingeSolvers
/// have to be asked.
class FrictionFollower {
 public:
  FrictionFollower(const std::vector<HingeFriction>& friction,
                   contact::InstructionSet set);

  /// From a hinge's last solution.
  /// @param rate  with which that was found
  void start(int hinge, const HingeSolver& solver, const Eigen::Vector3d& rate);
  void forget(int hinge);
  bool follows(int hinge) const;
  /// How many hinges it follows.
  int count() const { return count_; }

  void set_rate(int hinge, const Eigen::Vector3d& rate) {
    for (const Part& part : parts(hinge)) joints_.set_rate(part.joint, rate);
  }
  /// M_t that the motion has been worked out with (axis: along z).
  void set_acting_moment(int hinge, const Eigen::Vector3d& moment);
  Eigen::Vector3d acting_moment(int hinge) const {
    const std::span<const Part> all = parts(hinge);
    if (!hinges_[hinge].is_axis) return joints_.acting_moment(all[0].joint);
    double sum = 0;
    for (const Part& part : all) sum += joints_.acting_moment(part.joint).z();
    return {0, 0, sum};
  }

  /// Whether motion and joints exchange rows of vectors: every hinge has one
  /// joint.
  bool is_direct() const { return is_direct_; }
  /// Reactions that the motion causes.
  /// @param reactions  filled by Dynamics::reactions() unless is_direct()
  void take_reactions(const Dynamics& dynamics, std::span<const int> hinges,
                      std::span<Reaction<double>> reactions);

  /// The force on a hinge of one joint among them.
  Vec3<double> force(int hinge) const {
    const Eigen::Vector3d r = joints_.reaction(parts(hinge)[0].joint);
    return {r.x(), r.y(), r.z()};
  }

  /// Moments under them: see contact::JointFollower.
  void predict() { joints_.predict(); }
  void extend() { joints_.extend(); }
  void evaluate() { joints_.evaluate(); }

  /// From now on predict() and evaluate() are about joints whose moment is
  /// likely to be wrong by more than a share of it, or about all.
  void choose_worse_than(double share) { joints_.choose_worse_than(share); }
  void choose_all() { joints_.choose_all(); }

  /// Whether all are near enough to the last evaluation, how wrong they are,
  /// how far from the moments that act: of the joints the largest.
  const contact::JointFollower::Largest& largest() const {
    return joints_.largest();
  }
  /// That small moments count as, in it.
  void set_moment_floor(double floor) { joints_.set_moment_floor(floor); }
  /// Brings the moments that act to where they fit, as is expected.
  void act() { joints_.act(); }
  /// What that changed: the motion follows.
  /// @param change  of each hinge, filled unless is_direct()
  void move(Dynamics& dynamics, std::span<const int> hinges,
            std::span<Vec3<double>> change);
  /// See contact::JointFollower.
  void remember() { joints_.remember(); }
  void extrapolate(double share) { joints_.extrapolate(share); }

 private:
  struct Contacts;
  FrictionFollower(const std::vector<HingeFriction>& friction,
                   Contacts contacts, contact::InstructionSet set);

  struct Hinge {
    std::size_t first = 0;  ///< of its parts
    std::size_t count = 0;  ///< 0: cannot be followed
    bool is_axis = false;
    bool is_node = false;
  };
  /// A joint of a hinge; what it gets of the radial and axial force on a node,
  /// and of the moment held (JointNode::distribute()).
  struct Part {
    int joint;
    double radial, moment, axial;
  };
  std::span<const Part> parts(int hinge) const {
    const Hinge& h = hinges_[hinge];
    return {parts_.data() + h.first, h.count};
  }
  void set_shares(const contact::JointNode& node, const Hinge& hinge);
  void set_node_reactions(std::span<const Part> parts,
                          const Reaction<double>& reaction);

  std::vector<Hinge> hinges_;
  contact::JointFollower joints_;
  std::vector<Part> parts_;
  int count_ = 0;
  bool is_direct_;
};

}  // namespace multibody
