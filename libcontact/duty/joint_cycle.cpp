#include "libcontact/duty/joint_cycle.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

CycleInstant checked(CycleInstant instant) {
  if (instant.solution.status == Status::ok) return instant;
  throw Error(detail::must_be(
      detail::message("the reaction at {:.6g} s, {:.6g} N", instant.time,
                      instant.state.reaction.norm()),
      "one for which the half-angle law and the pressure law have a value"));
}

}  // namespace

JointCycle::JointCycle(DutyCycle cycle, Joint joint)
    : cycle_(std::move(cycle)), joint_(std::move(joint)) {
  for (const double time : cycle_.times()) rows_.push_back(checked(at(time)));
  for (const auto& [time, weight] : cycle_.nodes(joint_.is_pin())) {
    nodes_.push_back(checked(at(time)));
    nodes_.back().weight = weight;
  }
}

CycleInstant JointCycle::at(double time) const noexcept {
  CycleInstant instant{time, 0, cycle_.at(time), {}};
  const CycleState& state = instant.state;
  instant.solution = joint_.solve({.reaction = state.reaction,
                                   .angular_velocity = state.angular_velocity,
                                   .axis = Eigen::Vector3d::UnitZ()});
  return instant;
}

double JointCycle::integral(const Quantity& quantity) const {
  double sum = 0;
  for (const CycleInstant& node : nodes_) sum += node.weight * quantity(node);
  return sum;
}

CycleInstant JointCycle::largest(const Quantity& quantity) const {
  const auto best = std::ranges::max_element(rows_, {}, quantity);
  const double first = cycle_.times().front();
  const double period = cycle_.period();
  const double before = best == rows_.begin() ? rows_.back().time - period
                                              : std::prev(best)->time;
  const double after =
      std::next(best) == rows_.end() ? first + period : std::next(best)->time;
  // Half the digits of a double: a maximum has no more.
  const double time =
      boost::math::tools::brent_find_minima(
          [&](double t) { return -quantity(at(t)); }, before, after, 26)
          .first;
  CycleInstant found = at(time < first ? time + period : time);
  return quantity(found) > quantity(*best) ? found : *best;
}

LargestContact JointCycle::largest_contact() const {
  const auto largest_of = [this](double JointSolution::*of) {
    return largest([of](const CycleInstant& i) {
             return i.solution.*of;
           }).solution.*
           of;
  };
  return {largest_of(&JointSolution::half_angle),
          largest_of(&JointSolution::peak_pressure)};
}

}  // namespace contact
