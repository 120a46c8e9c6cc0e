#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/solution.hpp"

namespace contact {

/// Friction of a joint at one time of its cycle.
struct CycleInstant {
  double time;    ///< s
  double weight;  ///< in integrals over the period, s
  CycleState state;
  JointSolution solution;
};

/// A joint on its duty cycle: friction at the times of the cycle and at the
/// nodes of its integrals. Refers to cycle and contact.
class JointCycle {
 public:
  /// Friction under R and Dw: BallJoint::solve(), PinJoint::solve().
  using Solve = std::function<JointSolution(const Eigen::Vector3d& reaction,
                                            const Eigen::Vector3d& rate)>;
  /// @throws Error if the laws of the contact have no value at some time.
  JointCycle(const DutyCycle& cycle, const JointContact& contact, Solve solve);

  const DutyCycle& cycle() const { return *cycle_; }
  const JointContact& contact() const { return *contact_; }
  /// At the times of the cycle; of no weight.
  const std::vector<CycleInstant>& rows() const { return rows_; }
  const std::vector<CycleInstant>& nodes() const { return nodes_; }
  CycleInstant at(double time) const;
  SlidingContact sliding(const CycleInstant& instant) const {
    return {*contact_, instant.solution, instant.state.rate};
  }

  using Quantity = std::function<double(const CycleInstant&)>;
  /// Over one period; to 3e-9 for smooth cycles of 100 times
  /// (duty/joint_cycle_test.cpp).
  double integral(const Quantity& quantity) const;
  /// The largest value, to 1e-8: the largest of the rows, improved between its
  /// neighbours.
  CycleInstant largest(const Quantity& quantity) const;

 private:
  const DutyCycle* cycle_;
  const JointContact* contact_;
  Solve solve_;
  std::vector<CycleInstant> rows_;
  std::vector<CycleInstant> nodes_;
};

}  // namespace contact
