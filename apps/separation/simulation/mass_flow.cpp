#include "separation/simulation/mass_flow.hpp"

#include <algorithm>
#include <cmath>

#include "separation/case/force_law.hpp"
#include "separation/simulation/case_forces.hpp"

namespace separation {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using multibody::BodyForce;
using multibody::BodyMass;
using multibody::BodyMotion;

namespace {

// The first time at which something is so that is so at `after`.
template <class Rule>
double first_time(double before, double after, const Rule& is_so) {
  for (;;) {
    const double middle = before + (after - before) / 2;
    if (!(before < middle && middle < after)) return after;
    (is_so(middle) ? after : before) = middle;
  }
}

// The first time at which so much has been burned, or not within the run.
double empty_time(const ForceLaw& law, double begin, double own, double until) {
  const Propellant& propellant = *law.propellant();
  const auto is_empty = [&](double time) {
    return law.impulse_until(time, begin, own) >=
           propellant.exhaust_speed * propellant.mass;
  };
  if (!(begin < until)) return History::not_yet;
  // The same wherever the run ends.
  double before = begin;
  double after = begin + 1;
  while (!is_empty(after)) {
    if (after > until) return History::not_yet;
    before = after;
    after += after - begin;
  }
  return first_time(before, after, is_empty);
}

}  // namespace

MassFlow::MassFlow(const Case& c, const History& history) : case_(c) {
  for (int f = 0; f < static_cast<int>(c.forces.size()); ++f) {
    const Force& force = c.forces[f];
    const Propellant* burnt = force.law->propellant();
    if (!burnt) continue;
    const RigidBody& body = c.rigid_body(force.body);
    const auto time_of = [&](const Clock& clock) {
      return history.time_of(clock, force.body, c);
    };
    Engine engine{f,
                  force.body,
                  force.law.get(),
                  time_of(force.begin),
                  time_of(force.end),
                  time_of(force.law->own_clock())};
    engine.empty = empty_time(*force.law, engine.begin, engine.own, c.end_time);
    // An end before the beginning burns nothing.
    engine.end = std::max(engine.begin, std::min(engine.end, engine.empty));
    engine.com = -burnt->empty_com.value_or(Vector3d::Zero()) / burnt->mass;
    engine.inertia = burnt->empty_inertia
                         ? (body.inertia - *burnt->empty_inertia) / burnt->mass
                         : Matrix3d(body.inertia / body.mass);
    engines_.push_back(engine);
    if (std::ranges::count(bodies_, force.body) == 0) {
      bodies_.push_back(force.body);
    }
  }
  spent_at_ = first_spent();
}

double MassFlow::Engine::rate(double time) const {
  if (!(time >= begin && time < end)) return 0;
  return law->thrust_at(time, begin, own) / law->propellant()->exhaust_speed;
}

double MassFlow::Engine::burned(double time) const {
  if (!(time > begin)) return 0;
  const Propellant& burnt = *law->propellant();
  return std::min(burnt.mass,
                  law->impulse_until(std::min(time, end), begin, own) /
                      burnt.exhaust_speed);
}

double MassFlow::empty_at(int force) const {
  const auto engine = std::ranges::find(engines_, force, &Engine::force);
  return engine != engines_.end() && engine->end == engine->empty
             ? engine->empty
             : History::not_yet;
}

BodyMass MassFlow::of(int number, double time) const {
  const RigidBody& body = case_.rigid_body(number);
  BodyMass mass{number, body.mass,        Vector3d::Zero(), body.inertia,
                0,      Vector3d::Zero(), Matrix3d::Zero()};
  for (const Engine& engine : engines_) {
    if (engine.body != number) continue;
    const double burned = engine.burned(time);
    const double rate = engine.rate(time);
    mass.mass -= burned;
    mass.com -= burned * engine.com;
    mass.inertia -= burned * engine.inertia;
    mass.mass_rate -= rate;
    mass.com_rate -= rate * engine.com;
    mass.inertia_rate -= rate * engine.inertia;
  }
  return mass;
}

void MassFlow::add_masses(double time, std::vector<BodyMass>& to) const {
  for (const int body : bodies_) to.push_back(of(body, time));
}

void MassFlow::add_forces(double time, std::span<const BodyMotion> bodies,
                          std::span<BodyForce> forces) const {
  for (const int number : bodies_) {
    const BodyMass mass = of(number, time);
    const BodyMotion& body = bodies[number];
    // Body axes.
    const Vector3d w = body.rotation.transpose() * body.angular_velocity;
    Vector3d flow = mass.mass * mass.com_rate;
    Vector3d moment = -mass.inertia_rate * w;
    for (const Engine& engine : engines_) {
      if (engine.body != number) continue;
      const Vector3d r = engine.law->where(case_, number).point - mass.com;
      const double q = engine.rate(time);
      flow += q * r;
      moment -= q * r.cross(w.cross(r));
    }
    forces[number].add_at(body, body.point(mass.com),
                          body.rotation * (-2 * w.cross(flow)));
    forces[number].moment += body.rotation * moment;
  }
}

double MassFlow::first_spent() const {
  // As good as all: a body without mass has no motion.
  constexpr double least = 1e-6;
  double first = History::not_yet;
  for (const int body : bodies_) {
    const auto is_spent = [&](double time) {
      return !(of(body, time).mass > least * case_.rigid_body(body).mass);
    };
    if (is_spent(case_.end_time)) {
      first = std::min(first, first_time(0, case_.end_time, is_spent));
    }
  }
  return first;
}

}  // namespace separation
