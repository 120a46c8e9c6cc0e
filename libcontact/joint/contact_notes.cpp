#include "libcontact/joint/contact_notes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "libcontact/base/constants.hpp"

namespace contact {

double detail::load_direction(const SeatZone& zone,
                              const Eigen::Vector3d& load) {
  const Eigen::Vector3d axis(zone.axis()[0], zone.axis()[1], zone.axis()[2]);
  return std::atan2(axis.cross(load).norm(), axis.dot(load));
}

double rim_overlap(const JointContact& contact, const JointSolution& solution,
                   LoadDirection given) {
  const JointGeometry& geometry = contact.geometry();
  using detail::nan;
  if (geometry.seat() || !geometry.drawn_seat() ||
      !(solution.normal_force > 0)) {
    return nan;
  }
  const SeatZone& zone = *geometry.drawn_seat();
  if (given == LoadDirection::none ||
      (given == LoadDirection::angle && !zone.is_about_z())) {
    return nan;
  }
  const double direction =
      detail::load_direction(zone, geometry.side() * solution.normal);
  return -zone.margin(direction, solution.half_angle);
}

void ContactNotes::add(const Joint& joint, const JointSolution& solution,
                       LoadDirection direction) {
  largest_.add(solution.half_angle, solution.peak_pressure,
               rim_overlap(joint.contact(), solution, direction));
  if (const auto lie = joint.lie(solution)) {
    largest_.add(lie->largest_half_angle, lie->peak_pressure);
  }
  if (joint.is_endless() && !solution.work) return;
  for (std::string& note : joint.notes(solution)) {
    of_seat_.insert(std::move(note));
  }
}

void ContactNotes::add(const ContactNotes& more) {
  largest_.add(more.largest_);
  of_seat_.insert(more.of_seat_.begin(), more.of_seat_.end());
}

std::vector<std::string> ContactNotes::notes(const Joint& joint) const {
  std::vector<std::string> all = joint.contact().limits().notes(largest_);
  std::ranges::copy(of_seat_, std::back_inserter(all));
  return all;
}

}  // namespace contact
