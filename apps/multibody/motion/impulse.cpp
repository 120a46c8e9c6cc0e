#include "multibody/motion/impulse.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "multibody/system/eigen_conversion.hpp"

namespace multibody {

using Eigen::Map;
using Eigen::Vector3d;

// The state without velocities; sets the modes of the impulse.
std::vector<double> Impulse::make_still(const std::vector<Target>& targets,
                                        bool ideal,
                                        const std::vector<double>& state) {
  std::vector<double> still = state;
  Map<Vector3d>(&still[StateLayout::angular_velocity]).setZero();
  const auto is_turned = [&](int body) {
    return std::ranges::count(targets, body, &Target::body) > 0 ||
           (ideal && equations_.coupled.mode(body) == HingeMode::resting);
  };
  for (int i = 0; i < equations_.size(); ++i) {
    const JointMode mode =
        is_turned(i) ? JointMode::turning : equations_.modes()[i];
    if (dynamics_.mode(i) != mode) dynamics_.set_mode(i, mode);
    double* s = &still[equations_.offset(i)];
    if (mode == JointMode::released) {
      Map<Vector3d>(s + StateLayout::angular_velocity).setZero();
    } else {
      set_relative_rate(equations_.system.links()[i], s, Vector3d::Zero());
    }
  }
  return still;
}

void Impulse::evaluate(const std::vector<double>& still) {
  if (equations_.drive) {
    dynamics_.evaluate_prescribed(still.data(), moments_, {});
  } else {
    dynamics_.evaluate(still.data(), moments_);
  }
}

void Impulse::add_jump(const std::vector<double>& still,
                       std::vector<double>& state) const {
  const CarrierAcceleration<double>& jump = dynamics_.carrier();
  const Eigen::Matrix3d r0 = carrier_at(state.data()).rotation;
  Map<Vector3d>(&state[StateLayout::velocity]) += r0 * vec3(jump.linear);
  Map<Vector3d>(&state[StateLayout::angular_velocity]) += vec3(jump.angular);
  // Released bodies jump too, because they may carry the hinge.
  std::vector<double> jumps(still.size());
  dynamics_.rates(still.data(), {0, 0, 0}, jumps.data());
  for (int i = 0; i < equations_.size(); ++i) {
    double* s = &state[equations_.offset(i)];
    if (dynamics_.mode(i) == JointMode::released) {
      const double* jump_of = &jumps[equations_.offset(i)];
      for (const int k :
           {StateLayout::velocity, StateLayout::angular_velocity}) {
        Map<Vector3d>(s + k) += Map<const Vector3d>(jump_of + k);
      }
    }
    if (dynamics_.mode(i) != JointMode::turning) continue;
    const Link& link = equations_.system.links()[i];
    const Vector3d a = vec3(dynamics_.relative_acceleration(i));
    set_relative_rate(link, s, relative_rate(link, s) + a);
  }
}

// Response of the rates to the moments of the unknowns.
Eigen::MatrixXd Impulse::mobility(const std::vector<Unknown>& unknowns,
                                  const std::vector<double>& still) {
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  Eigen::MatrixXd result(count, count);
  for (Eigen::Index c = 0; c < count; ++c) {
    Vec3<double>& moment = moments_.bodies[unknowns[c].body].friction;
    moment = vec3(unknowns[c].direction);
    evaluate(still);
    moment = {};
    for (Eigen::Index r = 0; r < count; ++r) {
      const auto& [target, body, direction] = unknowns[r];
      result(r, c) = vec3(dynamics_.relative_acceleration(body)).dot(direction);
    }
  }
  return result;
}

// Ball joints that turn along their stops go on doing so.
std::vector<Impulse::Target> Impulse::along_stops(
    const std::vector<Target>& targets,
    const std::vector<double>& state) const {
  std::vector<Target> all = targets;
  for (int i = 0; i < equations_.size(); ++i) {
    const Hinge& hinge = equations_.coupled.hinge(i);
    if (!hinge.slides_on_stop()) continue;
    if (std::ranges::count(targets, i, &Target::body) > 0) continue;
    const double* s = &state[equations_.offset(i)];
    all.push_back({i, Vector3d::Zero(), hinge.cone->turn(s).axis});
  }
  return all;
}

std::vector<Impulse::Jump> Impulse::apply(double time,
                                          const std::vector<Target>& targets,
                                          bool ideal,
                                          std::vector<double>& state) {
  if (targets.empty()) return {};
  equations_.set_masses(time, masses_, dynamics_);
  return apply(ideal ? targets : along_stops(targets, state), ideal, state);
}

std::vector<Impulse::Jump> Impulse::apply(const std::vector<Target>& targets,
                                          bool ideal,
                                          std::vector<double>& state) {
  const std::vector<double> still = make_still(targets, ideal, state);
  std::vector<Unknown> unknowns;
  std::vector<double> changes;
  std::vector<Vector3d> before;
  const auto add = [&](const Target& target, const Vector3d& direction) {
    unknowns.push_back({before.size() - 1, target.body, direction});
    changes.push_back((target.rate - before.back()).dot(direction));
  };
  for (const Target& target : targets) {
    before.push_back(equations_.rate_of(target.body, state.data()));
    if (target.along) {
      add(target, *target.along);
      continue;
    }
    for (int k = equations_.is_axis(target.body) ? 2 : 0; k < 3; ++k) {
      add(target, Vector3d::Unit(k));
    }
  }
  moments_.bodies.assign(equations_.size(), {});
  const Eigen::MatrixXd w = mobility(unknowns, still);
  const Eigen::VectorXd impulses = w.fullPivLu().solve(
      Map<Eigen::VectorXd>(changes.data(), std::ssize(changes)));
  std::vector<Jump> jumps(targets.size(), {Vector3d::Zero(), 0, 0});
  for (Eigen::Index c = 0; c < impulses.size(); ++c) {
    const auto& [target, body, direction] = unknowns[c];
    jumps[target].impulse += impulses[c] * direction;
    jumps[target].response = w(c, c);
    moments_.bodies[body].friction = vec3(jumps[target].impulse);
  }
  evaluate(still);
  add_jump(still, state);
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const auto& [body, rate, along] = targets[t];
    Vector3d after = rate;
    if (along) {  // exactly, as the others
      after = equations_.rate_of(body, state.data());
      after += (rate - after).dot(*along) * *along;
    }
    set_relative_rate(equations_.system.links()[body],
                      &state[equations_.offset(body)], after);
    // The mean of the velocities before and after does the work.
    jumps[t].loss = -0.5 * jumps[t].impulse.dot(before[t] + rate);
  }
  return jumps;
}

}  // namespace multibody
