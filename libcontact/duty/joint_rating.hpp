// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/joint/joint.hpp"

namespace contact {

/// SlidingContact::rating() of any solution of a joint. A contact at a rim of
/// its seat has no axis of symmetry, and p v, heat and nominal values alone:
/// places are at report_distance or more from rims, the heat flux is NaN.
/// @param rate  Dw, rad/s, in the frame of the solution
SlidingContact::Rating rating_of(const Joint& joint,
                                 const JointSolution& solution,
                                 const Eigen::Vector3d& rate);
/// The same, if Joint::pv() of a contact at a rim is known.
SlidingContact::Rating rating_of(const Joint& joint,
                                 const JointSolution& solution,
                                 const Eigen::Vector3d& rate,
                                 const ContactPv& pv);

}  // namespace contact
