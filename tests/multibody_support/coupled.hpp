#pragma once

#include "multibody/friction/coupled_dynamics.hpp"

namespace multibody::test {

/// Friction along a motion, with its own memory and instant.
class Coupled {
 public:
  Coupled(const System& system, const std::vector<HingeFriction>& friction)
      : coupled_(system, friction),
        memory_(coupled_.beginning()),
        now_(system) {}

  int size() const { return coupled_.size(); }
  const StateLayout& layout() const { return coupled_.layout(); }
  HingeMode mode(int body) const { return coupled_.mode(body); }
  void set_mode(int body, HingeMode mode) {
    coupled_.set_mode(body, mode, memory_);
  }
  void set_direction(int body, const Eigen::Vector3d& direction) {
    memory_.hinges[body].direction = direction;
  }
  const Eigen::Vector3d& direction(int body) const {
    return memory_.hinges[body].direction;
  }
  void prescribe_carrier(const CarrierAcceleration<double>& carrier) {
    now_.prescribed = carrier;
  }
  void set_trace(std::vector<OuterStep>* trace) { now_.report.trace = trace; }

  const CoupledReport& evaluate(const std::vector<double>& state,
                                const ActiveForces<double>& forces) {
    now_.forces = forces;
    return coupled_.evaluate(state.data(), memory_, now_);
  }
  /// As above, after all memory is discarded.
  const CoupledReport& evaluate_aside(const std::vector<double>& state,
                                      const ActiveForces<double>& forces) {
    FrictionMemory copy = memory_;
    now_.forces = forces;
    return coupled_.evaluate(state.data(), copy, now_);
  }
  const CoupledReport& resolve_rest(const std::vector<double>& state,
                                    const ActiveForces<double>& forces,
                                    bool due = false) {
    now_.forces = forces;
    return coupled_.resolve_rest(state.data(), memory_, now_, due);
  }

  const Dynamics& dynamics() const { return now_.dynamics; }
  const std::vector<CoupledSolution>& solutions() const {
    return now_.solutions;
  }
  const Eigen::Vector3d& friction_moment(int body) const {
    return memory_.hinges[body].moment;
  }
  void set_friction_moment(int body, const Eigen::Vector3d& moment) {
    memory_.set_moment(body, moment);
  }
  const Reaction<double>& reaction(int body) { return at().reaction(body); }
  std::span<const contact::JointSolution> joints(int body) {
    return at().joints(body);
  }
  double kappa(int body) { return at().kappa(body); }
  double utilisation(int body) { return coupled_.utilisation(body, at()); }
  double slip_limit(int body) { return coupled_.slip_limit(body, at()); }

 private:
  Hinges at() { return coupled_.at(memory_, now_); }

  CoupledDynamics coupled_;
  FrictionMemory memory_;
  Evaluation now_;
};

}  // namespace multibody::test
