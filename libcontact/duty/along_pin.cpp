#include "libcontact/duty/along_pin.hpp"

#include <cmath>

#include "libcontact/base/constants.hpp"

namespace contact {

using detail::pi;
using Eigen::Vector2d;

AlongPin::AlongPin(const JointCycle& cycle, const JointSpec& pin)
    : pin_(pin), period_(cycle.cycle().period()) {
  const double side = pin.geometry.side();
  for (const auto& points : {cycle.rows(), cycle.gauss_points()}) {
    for (const JointCycle::Instant& i : points) {
      const JointSolution& s = i.solution;
      if (s.state != JointState::sliding) continue;
      const auto lie = cycle.joint().lie(s);
      const Vector2d force = side * s.normal_force * s.normal.head<2>();
      const Eigen::Quaterniond& turn = i.state.turn;
      slid_.push_back({i.time, i.weight,
                       pin_.slip_speed({i.state.angular_velocity.z()}),
                       2 * std::atan2(turn.z(), turn.w()),
                       lie ? pin_.at(lie->shift.head<2>(), lie->tilt.head<2>())
                           : pin_.under(force, Vector2d::Zero())});
    }
  }
}

AlongPin::Place AlongPin::at(double z) const {
  Place found{0, detail::nan, 0, 0};
  for (const Slid& i : slid_) {
    const FinitePin::Slice s = pin_.slice(i.contact, z);
    if (!(s.force > 0)) continue;
    const double pv = s.peak * i.slip_speed;
    if (pv > found.largest_pv) {
      found.largest_pv = pv;
      found.time = i.time;
    }
    found.mean_pv += i.weight * pv / period_;
    found.pv_per_length += i.weight * i.slip_speed * s.force * s.force_ratio;
  }
  return found;
}

std::vector<double> AlongPin::pv_integrals(JointBody body, double z,
                                           int count) const {
  const auto size = static_cast<std::size_t>(count);
  std::vector<double> sums(size), theta(size), p(size);
  for (const Slid& i : slid_) {
    if (!(i.weight > 0)) continue;
    const double turn = body == JointBody::body ? i.turn : 0;
    for (std::size_t k = 0; k < size; ++k) {
      theta[k] = 2 * pi * static_cast<double>(k) / count - pi + turn;
    }
    pin_.pressures(i.contact, z, theta, p);
    for (std::size_t k = 0; k < size; ++k) {
      sums[k] += i.weight * i.slip_speed * p[k];
    }
  }
  return sums;
}

}  // namespace contact
