#pragma once

#include <Eigen/Core>

#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/joint/joint.hpp"

namespace contact {

/// SlidingContact::rating() of a solution of a joint, whatever its contact. One
/// without an axis of symmetry, at a rim of its seat, has what needs none:
/// p v, heat and nominal values; places are at report_distance or more from
/// rims, the heat flux is NaN.
/// @param rate  Dw, rad/s, in the frame of the solution
SlidingContact::Rating rating_of(const Joint& joint,
                                 const JointSolution& solution,
                                 const Eigen::Vector3d& rate);
/// The same where Joint::pv() of such a solution is known.
SlidingContact::Rating rating_of(const Joint& joint,
                                 const JointSolution& solution,
                                 const Eigen::Vector3d& rate,
                                 const ContactPv& pv);

}  // namespace contact
