#include "libcontact/duty/seat_pv.hpp"

#include "libcontact/duty/sliding_contact.hpp"

namespace contact {

SeatPv seat_pv(const SeatJoint& joint, const SeatJointSolution& solution,
               const Eigen::Vector3d& rate, SeatState& near) {
  if (solution.contact.status != SeatStatus::ok) return {};
  if (!solution.contact.is_free) return joint.pv(solution, rate, near);
  const Joint& unbounded = joint.unbounded();
  const SlidingContact sliding(unbounded.contact(),
                               unbounded.solve({.reaction = solution.reaction,
                                                .angular_velocity = rate}),
                               rate);
  const SlidingContact::Peak peak = sliding.largest_pv();
  return {sliding.pv_total(), peak.value, peak.place};
}

}  // namespace contact
