#pragma once

#include <Eigen/Core>
#include <memory>

#include "libcontact/joint/joint.hpp"
#include "libcontact/seat/joint.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

/// Friction of a ball hinge whose contact is confined to its seat, between body
/// axes and the axes of the body that has the seat. Where the contact is free,
/// which Memory::is_free() says after each call, the exact laws answer, not
/// this.
class SeatSolver {
 public:
  struct Memory {
    contact::SeatJointSolution last;
    /// Body axes to those of the seat.
    Eigen::Matrix3d to_seat = Eigen::Matrix3d::Identity();

    bool is_free() const { return last.contact.is_free; }
  };

  SeatSolver(std::shared_ptr<const contact::SeatJoint> seat, const Link& link);

  /// The seat turns against the body: a carrier's.
  void set_state(const double* link_state, Memory& memory) const;

  /// As Joint::solve().
  contact::JointSolution slide(const contact::Joint::Slip& slip,
                               Memory& memory) const;
  /// As Joint::at_rest(); its slip as of slide().
  contact::RestSolution at_rest(const contact::Joint::Hold& hold,
                                Memory& memory) const;
  /// As MomentSet::prox(), for the contact found last.
  Eigen::Vector3d prox(const Eigen::Matrix3d& inertia,
                       const Eigen::Vector3d& free, const Memory& memory) const;

 private:
  contact::JointSolution in_body(const Memory& memory) const;

  std::shared_ptr<const contact::SeatJoint> seat_;
  Link link_;
  bool is_carriers_;
};

}  // namespace multibody
