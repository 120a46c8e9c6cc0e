#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"

namespace contact {

/// Friction of a joint at one time of its cycle.
struct CycleInstant {
  double time;    ///< s
  double weight;  ///< in integrals over the period, s
  CycleState state;
  JointSolution solution;
};

/// A joint on its duty cycle: friction at the times of the cycle and at the
/// nodes of its integrals. Refers to cycle and joint.
class JointCycle {
 public:
  /// @param joint  a pin turns about Z
  /// @throws Error if the laws of the contact have no value at some time.
  JointCycle(const DutyCycle& cycle, const Joint& joint);

  const DutyCycle& cycle() const { return *cycle_; }
  const JointContact& contact() const { return joint_->contact(); }
  /// At the times of the cycle; of no weight.
  const std::vector<CycleInstant>& rows() const { return rows_; }
  const std::vector<CycleInstant>& nodes() const { return nodes_; }
  CycleInstant at(double time) const;
  SlidingContact sliding(const CycleInstant& instant) const {
    return {contact(), instant.solution, instant.state.rate};
  }

  using Quantity = std::function<double(const CycleInstant&)>;
  /// Over one period; to 1e-9 for smooth cycles of 100 times
  /// (duty/joint_cycle_test.cpp).
  double integral(const Quantity& quantity) const;
  /// The largest value, to 1e-8: the largest of the rows, improved between its
  /// neighbours.
  CycleInstant largest(const Quantity& quantity) const;
  /// For ContactLimits; both as largest().
  LargestContact largest_contact() const;

 private:
  const DutyCycle* cycle_;
  const Joint* joint_;
  std::vector<CycleInstant> rows_;
  std::vector<CycleInstant> nodes_;
};

}  // namespace contact
