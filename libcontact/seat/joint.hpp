#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "libcontact/joint/joint.hpp"
#include "libcontact/seat/contact.hpp"
#include "libcontact/seat/moment_set.hpp"

namespace contact {

class SeatTable;

namespace detail {
class SeatSums;
struct SeatWork;
}  // namespace detail

/// Friction of a ball in a seat that ends, under a known reaction. All vectors
/// are in the axes of the reaction; forces and moments act on the body.
struct SeatJointSolution {
  /// The contact, with F, the force on the seat, in place of R. Its status is
  /// that of the whole: unless it is ok, all but R is NaN.
  SeatState contact;
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();  ///< R, N
  /// R_t, N: R = F + R_t if the carrier has the ball, else R = -F + R_t, to
  /// rounding.
  Eigen::Vector3d friction_force =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// M_t about the ball's centre, N m.
  Eigen::Vector3d friction_moment =
      Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  /// M_t . Dw, W; never positive.
  double power = std::numeric_limits<double>::quiet_NaN();
  /// |M_t|/(rho R)
  double moment_coefficient = std::numeric_limits<double>::quiet_NaN();
  double nominal_area = 0;  ///< SeatContact::nominal_area(), m^2
  int evaluations = 0;      ///< contacts that were found
};

/// Limit of rest of a ball in a seat that ends: how near it is to sliding.
struct SeatRestSolution {
  double utilisation = std::numeric_limits<double>::quiet_NaN();  ///< tau
  /// u, unit vector; 0 if M = 0.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  SeatJointSolution slip;  ///< about u at 1 rad/s, with the moment M/tau
};

/// A joint (docs/joint.md) whose seat ends: with the force F on the seat, any
/// vector, and s = 1 if the carrier has the ball, -1 if the body has it,
///
///     R = s F + R_t(F, Dw).
///
/// R_t is normal to Dw, but not to F, and M_t need not lie in the plane of
/// both. Vectors are in the axes of the body that has the seat, in which
/// JointGeometry::seat() gives its axis.
///
/// If the contact of the seat without end stays inside the rims, Joint answers
/// with the laws `exact`, to the last bit. Friction is dry or viscous.
///
/// Accuracy (seat/joint_test.cpp, by another program): docs/seat_joint.md.
class SeatJoint {
 public:
  /// @throws Error without a seat that ends or friction, for a friction stress,
  ///   and as SeatContact
  explicit SeatJoint(const JointSpec& joint)
      : SeatJoint(joint, SeatContact::Grid()) {}
  SeatJoint(const JointSpec& joint, const SeatContact::Grid& grid);
  ~SeatJoint();

  /// Contacts that the table covers are taken from it from now on.
  /// @param table  of contact()
  void use(std::shared_ptr<const SeatTable> table) {
    table_ = std::move(table);
  }

  /// R and Dw as of Joint. Where Dw is 0 friction is 0.
  SeatJointSolution solve(const Joint::Slip& slip) const {
    return solve(slip, {});
  }
  /// The same from a solution for a similar R and Dw.
  SeatJointSolution solve(const Joint::Slip& slip,
                          const SeatJointSolution& last) const;

  /// As Joint::at_rest(): M = tau M_t(R, u), tau infinite of viscous friction.
  /// NaN where no u was found.
  SeatRestSolution at_rest(const Joint::Hold& hold) const;

  /// The moments that the contact of a solution may have.
  SeatMomentSet moment_set(const SeatJointSolution& solution) const&;
  /// Would refer to a joint that is gone.
  SeatMomentSet moment_set(const SeatJointSolution&) const&& = delete;

  /// SeatContact::pressure() of a solution, Pa, at places: unit vectors from
  /// the ball's centre in the axes of the reaction. A contact that is from the
  /// table is solved for it.
  std::vector<double> pressures(const SeatJointSolution& solution,
                                std::span<const Eigen::Vector3d> places) const;

  /// The same at one place; nearer to a rim than the reported distance the
  /// pressure at that distance, which is finite. NaN of a contact from the
  /// table.
  double pressure_off_rims(const SeatJointSolution& solution,
                           const Eigen::Vector3d& place) const;

  /// SeatContact::pv() of a solution, in the axes of the reaction. A contact
  /// that is from the table is solved for it.
  /// @param near  where the search begins; then the contact that was found, in
  ///              the seat's axes
  SeatPv pv(const SeatJointSolution& solution, const Eigen::Vector3d& rate,
            SeatState& near) const;

  /// Whether the contact reaches no rim as long as friction is small: under
  /// the reaction alone.
  bool is_free(const Eigen::Vector3d& reaction) const;

  /// Notes on a solution, a sentence each: why there is none, or what the model
  /// leaves out beside a rim.
  std::vector<std::string> notes(const SeatJointSolution& solution) const;

  const SeatContact& contact() const { return contact_; }
  /// The joint in a seat without end.
  const Joint& unbounded() const { return joint_; }

 private:
  friend class SeatMomentSet;
  struct Pull {
    Eigen::Vector3d force, moment;
  };
  using Work = detail::SeatWork;
  SeatState in_seat(const SeatJointSolution& solution) const;
  SeatState on_grid(const SeatJointSolution& solution,
                    const SeatState& near) const;
  SeatJointSolution slide(const Joint::Slip& slip, Work& work) const;
  SeatRestSolution rest(const Joint::Hold& hold, Work& work) const;
  bool is_free(const JointSolution& s) const;
  SeatJointSolution free_solution(const JointSolution& s) const;
  Eigen::Vector3d start(const Eigen::Vector3d& force) const;
  bool find_contact(const Eigen::Vector3d& force, Work& work) const;
  Pull friction(const Work& work, const Eigen::Vector3d& rate) const;
  void set_ratios(SeatJointSolution& s, const Eigen::Vector3d& rate) const;
  void turn(SeatJointSolution& s) const;

  SeatContact contact_;
  Joint joint_;
  double side_;                // s
  Eigen::Matrix3d from_seat_;  // to the axes of the reaction
  std::unique_ptr<const detail::SeatSums> sums_;
  std::shared_ptr<const SeatTable> table_;
};

}  // namespace contact
