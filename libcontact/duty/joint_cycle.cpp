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
  std::vector<DutyCycle::GaussPoint> rows;
  rows.reserve(cycle_.times().size());
  for (const double time : cycle_.times()) rows.push_back({time, 0});
  rows_ = series(std::move(rows));
  gauss_points_ = series(cycle_.gauss_points(joint_.is_pin()));
}

JointCycle::Series JointCycle::series(
    std::vector<DutyCycle::GaussPoint> points) {
  // 8 MB: the Gauss points of some 1500 rows.
  constexpr std::size_t most_kept = 16'000;
  Series made;
  const bool keeps = points.size() <= most_kept;
  if (keeps) made.kept.reserve(points.size());
  for (const DutyCycle::GaussPoint& point : points) {
    const Instant instant = checked(at(point));
    if (point.weight > 0) add(instant);
    if (keeps) made.kept.push_back(instant);
  }
  made.points = std::move(points);
  return made;
}

void JointCycle::add(const Instant& instant) {
  const double weight = instant.weight;
  const SlidingContact slip = sliding(instant);
  const double speed =
      contact().geometry().radius() * instant.state.angular_velocity.norm();
  sums_.energy += weight * -instant.solution.power;
  sums_.sliding_path += weight * speed;
  sums_.effective_distance += weight * (speed * slip.slip_coefficient());
  sums_.moment += weight * instant.solution.friction_moment.norm();
  const double pv = weight * slip.pv_total();
  sums_.pv += pv;
  if (!(pv > 0)) return;
  const Eigen::Vector3d centre = to_seat(instant) * slip.centre();
  if (middle_.isZero(0)) first_ = centre;
  middle_ += pv * centre;
}

JointCycle::Instant JointCycle::instant(const Series& series,
                                        std::size_t i) const {
  return series.kept.empty() ? at(series.points[i]) : series.kept[i];
}

JointCycle::Instant JointCycle::at(
    const DutyCycle::GaussPoint& point) const noexcept {
  Instant instant = at(point.time);
  instant.weight = point.weight;
  return instant;
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
  return detail::integral_of(gauss_points(), quantity);
}

JointCycle::Instant JointCycle::largest(const Quantity& quantity) const {
  return detail::largest_of(
      rows(), cycle_.period(), [this](double time) { return at(time); },
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
  for (const Instant& row : rows()) {
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
  if (!(sums_.pv > 0)) return 0;
  // A contact that goes round has no middle: any place serves.
  constexpr double rounding = 1e-12;
  const Eigen::Vector3d middle =
      middle_.norm() > rounding * sums_.pv ? middle_.normalized() : first_;
  double squares = 0;
  for (const Instant& i : gauss_points()) {
    const SlidingContact slip = sliding(i);
    const double weight = i.weight * slip.pv_total();
    if (!(weight > 0)) continue;
    const double chord = (to_seat(i) * slip.centre() - middle).norm();
    const double angle = 2 * std::asin(std::min(chord / 2, 1.0));
    squares += weight * angle * angle;
  }
  return std::sqrt(squares / sums_.pv);
}

}  // namespace contact
