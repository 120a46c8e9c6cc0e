#include "multibody/motion/equations.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

}  // namespace

Equations::Equations(const System& motion_system,
                     std::vector<HingeFriction> friction,
                     std::shared_ptr<const ForceModel> force_model,
                     const MotionOptions& options)
    : system(motion_system),
      gravity(options.gravity),
      drive(options.carrier_drive),
      coupled(system,
              friction.empty() ? std::vector<HingeFriction>(system.size())
                               : std::move(friction),
              options.coupling),
      held_units_(size()),
      body_forces_(1 + size()),
      motions_(1 + size()) {
  set_forces(std::move(force_model));
}

void Equations::set_forces(std::shared_ptr<const ForceModel> model) {
  forces = std::move(model);
  active = {};
  active.bodies.resize(size());
}

int Equations::owner_of(int number) const {
  if (number < 0 || number == work_at()) return -1;
  if (number > work_at()) return 1 + number - held_at(0);
  if (number >= dissipated_at(0)) return 1 + number - dissipated_at(0);
  int body = 0;
  while (body < size() && number >= offset(body)) ++body;
  return body;
}

void Equations::set_held_units() {
  held_units_.assign(size(), {});
  double force = 0;
  for (int i = 0; i < size(); ++i) {
    force = std::max(force, vec3(coupled.reaction(i).force).norm());
  }
  const CoupledRounding rounding = coupled.rounding();
  for (int i = 0; i < size(); ++i) {
    const Reaction<double>& r = coupled.reaction(i);
    // What is tiny among the forces of the system, or little but rounding,
    // need not be followed.
    const double own =
        vec3(r.force).norm() + 1e-3 * force + 1e6 * rounding.force;
    held_units_[i].force = own > 0 ? own : 1;
    held_units_[i].moment =
        vec3(r.moment).norm() +
        1e-2 * held_units_[i].force * std::max(system.links()[i].arm, 1e-2);
  }
}

double Equations::held_rate(int body) const {
  if (modes()[body] != JointMode::held) return 0;
  const Reaction<double>& r = coupled.reaction(body);
  return (r.force.x + r.force.y + r.force.z) / held_units_[body].force +
         (r.moment.x + r.moment.y + r.moment.z) / held_units_[body].moment;
}

bool Equations::rates_in_step(double time, const double* state, double* to) {
  const double before = std::nextafter(next_break, time - 1);
  return rates(time < next_break ? time : before, state, to);
}

bool Equations::rates(double time, const double* state, double* to) {
  ++evaluations;
  double power = 0;
  if (forces) {
    set_bodies(system, coupled.layout(), modes(), state, motions_);
    for (BodyForce& force : body_forces_) force = {};
    forces->add_forces(time, motions_, body_forces_);
    set_active_forces(system, motions_, body_forces_, active);
    for (int i = 0; i <= size(); ++i) {
      power += body_forces_[i].force.dot(motions_[i].velocity) +
               body_forces_[i].moment.dot(motions_[i].angular_velocity);
    }
  }
  if (drive) {
    coupled.prescribe_carrier(driven(*drive, gravity, state));
  }
  const CoupledReport& report = coupled.evaluate(state, active);
  outer_iterations += report.iterations;
  if (report.status != CoupledStatus::ok) {
    failed_report = report;
    failed_time = time;
    return false;
  }
  coupled.dynamics().rates(state, vec3(gravity), to);
  // It does not drift, whatever rounding leaves of gravity.
  if (system.carrier().fixed) std::fill_n(to, StateLayout::body_size, 0.0);
  for (int i = 0; i < size(); ++i) {
    const bool slides =
        coupled.mode(i) == HingeMode::sliding && coupled.hinge(i).has_friction;
    to[dissipated_at(i)] =
        slides ? -coupled.friction_moment(i).dot(rate_of(i, state)) : 0;
    to[held_at(i)] = held_rate(i);
  }
  to[work_at()] = power;
  return true;
}

}  // namespace multibody
