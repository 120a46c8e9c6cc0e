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
/// nodes of its integrals. It has a cycle and a joint of its own; what
/// sliding() gives refers to the latter.
class JointCycle {
 public:
  /// @param joint  a pin turns about Z
  /// @throws Error if the laws of the contact have no value at some time.
  JointCycle(DutyCycle cycle, Joint joint);

  const DutyCycle& cycle() const { return cycle_; }
  const JointContact& contact() const { return joint_.contact(); }
  /// At the times of the cycle; of no weight.
  const std::vector<CycleInstant>& rows() const { return rows_; }
  const std::vector<CycleInstant>& nodes() const { return nodes_; }
  /// Its solution has the status out_of_range where the laws have no value.
  CycleInstant at(double time) const noexcept;
  SlidingContact sliding(const CycleInstant& instant) const& noexcept {
    return {contact(), instant.solution, instant.state.angular_velocity};
  }

  /// Would refer to a joint that is gone.
  SlidingContact sliding(const CycleInstant&) const&& = delete;

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
  DutyCycle cycle_;
  Joint joint_;
  std::vector<CycleInstant> rows_;
  std::vector<CycleInstant> nodes_;
};

}  // namespace contact
