#include "libcontact/duty/joint_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/duty/over_cycle.hpp"
#include "libcontact/joint/contact_notes.hpp"

namespace contact {
namespace {

JointCycle::Instant checked(JointCycle::Instant instant) {
  if (instant.solution.status == Status::ok) return instant;
  throw Error(detail::must_be(
      detail::message("the reaction at {:.6g} s, {:.6g} N", instant.time,
                      instant.state.reaction.norm()),
      "one for which the half-angle law and the pressure law have a value"));
}

}  // namespace

JointCycle::JointCycle(DutyCycle cycle, Joint joint)
    : cycle_(std::move(cycle)), joint_(std::move(joint)) {
  // They are large: of long cycles a vector that grows would take half as much
  // again.
  rows_.reserve(cycle_.times().size());
  for (const double time : cycle_.times()) rows_.push_back(checked(at(time)));
  const auto points = cycle_.gauss_points(joint_.is_pin());
  gauss_points_.reserve(points.size());
  for (const auto& [time, weight] : points) {
    gauss_points_.push_back(checked(at(time)));
    gauss_points_.back().weight = weight;
  }
}

JointCycle::Instant JointCycle::at(double time) const noexcept {
  Instant instant{time, 0, cycle_.at(time), {}};
  const DutyCycle::State& state = instant.state;
  instant.solution = joint_.solve({.reaction = state.reaction,
                                   .angular_velocity = state.angular_velocity,
                                   .axis = Eigen::Vector3d::UnitZ()});
  return instant;
}

double JointCycle::integral(const Quantity& quantity) const {
  return detail::integral_of(gauss_points_, quantity);
}

JointCycle::Instant JointCycle::largest(const Quantity& quantity) const {
  return detail::largest_of(
      rows_, cycle_.period(), [this](double time) { return at(time); },
      quantity);
}

LargestContact JointCycle::largest_contact() const {
  const auto largest_of = [this](double JointSolution::*of) {
    return largest([of](const JointCycle::Instant& i) {
             return i.solution.*of;
           }).solution.*
           of;
  };
  LargestContact all{largest_of(&JointSolution::half_angle),
                     largest_of(&JointSolution::peak_pressure)};
  for (const Instant& row : rows_) {
    JointSolution in_seat = row.solution;
    in_seat.normal = to_seat(row) * in_seat.normal;
    all.add(0, 0, rim_overlap(contact(), in_seat));
  }
  return all;
}

Eigen::Quaterniond JointCycle::to_seat(const Instant& instant) const {
  return contact().geometry().inner_body() == JointBody::carrier
             ? instant.state.turn.conjugate()
             : Eigen::Quaterniond::Identity();
}

double JointCycle::contact_spread() const {
  struct Place {
    Eigen::Vector3d centre;
    double weight;
  };
  std::vector<Place> places;
  Place sum{Eigen::Vector3d::Zero(), 0};
  for (const Instant& i : gauss_points_) {
    const SlidingContact slip = sliding(i);
    Place place{slip.centre(), i.weight * slip.pv_total()};
    if (!(place.weight > 0)) continue;
    place.centre = to_seat(i) * place.centre;
    sum.centre += place.weight * place.centre;
    sum.weight += place.weight;
    places.push_back(place);
  }
  if (places.empty()) return 0;
  // A contact that goes round has no middle: any place serves.
  constexpr double rounding = 1e-12;
  const Eigen::Vector3d middle = sum.centre.norm() > rounding * sum.weight
                                     ? sum.centre.normalized()
                                     : places[0].centre;
  double squares = 0;
  for (const auto& [centre, weight] : places) {
    const double chord = (centre - middle).norm();
    const double angle = 2 * std::asin(std::min(chord / 2, 1.0));
    squares += weight * angle * angle;
  }
  return std::sqrt(squares / sum.weight);
}

}  // namespace contact
