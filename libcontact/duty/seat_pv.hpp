#pragma once

#include <Eigen/Core>

#include "libcontact/seat/joint.hpp"

namespace contact {

/// p v of a joint whose seat ends: SeatJoint::pv(), and of a contact that
/// reaches no rim that of SlidingContact. NaN without a contact.
/// @param rate  Dw of the solution, rad/s, in the axes of the reaction
/// @param near  where the search for a contact at a rim begins; then that
///              contact, in the seat's axes
SeatPv seat_pv(const SeatJoint& joint, const SeatJointSolution& solution,
               const Eigen::Vector3d& rate, SeatState& near);

}  // namespace contact
