#include "libcontact/duty/joint_rating.hpp"

#include <cmath>

#include "libcontact/base/constants.hpp"

namespace contact {

SlidingContact::Rating rating_of(const Joint& joint, const JointSolution& s,
                                 const Eigen::Vector3d& rate) {
  const bool is_round = !std::isnan(s.half_angle);
  return rating_of(joint, s, rate, is_round ? ContactPv() : joint.pv(s, rate));
}

SlidingContact::Rating rating_of(const Joint& joint, const JointSolution& s,
                                 const Eigen::Vector3d& rate,
                                 const ContactPv& pv) {
  const JointContact& contact = joint.contact();
  SlidingContact::Rating rating = SlidingContact(contact, s, rate).rating();
  if (s.status != Status::ok || !std::isnan(s.half_angle)) return rating;
  using detail::nan;
  rating.pv = {pv.largest, nan, pv.place};
  rating.heat_flux = {nan, nan, Eigen::Vector3d::Constant(nan)};
  rating.pv_mean = pv.total / s.contact_area;
  rating.pv_total = pv.total;
  rating.heat = -s.power;
  const double speed = contact.geometry().radius() * rate.norm();
  const bool turns = speed > 0 || pv.total == 0;  // else along the axis alone
  rating.slip_coefficient = turns ? pv.total / (speed * s.normal_force) : nan;
  rating.slides = pv.total > 0;
  return rating;
}

}  // namespace contact
