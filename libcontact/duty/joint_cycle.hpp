#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/validity.hpp"

namespace contact {

/// A joint on its duty cycle: friction at the times of the cycle and at the
/// Gauss points of its integrals. It has a cycle and a joint of its own; what
/// sliding() gives refers to the latter.
class JointCycle {
 public:
  /// Friction of the joint at one time of its cycle.
  struct Instant {
    double time;    ///< s
    double weight;  ///< in integrals over the period, s
    DutyCycle::State state;
    JointSolution solution;
  };

  /// @param joint  a pin turns about Z
  /// @throws Error if the laws of the contact have no value at some time.
  JointCycle(DutyCycle cycle, Joint joint);

  const DutyCycle& cycle() const { return cycle_; }
  const JointContact& contact() const { return joint_.contact(); }
  /// Instants at the times of the cycle; their weight is 0.
  const std::vector<Instant>& rows() const { return rows_; }
  const std::vector<Instant>& gauss_points() const { return gauss_points_; }
  /// Its solution has the status out_of_range where the laws have no value.
  Instant at(double time) const noexcept;
  SlidingContact sliding(const Instant& instant) const& {
    return {contact(), instant.solution, instant.state.angular_velocity};
  }

  /// Would refer to a joint that is gone.
  SlidingContact sliding(const Instant&) const&& = delete;

  using Quantity = std::function<double(const Instant&)>;
  /// Integral over one period, within 1e-9 for smooth cycles of 100 times
  /// (duty/joint_cycle_test.cpp).
  double integral(const Quantity& quantity) const;
  /// The largest value, to 1e-8: the largest of the rows, improved between its
  /// neighbours.
  Instant largest(const Quantity& quantity) const;
  /// Largest half-angle and peak pressure of the cycle, for ContactLimits, each
  /// found as by largest(), and overlap with rims, of the rows.
  LargestContact largest_contact() const;
  /// Turn from carrier axes to those of the body that has the seat or hole.
  Eigen::Quaterniond to_seat(const Instant& instant) const;
  /// How far the contact wanders over the seat or hole in a cycle: root mean
  /// square of the angle between its centre and the middle of its places, in
  /// the seat's axes and with the weight of p v, rad; 0 without p v.
  double contact_spread() const;

 private:
  DutyCycle cycle_;
  Joint joint_;
  std::vector<Instant> rows_;
  std::vector<Instant> gauss_points_;
};

}  // namespace contact
