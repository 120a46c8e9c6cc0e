#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "multibody/motion/motion_impl.hpp"
#include "multibody/system/eigen_conversion.hpp"
#include "multibody/system/kinematics.hpp"

namespace multibody {
namespace {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const char* reason(CoupledStatus status) {
  switch (status) {
    case CoupledStatus::not_converged:
      return "the friction moments and the reactions do not settle";
    case CoupledStatus::no_solution:
      return "no friction moments were found that fit the reactions they cause";
    case CoupledStatus::several_solutions:
      return "several friction moments fit the reactions they cause";
    case CoupledStatus::out_of_range:
      return "a force or a velocity is not a finite number";
    case CoupledStatus::no_contact:
      return "a contact has no value";
    case CoupledStatus::ok:
      return "steps as short as can be do not meet the tolerance";
  }
  return "";
}

std::string reason(const contact::JointContact& contact, double force) {
  const std::string law = contact.half_angle_law().name();
  return std::isfinite(contact.half_angle(force).half_angle)
             ? fmt::format(
                   "half-angle law {} and pressure law {} give no friction "
                   "under {:.6g} N",
                   law, contact.pressure_law().name(), force)
             : fmt::format("half-angle law {} has no value under {:.6g} N", law,
                           force);
}

// Speed up to which a ball joint that begins to slide does so straight, rad/s:
// far below what anyone sees, far above what tolerances leave uncertain.
constexpr double onset_speed = 3e-5;

}  // namespace

std::string MotionFailure::message() const {
  if (body < 0) return reason;
  if (joint < 0) return fmt::format("{} (body {})", reason, body);
  return fmt::format("{} (body {}, joint {})", reason, body, joint);
}

void MotionImpl::set_failure(const CoupledReport& report, double time) {
  const std::string why =
      report.status == CoupledStatus::no_contact
          ? reason(coupled.hinge(report.body).solver.contact(report.joint),
                   report.force)
          : reason(report.status);
  failure = MotionFailure{report.status,
                          time,
                          report.body,
                          fmt::format("at {} s: {}", time, why),
                          {},
                          report.joint};
  if (report.status == CoupledStatus::several_solutions) {
    failure->solutions.assign(coupled.solutions().begin(),
                              coupled.solutions().end());
  }
}

void MotionImpl::change_mode(int body, HingeMode mode) {
  coupled.set_mode(body, mode);
  joint_modes[body] = coupled.dynamics().mode(body);
}

// An impulse in the hinge: the velocities jump as the accelerations would
// answer to a moment, with everything at rest. The bodies keep their momentum
// and the other held hinges hold.
void MotionImpl::stop_hinge(int body, std::vector<double>& state) {
  const StateLayout& layout = coupled.layout();
  const Vector3d rate = rate_of(body, state.data());
  double* own = state.data() + layout.offset(body);
  const auto own_rate = [&](double value) {
    if (is_axis(body)) {
      own[1] = value;
    } else {
      own[4] = own[5] = own[6] = value;
    }
  };
  if (rate.isZero(0)) return;

  for (int i = 0; i < size(); ++i) {
    const JointMode mode = i == body ? JointMode::turning : joint_modes[i];
    if (impulse.mode(i) != mode) impulse.set_mode(i, mode);
  }
  std::vector<double> still = state;
  Map<Vector3d>(&still[StateLayout::angular_velocity]).setZero();
  for (int i = 0; i < size(); ++i) {
    double* s = &still[layout.offset(i)];
    if (joint_modes[i] == JointMode::released) {
      Map<Vector3d>(s + StateLayout::angular_velocity).setZero();
    } else if (is_axis(i)) {
      s[1] = 0;
    } else {
      Map<Vector3d>(s + 4).setZero();
    }
  }
  ActiveForces<double> moments;
  moments.bodies.resize(size());
  const auto answer = [&](const Vector3d& moment) {
    moments.bodies[body].friction = vec3(moment);
    if (options.carrier_drive) {
      impulse.evaluate_prescribed(still.data(), moments, {});
    } else {
      impulse.evaluate(still.data(), moments);
    }
    return Vector3d(vec3(impulse.relative_acceleration(body)));
  };
  Vector3d moment = Vector3d::Zero();
  if (is_axis(body)) {
    moment.z() = -rate.z() / answer(Vector3d::UnitZ()).z();
  } else {
    Matrix3d mobility;
    for (int k = 0; k < 3; ++k) mobility.col(k) = answer(Vector3d::Unit(k));
    moment = -mobility.fullPivLu().solve(rate);
  }
  answer(moment);

  const CarrierAcceleration<double>& jump = impulse.carrier();
  const Matrix3d r0 = motions[0].rotation;
  Map<Vector3d>(&state[StateLayout::velocity]) += r0 * vec3(jump.linear);
  Map<Vector3d>(&state[StateLayout::angular_velocity]) += vec3(jump.angular);
  for (int i = 0; i < size(); ++i) {
    if (joint_modes[i] != JointMode::turning) continue;
    const Vector3d a = vec3(impulse.relative_acceleration(i));
    double* s = &state[layout.offset(i)];
    if (is_axis(i)) {
      s[1] += a.z();
    } else {
      Map<Vector3d>(s + 4) += a;
    }
  }
  own_rate(0);
  // The mean of the velocities before and after does the work.
  state[dissipated_at(body)] -= 0.5 * moment.dot(rate);
}

bool MotionImpl::resolve_rest(const std::vector<double>& state, int forced) {
  std::vector<HingeMode> before;
  for (int i = 0; i < size(); ++i) before.push_back(coupled.mode(i));
  // Forces at this state are in forces_ after an evaluation of it.
  look_at(now, state);
  if (work_out()) {
    const CoupledReport& report =
        coupled.resolve_rest(view_state.data(), forces_, forced);
    if (report.status != CoupledStatus::ok) {
      set_failure(report, now);
    }
  } else {
    set_failure(failed_report, now);
  }
  for (int i = 0; i < size(); ++i) {
    joint_modes[i] = coupled.dynamics().mode(i);
    if (coupled.mode(i) != before[i]) {
      changes.push_back({now, i, before[i], coupled.mode(i)});
      // Out of rest friction would turn with a velocity that is next to
      // nothing: until it has grown it has the direction of the acceleration.
      if (coupled.mode(i) == HingeMode::sliding && !is_axis(i)) {
        straight_from[i] = std::max(onset_speed / 2, stop_speed);
        coupled.follow_acceleration(i, coupled.hinge(i).pace);
      }
    }
  }
  worked_out = false;
  if (!failure) set_held_units();
  return !failure;
}

void MotionImpl::release(int body) {
  if (coupled.mode(body) == HingeMode::released) return;
  go_to(now);
  changes.push_back({now, body, coupled.mode(body), HingeMode::released});
  const StateLayout before = coupled.layout();
  const std::vector<JointMode> modes_before = joint_modes;
  const std::vector<double> from = view_state;
  change_mode(body, HingeMode::released);
  keep_hinge_angle(body, motions[1 + body].hinge_angle);
  std::vector<double> state(number_count());
  std::copy_n(from.begin(), StateLayout::body_size, state.begin());
  for (int i = 0; i < size(); ++i) {
    double* to = &state[coupled.layout().offset(i)];
    if (i == body) {
      put_body(motions[1 + i], system.links()[i].axes, to);
    } else {
      std::copy_n(
          &from[before.offset(i)],
          StateLayout::link_size(system.links()[i].kind, joint_modes[i]), to);
    }
  }
  std::copy(from.begin() + before.size(), from.end(),
            state.begin() + coupled.layout().size());
  if (resolve_rest(state, -1)) restart(state);
}

void MotionImpl::lock(int body) {
  const HingeMode before = coupled.mode(body);
  if (before == HingeMode::locked || before == HingeMode::released) return;
  go_to(now);
  std::vector<double> state = view_state;
  stop_hinge(body, state);
  changes.push_back({now, body, before, HingeMode::locked});
  change_mode(body, HingeMode::locked);
  if (resolve_rest(state, -1)) restart(state);
}

void MotionImpl::unlock(int body) {
  if (coupled.mode(body) != HingeMode::locked) return;
  go_to(now);
  const HingeMode to =
      coupled.hinge(body).can_rest ? HingeMode::resting : HingeMode::sliding;
  changes.push_back({now, body, HingeMode::locked, to});
  change_mode(body, to);
  const std::vector<double> state = view_state;
  if (resolve_rest(state, -1)) restart(state);
}

}  // namespace multibody
