#include "multibody/motion/equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "multibody/system/eigen_conversion.hpp"

namespace multibody {

using Eigen::Vector3d;

namespace {

CarrierAcceleration<double> driven(const CarrierDrive& drive,
                                   const Vector3d& gravity,
                                   const double* state) {
  const double* q = state + StateLayout::rotation;
  const Mat3<double> r = rotation(Quaternion<double>{q[0], q[1], q[2], q[3]});
  const Vector3d linear = drive.acceleration - gravity;
  return {transposed_times(r, vec3(linear)), vec3(drive.angular_acceleration)};
}

// Without a force model.
void clear(ActiveForces<double>& forces) {
  forces.carrier = {};
  for (LinkForces<double>& body : forces.bodies) body = {};
}

// Power that mass flow adds to a body's kinetic and potential energy: m' v^2/2
// + m v (w x c') + w I' w/2 - g (m c)', at its centre of mass.
double flow_power(const BodyMass& mass, const BodyMotion& body,
                  const Vector3d& gravity) {
  const Vector3d v = body.point_velocity(mass.com);
  const Vector3d w = body.rotation.transpose() * body.angular_velocity;
  const Vector3d moves = body.rotation * mass.com_rate;
  return 0.5 *
             (mass.mass_rate * v.squaredNorm() + w.dot(mass.inertia_rate * w)) +
         mass.mass * v.dot(body.angular_velocity.cross(moves)) -
         gravity.dot(mass.mass_rate * body.point(mass.com) + mass.mass * moves);
}

}  // namespace

Equations::Equations(const System& motion_system,
                     std::vector<HingeFriction> friction,
                     std::shared_ptr<const ForceModel> force_model,
                     const MotionOptions& options)
    : losses(motion_system.size()),
      system(motion_system),
      gravity(options.gravity),
      drive(options.carrier_drive),
      coupled(system,
              friction.empty() ? std::vector<HingeFriction>(system.size())
                               : std::move(friction),
              options.coupling),
      memory(coupled.beginning()),
      forces(std::move(force_model)),
      held_units_(size()),
      here_(system),
      aside_(memory) {
  for (const HingeStop& stop : options.stops) {
    coupled.add_stop(stop, system.links()[stop.body]);
  }
}

int Equations::owner_of(int number) const {
  if (number < 0 || number == work_at()) return -1;
  if (number > work_at()) return 1 + number - held_at(0);
  if (number >= dissipated_at(0)) return 1 + number - dissipated_at(0);
  int body = 0;
  while (body < size() && number >= offset(body)) ++body;
  return body;
}

// Units of the numbers for each hinge: the forces and moments held now.
void Equations::set_held_units() {
  Hinges at = coupled.at(memory, here_.friction);
  held_units_.assign(size(), {});
  double force = 0;
  for (int i = 0; i < size(); ++i) {
    force = std::max(force, vec3(at.reaction(i).force).norm());
  }
  const CoupledRounding rounding = at.rounding();
  for (int i = 0; i < size(); ++i) {
    const Reaction<double>& r = at.reaction(i);
    // Forces that are tiny in the system, or mostly rounding, need not be
    // followed.
    const double own =
        vec3(r.force).norm() + 1e-3 * force + 1e6 * rounding.force;
    held_units_[i].force = own > 0 ? own : 1;
    held_units_[i].moment =
        vec3(r.moment).norm() +
        1e-2 * held_units_[i].force * std::max(system.links()[i].arm, 1e-2);
  }
}

double Equations::held_rate(int body, Hinges& at) const {
  if (modes()[body] != JointMode::held) return 0;
  const Reaction<double>& r = at.reaction(body);
  return (r.force.x + r.force.y + r.force.z) / held_units_[body].force +
         (r.moment.x + r.moment.y + r.moment.z) / held_units_[body].moment;
}

void Equations::begin_at(double time, const double* state) {
  next_break = break_after(time);
  held_units_.assign(size(), {});
  std::vector<double> unused(number_count());
  if (rates_aside(time, state, unused.data())) set_held_units();
}

double Equations::break_after(double time) const {
  return forces ? forces->next_break(time)
                : std::numeric_limits<double>::infinity();
}

double Equations::before_break(double time) const {
  return time < next_break ? time : std::nextafter(next_break, time - 1);
}

bool Equations::rates_in_step(double time, const double* state, double* to) {
  const double seen = before_break(time);
  const bool found = rates(seen, state, memory, here_, to);
  const CoupledReport& report = here_.friction.report;
  ++evaluations;
  outer_iterations += report.iterations;
  unproven += report.others_possible;
  if (!found) {
    failed_report = report;
    failed_time = seen;
  }
  return found;
}

bool Equations::rates_aside(double time, const double* state, double* to) {
  aside_ = memory;
  return rates(before_break(time), state, aside_, here_, to);
}

// The forces at this state come from an evaluation of it.
CoupledReport Equations::resolve_rest(double time, const double* state,
                                      bool due) {
  std::vector<double> unused(number_count());
  Evaluation& at = here_.friction;
  ++evaluations;
  const bool found = rates(time, state, memory, here_, unused.data());
  outer_iterations += at.report.iterations;
  if (found) coupled.resolve_rest(state, memory, at, due);
  unproven += at.report.others_possible;
  if (at.report.status == CoupledStatus::ok) set_held_units();
  return at.report;
}

void Equations::set_masses(double time, std::vector<BodyMass>& masses,
                           Dynamics& dynamics) const {
  masses.clear();
  if (forces) forces->add_masses(time, masses);
  // A star's are constants.
  if (!masses.empty() && system.is_star()) {
    const int body = masses[0].body;
    throw contact::Error(contact::detail::must_be(
        (body == 0 ? "carrier" : fmt::format("bodies[{}]", body - 1)) +
            ".flows, whose mass ForceModel::add_masses() changes,",
        "true"));
  }
  for (const BodyMass& mass : masses) dynamics.set_mass(system, mass);
}

bool Equations::rates(double time, const double* state, FrictionMemory& from,
                      MotionInstant& at, double* to) const {
  double power = 0;
  if (forces) {
    set_bodies(system, coupled.layout(), modes(), state, at.bodies);
    for (BodyForce& force : at.forces) force = {};
    forces->add_forces(time, at.bodies, at.forces);
    set_active_forces(system, at.bodies, at.forces, at.friction.forces);
    for (int i = 0; i <= size(); ++i) {
      power += at.forces[i].force.dot(at.bodies[i].velocity) +
               at.forces[i].moment.dot(at.bodies[i].angular_velocity);
    }
    set_masses(time, at.masses, at.friction.dynamics);
    if (!at.masses.empty()) from.response_at.clear();
    for (const BodyMass& mass : at.masses) {
      power += flow_power(mass, at.bodies[mass.body], gravity);
    }
  } else {
    clear(at.friction.forces);
  }
  if (drive) at.friction.prescribed = driven(*drive, gravity, state);
  if (coupled.evaluate(state, from, at.friction).status != CoupledStatus::ok) {
    return false;
  }
  at.friction.dynamics.rates(state, vec3(gravity), to);
  // Prevents drift by the rounding of gravity.
  if (system.carrier().fixed) std::fill_n(to, StateLayout::body_size, 0.0);
  Hinges hinges = coupled.at(from, at.friction);
  for (int i = 0; i < size(); ++i) {
    to[dissipated_at(i)] = coupled.hinge(i).is_active()
                               ? -hinges.memory(i).moment.dot(rate_of(i, state))
                               : 0;
    to[held_at(i)] = held_rate(i, hinges);
  }
  to[work_at()] = power;
  return true;
}

}  // namespace multibody
