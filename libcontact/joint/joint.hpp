// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/moment_set.hpp"
#include "libcontact/joint/pin_lie.hpp"
#include "libcontact/joint/placement.hpp"
#include "libcontact/joint/rim_contact.hpp"
#include "libcontact/joint/solution.hpp"
#include "libcontact/joint/spec.hpp"

namespace contact {

class Joint;

namespace detail {
class ContactModel;
std::shared_ptr<const ContactMoments> moments_of(const Joint&,
                                                 const JointSolution&);
}  // namespace detail

/// Moment that a resting joint holds, see Joint::at_rest().
struct RestSolution {
  /// As the slip's; not_converged if no slip direction was found.
  Status status = Status::out_of_range;
  /// tau: the joint holds if it is <= 1, and M/tau is the most it holds in
  /// that direction. Infinite if there is no friction to hold a moment, NaN
  /// if out_of_range or no slip direction was found.
  double utilisation = 0;
  /// u, unit vector: the direction in which the joint would begin to slide;
  /// 0 if M = 0.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  /// The sliding about u (|Dw| = 1 rad/s) whose moment is M/tau: n, R_n,
  /// theta0. JointState::resting if M = 0.
  JointSolution slip;
  /// Sliding solutions that were needed.
  int solves = 0;
};

/// Friction of a ball in a seat or a pin in a hole under a known reaction.
///
/// The reaction R is the sum of the normal force R_n n and the friction force
/// R_t normal to it; n, R_n, the half-angle theta0 and the friction coefficient
/// depend on each other. docs/explanation/joint.md has the equations. A pin has
/// the ball's equation with R normal to Dw: b = 90 deg, a = 0.
///
/// A joint that is made from a spec with a seat that ends
/// (JointGeometry::seat()) is in it: docs/explanation/seats.md. Where the
/// contact of the laws `exact` stays inside the rims it answers, to the last
/// bit; else the contact of the seat is found, in 20 to 60 ms, and R_n n is the
/// sum of its pressures.
///
/// A pin that is made from a spec with a relief ends, slice by slice by the
/// exact law: docs/how-to/finite_pin.md; so does any pin whose Placement tilts
/// it, loads it at a place or slides it along its axis. Without dry friction, a
/// clearance, loading = centre and a wall with an end there are no slices: the
/// relief is left out, as a note of contact() says, and such a Placement has no
/// answer.
///
/// Frame: any, the same for all vectors; of a joint in a seat that ends the
/// axes of the body with the seat, or the axes of a Placement. R, R_t, M_t act
/// on the body; Dw is the angular velocity of the body relative to the carrier.
/// If the carrier has the ball or pin, n points from the joint's centre to the
/// contact's; if the body has it, away from it. Either way R_n n is the push on
/// the body.
///
/// A pin takes force normal to its axis only: the part of R along it is left
/// out, and JointSolution::reaction is the rest. Its axis is the unit vector
/// `axis`, with Dw along it, or, where that is 0, the direction of Dw or M; if
/// these are 0 too nothing is left out. A ball has no axis.
///
/// Solving does not throw, and does not allocate but where a contact ends. NaN
/// or infinity in R or Dw: NaN with out_of_range.
class Joint {
 public:
  /// @throws Error as JointSpec::contact(), and with a seat that ends as
  ///   SeatContact, for a friction stress, and for other laws than exact
  explicit Joint(const JointSpec& spec);
  /// The same, of several joints that share their laws and grids.
  Joint(const JointSpec& spec, SharedLaws& laws);
  /// Without a seat that ends.
  /// @throws Error for a geometry with one: JointSpec::without_seat() leaves it
  ///   out
  explicit Joint(JointContact contact);

  const JointContact& contact() const { return contact_; }
  bool is_pin() const { return contact_.geometry().kind() == JointKind::pin; }
  /// Not in a seat that ends, and no pin with a relief.
  bool is_endless() const { return !model_; }

  struct Slip {
    /// R on the body, N; 0 gives JointState::unloaded.
    Eigen::Vector3d reaction;
    /// Dw, rad/s; exactly 0 gives JointState::resting. The caller decides
    /// whether a joint rests, see at_rest().
    Eigen::Vector3d angular_velocity;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    /// Placement of the halves; null: the vectors are in the axes of the seat,
    /// and a pin is level.
    const Placement* placement = nullptr;
  };
  /// Friction under a reaction while the halves turn.
  /// @return |f/tan g - 1| <= 2e-13 (joint/ball_joint_test.cpp,
  ///         joint/pin_joint_test.cpp)
  JointSolution solve(const Slip& slip,
                      const SolveOptions& options = {}) const noexcept;
  /// The same, starting from a solution for a similar R and Dw.
  JointSolution solve(const Slip& slip, const JointSolution& last,
                      const SolveOptions& options = {}) const noexcept;

  struct KnownContact {
    /// R_n n on the body, N.
    Eigen::Vector3d normal_force;
    /// Dw, rad/s.
    Eigen::Vector3d angular_velocity;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    const Placement* placement = nullptr;  ///< as of Slip
  };
  /// Friction under a known normal force: nothing to solve. With R in
  /// its place it is the traditional estimate of friction.
  JointSolution solve_contact(const KnownContact& known) const noexcept;

