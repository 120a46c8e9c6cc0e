#include "separation/simulation/compliant_stops.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "separation/case/system_of.hpp"
#include "separation/simulation/case_forces.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using multibody::BodyForce;
using multibody::BodyMotion;

// At most, of each body and of all that hangs on it, about its hinge.
std::vector<double> inertias_of(const Case& c) {
  std::vector<double> sums(c.bodies.size());
  for (const Body& end : c.bodies) {
    double far = 0;
    for (const Body* at = &end;; at = &c.bodies[at->hinge.on - 1]) {
      far += at->hinge.body_point.norm();
      sums[at - c.bodies.data()] +=
          end.rigid.inertia.norm() + end.rigid.mass * far * far;
      if (at->hinge.on == 0) break;
      far += at->hinge.parent_point.norm();
    }
  }
  return sums;
}

}  // namespace

Vector3d axis_of(const Hinge& hinge, const BodyMotion& parent,
                 const BodyMotion& body) {
  if (hinge.kind == multibody::HingeKind::axis) {
    return parent.rotation * hinge.axis;
  }
  const Vector3d from = parent.rotation * hinge.parent_direction;
  return from.cross(body.rotation * hinge.body_direction).normalized();
}

CompliantStops::CompliantStops(const Case& c, const History& history)
    : case_(c) {
  std::vector<double> inertias;
  for (int i = 0; i < static_cast<int>(c.bodies.size()); ++i) {
    const auto& stops = c.bodies[i].hinge.stops;
    if (history.release_of(i + 1, c) != History::not_yet) continue;
    for (std::size_t k = 0; k < stops.size(); ++k) {
      if (stops[k].is_rigid()) continue;
      if (inertias.empty()) inertias = inertias_of(c);
      active_.push_back(
          {i, &stops[k], history.touches[i][k],
           stops[k].damping * std::sqrt(stops[k].stiffness * inertias[i])});
    }
  }
}

CompliantStops::Push CompliantStops::push(
    const Active& active, std::span<const BodyMotion> bodies) const {
  const auto& [number, stop, touch, most] = active;
  const Hinge& hinge = case_.bodies[number].hinge;
  const BodyMotion& parent = bodies[hinge.on];
  const BodyMotion& body = bodies[1 + number];
  const double depth = -stop->gap(hinge_angle(hinge, parent, body));
  if (!(depth > 0)) return {0, Vector3d::Zero()};
  const Vector3d axis = axis_of(hinge, parent, body);
  const double rate =
      -stop->side * axis.dot(body.angular_velocity - parent.angular_velocity);
  const double elastic = stop->stiffness * depth;
  const double damping =
      touch > 0 ? std::min(elastic * stop->damping / touch, most) : most;
  return {std::max(0.0, elastic + damping * rate), axis};
}

void CompliantStops::add_forces(std::span<const BodyMotion> bodies,
                                std::span<BodyForce> forces) const {
  for (const Active& active : active_) {
    const auto [size, axis] = push(active, bodies);
    const Vector3d moment = active.stop->side * size * axis;
    forces[1 + active.body].moment += moment;
    forces[case_.bodies[active.body].hinge.on].moment -= moment;
  }
}

void CompliantStops::add_kinks(
    std::span<const BodyMotion> bodies,
    std::vector<multibody::KinkedVariable>& to) const {
  for (const Active& active : active_) {
    const Hinge& hinge = case_.bodies[active.body].hinge;
    to.push_back({hinge_angle(hinge, bodies[hinge.on], bodies[1 + active.body]),
                  {&active.stop->angle, 1}});
  }
}

double CompliantStops::moment(int body,
                              std::span<const BodyMotion> bodies) const {
  double sum = 0;
  for (const Active& active : active_) {
    if (active.body == body) sum += push(active, bodies).moment;
  }
  return sum;
}

}  // namespace separation
