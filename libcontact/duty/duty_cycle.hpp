// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/pair/joint_geometry.hpp"

namespace contact {

/// One period of forces and motion of a joint, from values at some times:
/// periodic cubic splines through all of them.
class DutyCycle {
 public:
  /// The rows of a cycle as somebody measured them.
  struct Rows {
    std::vector<double> times;            ///< s, ascending
    std::vector<Eigen::Vector3d> forces;  ///< N
    /// Angles, rad, or angular velocities Dw in carrier axes, rad/s.
    std::vector<Eigen::Vector3d> motion;
    std::optional<double> period = {};  ///< s, if it is known

    /// Makes one period of the rows. A last row that repeats the first (time 0
    /// to 100 %, as tables of gait have it), to 1e-9 of each column's range, is
    /// left out, and its time ends the period; it stays if the period is known
    /// and longer. Otherwise even steps go on by one. The period is set if it
    /// can be told: not for uneven steps without a last row that repeats the
    /// first.
    /// @return a note on the omitted rows, or ""
    std::string make_one_period();
    /// Whether all rows have the same force and motion.
    bool is_steady() const;
    /// One or two such rows, with their period, as splines want them: eight for
    /// each turn of 2 pi by `motion`, 8 to 8000. Others as they are.
    Rows filled() const;
  };

  /// Intrinsic rotations one after the other, each about an axis of the body as
  /// the ones before have left it: "zxy", or "z" for a pin.
  class TurnSequence {
   public:
    /// @param axes  x, y, z; three of them, neighbours not alike, or one
    /// @throws Error for anything else.
    explicit TurnSequence(std::string_view axes);

    /// Q = R_a1(q1) R_a2(q2) R_a3(q3), from the body's axes to the carrier's.
    /// @param angles  rad; those behind the last axis count for nothing
    Eigen::Quaterniond turn(const Eigen::Vector3d& angles) const;
    /// Dw in carrier axes: q1' e_a1 + q2' R_a1 e_a2 + q3' R_a1 R_a2 e_a3.
    Eigen::Vector3d angular_velocity(const Eigen::Vector3d& angles,
                                     const Eigen::Vector3d& angle_rates) const;

   private:
    std::vector<Eigen::Vector3d> axes_;
  };

  /// How forces were measured.
  struct ForceFrame {
    JointBody on = JointBody::body;       ///< the body they act on
    JointBody axes = JointBody::carrier;  ///< the body whose axes give them
  };

  /// A joint at one time of a cycle.
  struct State {
    Eigen::Vector3d reaction;  ///< R on the body, carrier axes, N
    /// Dw, body against carrier, carrier axes, rad/s.
    Eigen::Vector3d angular_velocity;
    Eigen::Quaterniond turn;  ///< from the body's axes to the carrier's
  };

  /// Makes a cycle from angles.
  /// @param rows  with their period, three or more
  /// @throws Error if they are not so, or if an angle changes by more than 180
  ///         deg from row to row, the last to the first too: one that jumps
  ///         back after a turn would be turned back by the spline.
  DutyCycle(const Rows& rows, ForceFrame frame, TurnSequence sequence);
  /// Makes a cycle from angular velocities; one or two rows are enough for a
  /// steady one (Rows::filled). The turn, from the axes of the
  /// carrier at the first time, is integrated by Magnus' method of fourth
  /// order, four steps from each time to the next.
  DutyCycle(const Rows& rows, ForceFrame frame);

  State at(double time) const;
  const std::vector<double>& times() const;
  double period() const;
  /// Angle between the turns at the beginning and the end of a period, rad; 0
  /// if the cycle is given by angles.
  double closure() const { return closure_; }

  /// Notes for the user, sentences without a full stop: on splines that go
  /// beyond the rows by more than 1 % of their range, on angles above 2 pi or
  /// more than 1 rad apart, on turns that do not close, and on a pin's axial R.
  std::vector<std::string> notes(bool is_pin) const;

  /// Gauss's rule of eight points in each interval of the times, of a pin four
  /// in each quarter. Intervals are divided where |Dw| has a kink, for it is 0,
  /// and again and again towards where it nearly has one.
  struct GaussPoint {
    double time;
    double weight;  ///< s
  };
  /// @param is_pin  of the angular velocity the part about Z counts
  std::vector<GaussPoint> gauss_points(bool is_pin) const;

 private:
  struct Splines;
  Eigen::Quaterniond turned(Eigen::Quaterniond turn, double from,
                            double to) const;
  Eigen::Vector3d angular_velocity(double time) const;
  std::vector<double> reversals(bool is_pin) const;

  std::shared_ptr<const Splines> splines_;
  ForceFrame frame_;
  std::optional<TurnSequence> sequence_;
  std::vector<Eigen::Quaterniond> turns_;  // by integrated rates, at the times
  double closure_ = 0;
};

}  // namespace contact