  struct Hold {
    /// R on the body, N.
    Eigen::Vector3d reaction;
    /// M on the body that friction has to supply, N m; of a pin its part
    /// about the axis counts.
    Eigen::Vector3d moment;
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    const Placement* placement = nullptr;  ///< as of Slip
  };
  /// Decides whether the joint rests under R while holding the moment M, and
  /// how near it is to sliding.
  ///
  /// While a joint rests n is not known. Consistent with sliding, it holds
  ///
  ///     H(R) = { tau M_t(R, u) : |u| = 1, 0 <= tau <= 1 },
  ///
  /// M_t(R, u) the moment of solve(): the onset of slip and the limit of slow
  /// sliding agree. For a needed moment of a ball, M = tau M_t(R, u) is
  /// solved: by the symmetry about R one equation in the angle b of u and R.
  /// None of 10,000 random joints had more than one u; where the search is by
  /// intervals of b, the smallest tau of those that it tells apart is returned.
  /// A viscous joint holds no moment. One with a friction stress holds what
  /// tau(p, 0) holds; if tau falls with the speed there is no answer
  /// (JointContact::rest_refusal()).
  ///
  /// @return slip.friction_moment = M/tau, to 1e-12 of |M|/tau
  ///         (joint/joint_rest_test.cpp)
  RestSolution at_rest(const Hold& hold,
                       const SolveOptions& options = {}) const noexcept;
  /// The same, starting from an answer for a similar R and M; looks for one
  /// u only, the one close to the last.
  RestSolution at_rest(const Hold& hold, const RestSolution& last,
                       const SolveOptions& options = {}) const noexcept;

  /// The moments that the contact of a ball's solution holds at fixed n, R_n
  /// and theta0: what a solver of several bodies iterates on. The set refers
  /// to this joint and must not outlive it.
  MomentSet moment_set(const JointSolution& solution) const& noexcept {
    if (model_) [[unlikely]]
      return confined_moment_set(solution);
    return {contact_, solution.normal, solution.normal_force,
            solution.half_angle};
  }
  /// Deleted for temporaries: the set would refer to a destroyed joint.
  MomentSet moment_set(const JointSolution&) const&& = delete;

  /// The contact of a solution in a seat that ends, at its rims or free: polar
  /// angles from the seat's axis, vectors in the frame of the solution. None
  /// without a seat that ends and without load.
  std::optional<RimContact> rims(const JointSolution& solution) const;
  /// How the pin of a solution lies in its hole: of one with relief, or whose
  /// Placement asks for it. None of others.
  std::optional<PinLie> lie(const JointSolution& solution) const;
  /// p v over the contact of a solution; NaN without a contact.
  /// @param rate  Dw, rad/s, in the frame of the solution
  ContactPv pv(const JointSolution& solution,
               const Eigen::Vector3d& rate) const;
  /// At a rim of its seat, which the contact reaches.
  enum class RimPressure {
    infinite,  ///< as the model has it
    reported   ///< nearer than SeatEdge::report_distance the one at it
  };
  /// p at places, Pa: unit vectors from the joint's centre, of a pin normal to
  /// its axis, or of one that ends those to places of its surface, in the frame
  /// of the solution. 0 outside of the contact.
  std::vector<double> pressures(
      const JointSolution& solution, std::span<const Eigen::Vector3d> places,
      RimPressure at_rims = RimPressure::infinite) const;
  /// Why there is no solution, or what the model leaves out beside a rim: a
  /// sentence each.
  std::vector<std::string> notes(const JointSolution& solution) const;
  /// A solution from a table or of JointSolution::without_grid() with its grid,
  /// by which pv(), pressures() and moment_set() need no search; others as they
  /// are.
  /// @param near  a solution with a grid, from which this one is found faster
  JointSolution with_grid(const JointSolution& solution,
                          const JointSolution& near = {}) const;

  /// This joint with a table of the contacts that reach a rim, which are then
  /// read in some 20 us: SeatTable. Takes 7 to 20 s.
  /// @throws Error without a seat that ends, and as SeatTable
  Joint tabulated(const RimTableOptions& options) const;
  /// As above, from a table() of the same joint.
  Joint tabulated(std::string_view table) const;
  /// The table in bytes, for a file; "" without.
  std::string table() const;
  /// Errors of the table; none without.
  std::optional<RimTableCheck> table_check() const;

 private:
  friend std::shared_ptr<const detail::ContactMoments> detail::moments_of(
      const Joint&, const JointSolution&);
  JointSolution solve_from(const JointSolution::Memory& last, const Slip& slip,
                           const SolveOptions& options) const noexcept;
  JointSolution solve_confined(const Slip& slip, const JointSolution& last,
                               const SolveOptions& options) const noexcept;
  MomentSet confined_moment_set(const JointSolution& solution) const noexcept;
  Joint with_model(std::shared_ptr<const detail::ContactModel> model) const;

  JointContact contact_;
  /// The model of a contact that ends; null of others.
  std::shared_ptr<const detail::ContactModel> model_ = {};
  /// The model of a pin that is tilted by its Placement; null where there is
  /// none.
  std::shared_ptr<const detail::ContactModel> tilted_ = {};
};

inline JointSolution Joint::solve(const Slip& slip,
                                  const SolveOptions& options) const noexcept {
  if (model_ || slip.placement) [[unlikely]]
    return solve_confined(slip, {}, options);
  return solve_from({}, slip, options);
}
inline JointSolution Joint::solve(const Slip& slip, const JointSolution& last,
                                  const SolveOptions& options) const noexcept {
  if (model_ || slip.placement) [[unlikely]]
    return solve_confined(slip, last, options);
  return solve_from(last.memory, slip, options);
}

}  // namespace contact
