#include "libcontact/duty/steps/seat_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace contact::detail {

SeatPath::Place SeatPath::place(const JointCycle& cycle,
                                const JointCycle::Instant& at) {
  const Eigen::Quaterniond to_seat = cycle.to_seat(at);
  return {at.solution.normal_force * (to_seat * cycle.sliding(at).centre()),
          to_seat * at.state.angular_velocity.stableNormalized()};
}

SeatPath::SeatPath(const JointCycle& cycle) {
  const double radius = cycle.contact().geometry().radius();
  for (const JointCycle::Instant& i : cycle.gauss_points()) {
    const double slid = i.weight * radius * i.state.angular_velocity.norm();
    if (!(slid > 0)) continue;
    places_.push_back(place(cycle, i));
    ends_.push_back(distance() + slid);
  }
  constexpr double rounding = 1e-9;
  stands_still_ = std::ranges::all_of(places_, [&](const Place& a) {
    const Place& b = places_.front();
    return (a.load - b.load).norm() <= rounding * b.load.norm() &&
           a.axis.cross(b.axis).norm() <= rounding;
  });
  keeps_direction_ = std::ranges::all_of(places_, [&](const Place& a) {
    const Eigen::Vector3d& b = places_.front().load;
    return a.load.cross(b).norm() <= rounding * a.load.norm() * b.norm();
  });
}

Eigen::Vector3d SeatPath::middle() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double before = 0;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    sum += (ends_[i] - before) * places_[i].load;
    before = ends_[i];
  }
  if (sum.norm() > 0) return sum.normalized();
  return Eigen::Vector3d::UnitZ();
}

double SeatPath::reach(const Eigen::Vector3d& middle) const {
  double largest = 0;
  for (const Place& place : places_) {
    const double angle =
        std::atan2(place.load.cross(middle).norm(), place.load.dot(middle));
    if (place.load.norm() > 0) largest = std::max(largest, angle);
  }
  return largest;
}

std::vector<SeatPath::Place> SeatPath::places(int count, int round) const {
  if (stands_still_) count = 1;
  double whole = 0;
  // Evenly over all rounds, however many there are.
  const double offset = std::modf(round / std::numbers::phi, &whole);
  std::vector<Place> found;
  for (int i = 0; i < count && !places_.empty(); ++i) {
    const auto at =
        std::ranges::lower_bound(ends_, (i + offset) / count * distance());
    found.push_back(places_[static_cast<std::size_t>(at - ends_.begin())]);
  }
  return found;
}

}  // namespace contact::detail
