#include "multibody/motion/hinge_changes.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>

#include "multibody/system/eigen_conversion.hpp"

namespace multibody {
namespace {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Speed up to which a ball joint that begins to slide does so straight, rad/s:
// far below what anyone sees, far above what tolerances leave uncertain.
constexpr double onset_speed = 3e-5;

double default_stop_speed(const MotionOptions& options) {
  if (options.stop_speed > 0) return options.stop_speed;
  // Below 1e-9 rad/s the rounding of the accelerations counts.
  return options.integrator == Integrator::rk4
             ? 1e-8
             : std::max(100 * options.absolute_tolerance, 1e-9);
}

}  // namespace

HingeChanges::HingeChanges(Equations& equations, MotionSample& view,
                           const MotionOptions& options)
    : equations_(equations),
      view_(view),
      coupled_(equations.coupled),
      impulse_(equations.system),
      stop_speed_(default_stop_speed(options)),
      stall_changes_(options.stall_changes),
      stall_span_(options.stall_span),
      straight_from_(coupled_.size()),
      recent_(coupled_.size()) {}

void HingeChanges::change(double time, int body, HingeMode mode) {
  all_.push_back({time, body, coupled_.mode(body), mode});
  equations_.set_mode(body, mode);
}

void HingeChanges::slide_straight(int body, bool straight) {
  const Vector3d rate = view_.rate_of(body);
  straight_from_[body] = rate.norm();
  equations_.memory.hinges[body].direction = rate.normalized();
  coupled_.slide_straight(body, straight);
}

CoupledReport HingeChanges::resolve_rest(double time,
                                         const std::vector<double>& state,
                                         bool due) {
  std::vector<HingeMode> before;
  for (int i = 0; i < coupled_.size(); ++i) before.push_back(coupled_.mode(i));
  const CoupledReport report = equations_.resolve_rest(time, state.data(), due);
  for (int i = 0; i < coupled_.size(); ++i) {
    const HingeMode mode = coupled_.mode(i);
    if (mode == before[i]) continue;
    all_.push_back({time, i, before[i], mode});
    // Out of rest friction would turn with a velocity that is next to
    // nothing: until it has grown it has the direction of the acceleration.
    if (mode == HingeMode::sliding && !equations_.is_axis(i)) {
      straight_from_[i] = std::max(onset_speed / 2, stop_speed_);
      coupled_.follow_acceleration(i);
    }
  }
  return report;
}

// An impulse in the hinge: the velocities jump as the accelerations would
// answer to a moment, with everything at rest. The bodies keep their momentum
// and the other held hinges hold.
void HingeChanges::stop(int body, std::vector<double>& state) {
  const std::vector<Link>& links = equations_.system.links();
  const std::vector<JointMode>& modes = equations_.modes();
  const Vector3d rate = equations_.rate_of(body, state.data());
  if (rate.isZero(0)) return;

  std::vector<double> still = state;
  Map<Vector3d>(&still[StateLayout::angular_velocity]).setZero();
  for (int i = 0; i < coupled_.size(); ++i) {
    const JointMode mode = i == body ? JointMode::turning : modes[i];
    if (impulse_.mode(i) != mode) impulse_.set_mode(i, mode);
    double* s = &still[equations_.offset(i)];
    if (mode == JointMode::released) {
      Map<Vector3d>(s + StateLayout::angular_velocity).setZero();
    } else {
      set_relative_rate(links[i], s, Vector3d::Zero());
    }
  }
  ActiveForces<double> moments;
  moments.bodies.resize(links.size());
  const auto answer = [&](const Vector3d& moment) {
    moments.bodies[body].friction = vec3(moment);
    if (equations_.drive) {
      impulse_.evaluate_prescribed(still.data(), moments, {});
    } else {
      impulse_.evaluate(still.data(), moments);
    }
    return Vector3d(vec3(impulse_.relative_acceleration(body)));
  };
  Vector3d moment = Vector3d::Zero();
  if (equations_.is_axis(body)) {
    moment.z() = -rate.z() / answer(Vector3d::UnitZ()).z();
  } else {
    Matrix3d mobility;
    for (int k = 0; k < 3; ++k) mobility.col(k) = answer(Vector3d::Unit(k));
    moment = -mobility.fullPivLu().solve(rate);
  }
  answer(moment);

  const CarrierAcceleration<double>& jump = impulse_.carrier();
  const Matrix3d r0 = view_.motions()[0].rotation;
  Map<Vector3d>(&state[StateLayout::velocity]) += r0 * vec3(jump.linear);
  Map<Vector3d>(&state[StateLayout::angular_velocity]) += vec3(jump.angular);
  // Of bodies that were released: they may carry the hinge.
  std::vector<double> jumps(still.size());
  impulse_.rates(still.data(), {0, 0, 0}, jumps.data());
  for (int i = 0; i < coupled_.size(); ++i) {
    double* s = &state[equations_.offset(i)];
    if (modes[i] == JointMode::released) {
      const double* jump_of = &jumps[equations_.offset(i)];
      for (const int k :
           {StateLayout::velocity, StateLayout::angular_velocity}) {
        Map<Vector3d>(s + k) += Map<const Vector3d>(jump_of + k);
      }
    }
    if (modes[i] != JointMode::turning) continue;
    const Vector3d a = vec3(impulse_.relative_acceleration(i));
    set_relative_rate(links[i], s, relative_rate(links[i], s) + a);
  }
  set_relative_rate(links[body], &state[equations_.offset(body)],
                    Vector3d::Zero());
  // The mean of the velocities before and after does the work.
  state[equations_.dissipated_at(body)] -= 0.5 * moment.dot(rate);
}

std::optional<std::string> HingeChanges::stalls(double time, int body) {
  Recent& recent = recent_[body];
  if (!(time - recent.since <= stall_span_)) recent = {time, 0};
  if (++recent.count <= stall_changes_) return {};
  const std::string hinge =
      coupled_.mode(body) == HingeMode::resting
          ? fmt::format("resting, utilisation {}", view_.utilisation(body))
          : fmt::format("sliding at {} rad/s", view_.rate_of(body).norm());
  return fmt::format(
      "at {} s: more than {} changes between rest and slip within {} s, the "
      "hinge is {}",
      time, stall_changes_, stall_span_, hinge);
}

void HingeChanges::restore(int body, double straight_from) {
  recent_[body] = {};
  straight_from_[body] = straight_from;
}

}  // namespace multibody
