#include "separation/simulation/case_forces.hpp"

#include <algorithm>
#include <cmath>

#include "separation/case/system_of.hpp"

namespace separation {
namespace {

using Eigen::Vector3d;
using multibody::BodyForce;
using multibody::BodyMotion;

// Everything about one force at one instant.
struct Instant {
  double time;   // of the motion
  double begin;  // of the force
  double cutoff;
  int body;
  const Case& c;
  std::span<const BodyMotion> bodies;
  std::span<BodyForce> forces;

  const BodyMotion& on() const { return bodies[body]; }
  BodyForce& force() const { return forces[body]; }
};

// Where a table is read, and what its rows count from.
struct Place {
  double x;
  double origin;
};
Place place_in(Variable over, const Instant& at) {
  switch (over) {
    case Variable::time:
      return {at.time, at.begin};
    case Variable::angle:
      return {
          hinge_angle(at.c.bodies[at.body - 1].hinge, at.bodies[0], at.on()),
          0};
    case Variable::none:
      break;
  }
  return {0, 0};
}

void add_what(const AppliedForce& f, const Instant& at) {
  const BodyMotion& body = at.on();
  const auto [x, origin] = place_in(f.variable, at);
  Vector3d force = f.force(x, origin);
  Vector3d moment = f.moment(x, origin);
  if (!f.inertial) {
    force = body.rotation * force;
    moment = body.rotation * moment;
  }
  at.force().add_at(body, body.point(f.point), force);
  at.force().moment += moment;
}

void add_what(const Motor& f, const Instant& at) {
  const auto [x, origin] = place_in(f.variable, at);
  const Vector3d moment =
      f.moment(x, origin) *
      (at.bodies[0].rotation * at.c.bodies[at.body - 1].hinge.axis);
  at.force().moment += moment;
  at.forces[0].moment -= moment;
}

void add_what(const Thrust& f, const Instant& at) {
  double part = 1;
  if (at.time >= at.cutoff) {
    part = f.decay > 0 ? std::exp((at.cutoff - at.time) / f.decay) : 0;
  }
  const BodyMotion& body = at.on();
  at.force().add_at(body, body.point(f.point),
                    body.rotation * (part * f.force));
}

// Between the body and the carrier, along one line: momentum is kept.
void add_between(const Instant& at, const Vector3d& point,
                 const Vector3d& on_body) {
  at.force().add_at(at.on(), point, on_body);
  at.forces[0].add_at(at.bodies[0], point, -on_body);
}

void add_what(const Spring& f, const Instant& at) {
  const BodyMotion& body = at.on();
  const BodyMotion& carrier = at.bodies[0];
  const Vector3d end = body.point(f.point);
  const Vector3d line = end - carrier.point(f.carrier_point);
  const double length = line.norm();
  if (length == 0) return;
  const Vector3d unit = line / length;
  const double rate = unit.dot(body.point_velocity(f.point) -
                               carrier.point_velocity(f.carrier_point));
  add_between(
      at, end,
      (f.stiffness * (f.free_length - length) - f.damping * rate) * unit);
}

void add_what(const Pusher& f, const Instant& at) {
  const double used = stroke_used(f, at.body, at.bodies);
  const double part = std::clamp(used / f.stroke, 0.0, 1.0);
  const double force = f.first_force + part * (f.last_force - f.first_force);
  add_between(at, at.on().point(f.point),
              at.bodies[0].rotation * (force * f.direction));
}

// Linear between the pressures of the tables, constant outside.
double coefficient(const std::vector<double>& pressures,
                   const std::vector<Table<double>>& tables, double pressure,
                   double angle) {
  std::size_t i = 0;
  while (i < pressures.size() && pressures[i] < pressure) ++i;
  if (i == 0) return tables.front()(angle);
  if (i == pressures.size()) return tables.back()(angle);
  const double part =
      (pressure - pressures[i - 1]) / (pressures[i] - pressures[i - 1]);
  return (1 - part) * tables[i - 1](angle) + part * tables[i](angle);
}

void add_what(const Aerodynamic& f, const Instant& at) {
  const BodyMotion& body = at.on();
  Vector3d flow = f.flow;
  double pressure = 0;
  if (f.density > 0) {
    const Vector3d air = f.wind - body.point_velocity(f.point);
    const double speed = air.norm();
    if (speed == 0) return;
    flow = air / speed;
    pressure = f.density * speed * speed / 2;
  } else {
    if (f.dynamic_pressure.at.empty()) return;
    pressure = f.dynamic_pressure(at.time, at.begin);
  }
  const Vector3d axis = body.rotation * f.axis;
  const Vector3d across = flow - flow.dot(axis) * axis;
  const double sine = across.norm();
  const double angle = std::atan2(sine, -flow.dot(axis));
  const Vector3d normal =
      sine > 0 ? Vector3d(across / sine) : Vector3d(Vector3d::Zero());
  const auto c = [&](const std::vector<Table<double>>& tables) {
    return coefficient(f.pressures, tables, pressure, angle);
  };
  const double force = pressure * f.area;
  at.force().add_at(body, body.point(f.point),
                    force * (c(f.normal) * normal - c(f.axial) * axis));
  at.force().moment += force * f.length * c(f.moment) * axis.cross(normal);
}

// Times at which the rows of a table have kinks and jumps.
void add_rows(const std::vector<double>& at, double begin,
              std::vector<double>& breaks) {
  for (const double x : at) breaks.push_back(begin + x);
}

}  // namespace

double History::time_of(const Clock& clock, int body, const Case& c) const {
  if (clock.event < 0) return clock.time;
  const auto& times = events[clock.event];
  const auto& bodies = c.events[clock.event].bodies;
  const bool own = body > 0 && std::find(bodies.begin(), bodies.end(),
                                         body - 1) != bodies.end();
  const double event =
      own ? times[body - 1] : *std::min_element(times.begin(), times.end());
  return event + clock.delay;
}

double History::release_of(int body, const Case& c) const {
  double first = not_yet;
  for (std::size_t e = 0; body > 0 && e < c.events.size(); ++e) {
    if (c.events[e].action == Event::Action::break_hinge) {
      first = std::min(first, events[e][body - 1]);
    }
  }
  return first;
}

double stroke_used(const Pusher& pusher, int body,
                   std::span<const BodyMotion> bodies) {
  const BodyMotion& carrier = bodies[0];
  const Vector3d line =
      bodies[body].point(pusher.point) - carrier.point(pusher.carrier_point);
  return line.dot(carrier.rotation * pusher.direction);
}

CaseForces::CaseForces(const Case& c, const History& history) : case_(c) {
  for (std::size_t i = 0; i < c.forces.size(); ++i) {
    const Force& force = c.forces[i];
    if (history.spent[i]) continue;
    const auto* thrust = std::get_if<Thrust>(&force.what);
    const auto* motor = std::get_if<Motor>(&force.what);
    const double end = history.time_of(force.end, force.body, c);
    const double off =
        motor != nullptr ? history.release_of(force.body, c) : History::not_yet;
    const Active active{
        &force, history.time_of(force.begin, force.body, c), std::min(end, off),
        thrust != nullptr ? history.time_of(thrust->cutoff, force.body, c)
                          : History::not_yet};
    if (std::isinf(active.begin)) continue;
    active_.push_back(active);
    breaks_.insert(breaks_.end(), {active.begin, active.end, active.cutoff});
    if (const auto* applied = std::get_if<AppliedForce>(&force.what);
        applied != nullptr && applied->variable == Variable::time) {
      add_rows(applied->force.at, active.begin, breaks_);
      add_rows(applied->moment.at, active.begin, breaks_);
    }
    if (motor != nullptr && motor->variable == Variable::time) {
      add_rows(motor->moment.at, active.begin, breaks_);
    }
    if (const auto* air = std::get_if<Aerodynamic>(&force.what)) {
      add_rows(air->dynamic_pressure.at, active.begin, breaks_);
    }
  }
  std::sort(breaks_.begin(), breaks_.end());
}

void CaseForces::add(const Active& active, double time,
                     std::span<const BodyMotion> bodies,
                     std::span<BodyForce> forces) const {
  if (!active.is_on(time)) return;
  const Instant at{time,  active.begin, active.cutoff, active.force->body,
                   case_, bodies,       forces};
  std::visit([&](const auto& what) { add_what(what, at); }, active.force->what);
}

void CaseForces::add_forces(double time, std::span<const BodyMotion> bodies,
                            std::span<BodyForce> forces) const {
  for (const Active& active : active_) add(active, time, bodies, forces);
}

std::optional<BodyForce> CaseForces::of(
    int force, double time, std::span<const BodyMotion> bodies) const {
  const Force* wanted = &case_.forces[force];
  const auto active = std::find_if(
      active_.begin(), active_.end(),
      [&](const Active& a) { return a.force == wanted && a.is_on(time); });
  if (active == active_.end()) return {};
  std::vector<BodyForce> forces(bodies.size());
  add(*active, time, bodies, forces);
  return forces[wanted->body];
}

double CaseForces::next_break(double time) const {
  const auto next = std::upper_bound(breaks_.begin(), breaks_.end(), time);
  return next == breaks_.end() ? History::not_yet : *next;
}

}  // namespace separation
