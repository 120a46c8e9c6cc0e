// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/thrust_face.hpp"

namespace contact {

/// Several joints on one axis.
///
/// Section 1.2 of the paper. The group passes a force R and a moment M normal
/// to its axis on to the body; the pole of M is position 0. Each joint takes a
/// force and no moment except friction:
///
///     R = sum R_j,  M = sum (z_j u x R_j + M_jt normal to u)
///
/// A ball takes any force, a pin forces normal to the axis u; a thrust face, if
/// there is one, takes the force along u beside pins alone. Two joints, one of
/// them a ball, or two pins and a face, are statically determinate. Friction
/// moments of balls have parts normal to the axis, which depend on R_j: the
/// distribution is repeated until it fits.
class JointGroup {
 public:
  /// One of the joints.
  struct Member {
    Joint joint;
    /// Place of its centre along the axis from the group's pole, m.
    double position;
  };

  /// How the joints of a statically indeterminate group share its force: as a
  /// rigid axis on springs would make them.
  struct Sharing {
    /// For each joint, any unit, > 0: radial forces follow springs of this
    /// stiffness under a rigid axis.
    std::vector<double> radial_stiffness;
    /// For each joint, >= 0, 0 for a pin, of sum 1: share of the force along
    /// the axis; all 0 beside a thrust face.
    std::vector<double> axial_share;

    /// Equal stiffnesses; the axial force shared equally by the balls.
    static Sharing equal(const std::vector<Member>& joints);
  };

  /// Friction of a group: the sum over its joints, and each of them.
  struct Solution {
    Status status = Status::out_of_range;
    /// Rounds of distribution and friction; change of the joints' radial forces
    /// in the last one, over the largest of them.
    int iterations = 0;
    double residual = 0;
    /// Sum of the joints' friction moments about the axis and the thrust
    /// face's, N m.
    double friction_moment = 0;
    /// The part of the thrust face, N m.
    double thrust_moment = 0;
    /// Parts of them normal to the axis, N m: they load the group's moment
    /// balance.
    Eigen::Vector3d cross_moment = Eigen::Vector3d::Zero();
    /// W, never positive.
    double power = 0;
    std::vector<JointSolution> joints;
  };

  /// @throws Error if there is neither a ball nor a thrust face to take the
  ///         axial force, or both, fewer than two joints or two at one place,
  ///         or if the group is statically indeterminate and no rule is given.
  explicit JointGroup(std::vector<Member> joints,
                      std::optional<Sharing> rule = {},
                      std::optional<ThrustFace> thrust_face = {});

  const std::vector<Member>& joints() const { return joints_; }
  const std::optional<ThrustFace>& thrust_face() const { return thrust_face_; }

  /// A solution with room for the joints: solve() then does not allocate.
  Solution make_solution() const;

  struct Slip {
    /// R on the body, N.
    Eigen::Vector3d reaction;
    /// M on the body about the pole, N m; its part along the axis is left out.
    Eigen::Vector3d moment;
    /// u, unit vector.
    Eigen::Vector3d axis;
    /// rad/s about the axis; exactly 0: all joints rest.
    double angular_velocity;
  };
  /// Friction under R and M while the body turns about the axis.
  /// @param solution  from make_solution() or an earlier call, which is then
  ///                  the start; then the result, which reproduces R and M
  ///                  to 1e-12 of |R| and |R| x distance (joint/group_test.cpp)
  void solve(const Slip& slip, Solution& solution) const noexcept;

  /// Load of one joint: share `force` of R and `moment` of M x u normal to the
  /// axis, M less the parts of the joints' friction moments normal to the axis;
  /// share `axial` of R along it.
  struct Share {
    double force;
    double moment;  ///< 1/m
    double axial;
  };
  const std::vector<Share>& shares() const { return shares_; }

  struct Hold {
    /// R and M as in Slip.
    Eigen::Vector3d reaction;
    Eigen::Vector3d moment;
    Eigen::Vector3d axis;
    /// About the axis, N m.
    double needed;
  };
  /// |needed|/(the moment of sliding that opposes it): the group holds the
  /// moment `needed` at rest if this is <= 1. Viscous joints hold nothing. NaN
  /// if a joint has a friction stress.
  /// @param solution  as for solve(); the incipient sliding
  double utilisation(const Hold& hold, Solution& solution) const noexcept;

 private:
  std::vector<Member> joints_;
  std::vector<Share> shares_;
  std::optional<ThrustFace> thrust_face_;
};

}  // namespace contact
