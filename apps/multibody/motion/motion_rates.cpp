#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "multibody/motion/motion_impl.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/kinematics.hpp"

namespace multibody {

using Eigen::Matrix3d;
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

Vector3d MotionImpl::rate_of(int body, const double* state) const {
  return relative_rate(system.links()[body],
                       state + coupled.layout().offset(body));
}

void MotionImpl::set_held_units() {
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

double MotionImpl::held_rate(int body) const {
  if (joint_modes[body] != JointMode::held) return 0;
  const Reaction<double>& r = coupled.reaction(body);
  return (r.force.x + r.force.y + r.force.z) / held_units_[body].force +
         (r.moment.x + r.moment.y + r.moment.z) / held_units_[body].moment;
}

bool MotionImpl::rates(double time, const double* state, double* to) {
  ++counts.evaluations;
  double power = 0;
  if (forces) {
    set_bodies(system, coupled.layout(), joint_modes, state, rate_motions_);
    for (BodyForce& force : body_forces_) force = {};
    forces->add_forces(time, rate_motions_, body_forces_);
    set_active_forces(system, rate_motions_, body_forces_, forces_);
    for (int i = 0; i <= size(); ++i) {
      power += body_forces_[i].force.dot(rate_motions_[i].velocity) +
               body_forces_[i].moment.dot(rate_motions_[i].angular_velocity);
    }
  }
  if (options.carrier_drive) {
    coupled.prescribe_carrier(
        driven(*options.carrier_drive, options.gravity, state));
  }
  const CoupledReport& report = coupled.evaluate(state, forces_);
  counts.outer_iterations += report.iterations;
  if (report.status != CoupledStatus::ok) {
    failed_report = report;
    failed_time = time;
    return false;
  }
  coupled.dynamics().rates(state, vec3(options.gravity), to);
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

void MotionImpl::look_at(double time, std::span<const double> state) {
  view_time = time;
  view_state.assign(state.begin(), state.end());
  set_bodies(system, coupled.layout(), joint_modes, view_state.data(), motions);
  worked_out = false;
}

bool MotionImpl::work_out() {
  forces_asked_ = true;
  if (!worked_out) {
    view_rates.resize(view_state.size());
    worked_well = rates(view_time, view_state.data(), view_rates.data());
    worked_out = true;
  }
  return worked_well;
}

HingeSample MotionImpl::hinge(int body) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Link& link = system.links()[body];
  HingeSample s;
  s.mode = coupled.mode(body);
  s.dissipated = view_state[dissipated_at(body)];
  s.angle = s.angle_rate = s.utilisation = nan;
  s.friction_moment.setZero();
  if (s.mode == HingeMode::released) {
    s.rotation.setConstant(nan);
    s.relative_angular_velocity.setConstant(nan);
    s.reaction_force.setZero();
    s.reaction_moment.setZero();
    return s;
  }
  const bool known = work_out();
  const double* numbers = view_state.data() + coupled.layout().offset(body);
  s.rotation = relative_rotation(link, numbers) * link.axes.transpose();
  s.relative_angular_velocity = link.axes * relative_rate(link, numbers);
  if (is_axis(body)) {
    s.angle = numbers[0];
    s.angle_rate = numbers[1];
  }
  if (!known) {
    s.reaction_force.setConstant(nan);
    s.reaction_moment.setConstant(nan);
    s.friction_moment.setConstant(nan);
    return s;
  }
  const Reaction<double>& reaction = coupled.reaction(body);
  s.reaction_force = link.axes * vec3(reaction.force);
  s.reaction_moment = link.axes * vec3(reaction.moment);
  if (coupled.hinge(body).has_friction && s.mode != HingeMode::locked) {
    s.joints = coupled.joints(body);
    if (s.mode == HingeMode::sliding) {
      s.friction_moment = link.axes * coupled.friction_moment(body);
      s.utilisation = 1;
    } else {
      s.utilisation = coupled.utilisation(body);
    }
  }
  return s;
}

Vector3d MotionImpl::acceleration(int place) {
  if (!work_out()) return Vector3d::Constant(NAN);
  constexpr int v = StateLayout::velocity;
  if (place == 0) return Eigen::Map<const Vector3d>(&view_rates[v]);
  const int body = place - 1;
  if (coupled.mode(body) == HingeMode::released) {
    return Eigen::Map<const Vector3d>(
        &view_rates[coupled.layout().offset(body) + v]);
  }
  // (F + R)/m and gravity
  const Link& link = system.links()[body];
  const Vector3d force =
      vec3(forces_.bodies[body].force) + vec3(coupled.reaction(body).force);
  return options.gravity +
         motions[place].rotation * link.axes * force / link.mass;
}

Vector3d MotionImpl::angular_acceleration(int place) {
  if (!work_out()) return Vector3d::Constant(NAN);
  if (place == 0) {
    return motions[0].rotation * vec3(coupled.dynamics().carrier().angular);
  }
  return motions[place].rotation * system.links()[place - 1].axes *
         vec3(coupled.dynamics().angular_acceleration(place - 1));
}

EnergyBook MotionImpl::energy() const {
  EnergyBook book{};
  const Carrier& carrier = system.carrier();
  book.kinetic = kinetic_energy(carrier.mass, carrier.inertia,
                                Matrix3d::Identity(), motions[0]);
  book.gravity = -carrier.mass * options.gravity.dot(motions[0].position);
  for (int i = 0; i < size(); ++i) {
    const Link& link = system.links()[i];
    book.kinetic +=
        kinetic_energy(link.mass, link.inertia, link.axes, motions[1 + i]);
    book.gravity -= link.mass * options.gravity.dot(motions[1 + i].position);
    book.dissipated += view_state[dissipated_at(i)];
  }
  book.active_work = view_state[work_at()];
  return book;
}

}  // namespace multibody
