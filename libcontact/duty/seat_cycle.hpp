#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "libcontact/duty/duty_cycle.hpp"
#include "libcontact/seat/joint.hpp"
#include "libcontact/seat/table.hpp"

namespace contact {

/// A ball in a seat that ends on its duty cycle: a load that turns in the seat,
/// at the times of the cycle. The seat turns with the body that has it.
class SeatCycle {
 public:
  struct Instant {
    double time;                 ///< s
    double weight;               ///< in means over time, s: trapezoidal rule
    SeatJointSolution solution;  ///< in the axes of the body with the seat
    /// Dw in these axes, rad/s.
    Eigen::Vector3d angular_velocity;
    SeatPv pv = {};  ///< in these axes too; NaN without a contact
    /// From these axes to those of the body that has the ball.
    Eigen::Quaterniond to_ball = Eigen::Quaterniond::Identity();
  };

  struct Options {
    /// Called as by SeatTable.
    std::function<void(double)> progress = {};
    /// SeatTable::bytes() of the joint; "": a table is made where `many`
    /// contacts or more reach a rim.
    std::string table = {};
    /// Whether solutions keep their grids, 20 to 100 kB each at a rim, for a
    /// WearMap.
    bool keeps_contacts = false;
  };
  /// @throws Error as SeatJoint and SeatTable.
  SeatCycle(const DutyCycle& cycle, const JointSpec& joint,
            const Options& options);
  SeatCycle(const DutyCycle& cycle, const JointSpec& joint)
      : SeatCycle(cycle, joint, Options()) {}

  /// From so many contacts at rims on a table is made.
  static constexpr int many = 60;

  const std::vector<Instant>& rows() const { return rows_; }
  /// Shared with what outlives the cycle.
  const std::shared_ptr<const SeatJoint>& joint() const { return joint_; }
  /// The table's, if there is one; of no states without.
  const SeatTable::Check& check() const { return check_; }
  /// SeatTable::bytes() of the table that was made; "" of none.
  const std::string& table() const { return table_; }

  /// Share of the time in which the contact is at a rim.
  double rim_share() const;
  /// The row with the largest pressure; null if none has one, and where a row
  /// without one has a larger mean (SeatState::peak_pressure).
  const Instant* largest_peak() const;
  /// The row whose contact is nearest to a rim; null if none has one.
  const Instant* least_gap() const;
  /// The row with the largest p v, in the same way.
  const Instant* largest_pv() const;
  /// Integral of p v over contact and time, J; rows without a contact left out.
  double pv_integral() const;
  /// The row with the largest K at a rim.
  const Instant* largest_intensity() const;
  /// Notes on the cycle, a sentence for each reason.
  std::vector<std::string> notes() const;

 private:
  template <class Of>
  const Instant* largest(const Of& of) const;
  template <class Of, class Mean>
  const Instant* largest(const Of& of, const Mean& mean) const;

  std::shared_ptr<const SeatJoint> joint_;
  std::vector<Instant> rows_;
  std::vector<std::string> notes_;
  SeatTable::Check check_;
  std::string table_;
};

}  // namespace contact
