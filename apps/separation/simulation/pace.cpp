#include "separation/simulation/pace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libcontact/base/units.hpp"
#include "separation/case/reading.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using multibody::BodyMotion;
using multibody::HingeMode;

// Mean inertia of a body about its hinge, or about its centre of mass.
double inertia_of(const Case& c, int body) {
  double inertia = c.rigid_body(body).inertia.trace() / 3;
  if (body > 0) {
    const Hinge& hinge = c.bodies[body - 1].hinge;
    inertia += c.rigid_body(body).mass * hinge.body_point.squaredNorm();
  }
  return inertia;
}

// The fastest of a force's rates, 1/s. Differences are for a small change of
// one number at a time: 1e-6 m and rad for position and rotation, above the
// rounding of positions; 1e-3 for velocities, in which forces have no kinks.
double rate_of(const Simulation& simulation, int force) {
  const auto sample = simulation.sample().motions();
  const auto now = simulation.force(force, sample);
  if (!now) return 0;
  const Case& c = simulation.of();
  const int body = c.forces[force].body;
  const double mass = c.rigid_body(body).mass;
  const double inertia = inertia_of(c, body);
  constexpr double place = 1e-6;
  constexpr double speed = 1e-3;
  double rate = std::sqrt(now->moment.norm() / inertia);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d unit = Vector3d::Unit(axis);
    const auto change = [&](const auto& move) {
      std::vector<BodyMotion> bodies(sample.begin(), sample.end());
      move(bodies[body]);
      const multibody::BodyForce then = *simulation.force(force, bodies);
      return std::pair((then.force - now->force).norm() / mass,
                       (then.moment - now->moment).norm() / inertia);
    };
    const auto raise = [&](double value) { rate = std::max(rate, value); };
    raise(change([&](BodyMotion& b) { b.velocity += speed * unit; }).first /
          speed);
    raise(change([&](BodyMotion& b) {
            b.angular_velocity += speed * unit;
          }).second /
          speed);
    raise(std::sqrt(
        change([&](BodyMotion& b) { b.position += place * unit; }).first /
        place));
    raise(std::sqrt(change([&](BodyMotion& b) {
                      b.rotation = rotation_of(place * unit) * b.rotation;
                    }).second /
                    place));
  }
  return rate;
}

std::string holder_text(const Simulation& simulation) {
  const int body = simulation.motion().held_by();
  if (body < 0) return {};
  const auto& sample = simulation.sample();
  const bool hinged = body > 0 && sample.mode(body - 1) != HingeMode::released;
  Vector3d rate = sample.motions()[body].angular_velocity;
  if (hinged) {
    const int on = simulation.of().bodies[body - 1].hinge.on;
    rate -= sample.motions()[on].angular_velocity;
  }
  return fmt::format(
      "; held by {}\"{}\" ({:.2g} deg/s)", hinged ? "the hinge of " : "",
      simulation.of().rigid_body(body).name, rate.norm() / contact::degree);
}

std::string force_text(const Simulation& simulation) {
  const auto& forces = simulation.of().forces;
  int fastest = -1;
  double rate = 0;
  for (int f = 0; f < static_cast<int>(forces.size()); ++f) {
    const double r = rate_of(simulation, f);
    if (!(r > rate)) continue;
    rate = r;
    fastest = f;
  }
  if (fastest < 0) return {};
  return fmt::format("; the fastest force is \"{}\" on \"{}\" ({:.1g} s)",
                     forces[fastest].name,
                     simulation.of().rigid_body(forces[fastest].body).name,
                     1 / rate);
}

}  // namespace

void Pace::note(const Simulation& simulation) {
  const double step = simulation.motion().last_step();
  // Steps of no length begin a motion; the last one before a time that is
  // asked for may be of any length, which says nothing.
  if (!(step > 0) || step >= shortest_) return;
  shortest_ = step;
  shortest_time_ = simulation.motion().step_begin();
}

std::string Pace::text(const Simulation& simulation) const {
  if (std::isinf(shortest_)) return "none has been made";
  return fmt::format(
      "the last step is {:.2g} s, the shortest {:.2g} s at t = {:.6g} s{}{}",
      simulation.motion().last_step(), shortest_, shortest_time_,
      holder_text(simulation), force_text(simulation));
}

}  // namespace separation
