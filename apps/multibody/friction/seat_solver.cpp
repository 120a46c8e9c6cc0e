#include "multibody/friction/seat_solver.hpp"

#include <utility>

#include "multibody/system/kinematics.hpp"

namespace multibody {

using contact::JointSolution;
using contact::SeatJointSolution;
using Eigen::Matrix3d;
using Eigen::Vector3d;

SeatSolver::SeatSolver(std::shared_ptr<const contact::SeatJoint> seat,
                       const Link& link)
    : seat_(std::move(seat)),
      link_(link),
      is_carriers_(seat_->unbounded().contact().geometry().inner_body() ==
                   contact::JointBody::body) {}

void SeatSolver::set_state(const double* link_state, Memory& memory) const {
  if (!is_carriers_) return;
  memory.to_seat =
      relative_rotation(link_, link_state) * link_.axes.transpose();
}

// A confined contact has no axis of symmetry: numbers about one are left out,
// and the half-angle is half of its extent in the plane of the load.
JointSolution SeatSolver::in_body(const Memory& memory) const {
  const SeatJointSolution& s = memory.last;
  const Matrix3d to_body = memory.to_seat.transpose();
  JointSolution joint;
  joint.reaction = to_body * s.reaction;
  if (s.contact.status != contact::SeatStatus::ok) return joint;
  joint.status = contact::Status::ok;
  joint.evaluations = s.evaluations;
  joint.friction_force = to_body * s.friction_force;
  joint.friction_moment = to_body * s.friction_moment;
  joint.power = s.power;
  const Vector3d normal = joint.reaction - joint.friction_force;
  joint.normal_force = normal.norm();
  joint.normal = normal.normalized();
  joint.force_coefficient = joint.friction_force.norm() / joint.normal_force;
  joint.peak_pressure = s.contact.peak_pressure;
  joint.half_angle = (s.contact.upper_end - s.contact.lower_end) / 2;
  return joint;
}

JointSolution SeatSolver::slide(const contact::Joint::Slip& slip,
                                Memory& memory) const {
  memory.last =
      seat_->solve({.reaction = memory.to_seat * slip.reaction,
                    .angular_velocity = memory.to_seat * slip.angular_velocity},
                   memory.last);
  return in_body(memory);
}

contact::RestSolution SeatSolver::at_rest(const contact::Joint::Hold& hold,
                                          Memory& memory) const {
  contact::SeatRestSolution s =
      seat_->at_rest({.reaction = memory.to_seat * hold.reaction,
                      .moment = memory.to_seat * hold.moment});
  memory.last = std::move(s.slip);
  contact::RestSolution rest;
  rest.utilisation = s.utilisation;
  rest.direction = memory.to_seat.transpose() * s.direction;
  rest.slip = in_body(memory);
  return rest;
}

Vector3d SeatSolver::prox(const Matrix3d& inertia, const Vector3d& free,
                          const Memory& memory) const {
  const Matrix3d& to_seat = memory.to_seat;
  return to_seat.transpose() *
         seat_->moment_set(memory.last)
             .prox(to_seat * inertia * to_seat.transpose(), to_seat * free)
             .angular_velocity;
}

}  // namespace multibody
