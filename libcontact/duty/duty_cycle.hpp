#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/duty/periodic_spline.hpp"
#include "libcontact/pair/joint_geometry.hpp"

namespace contact {

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

/// A joint at one time of a cycle.
struct CycleState {
  Eigen::Vector3d reaction;  ///< R on the body, carrier axes, N
  Eigen::Vector3d
      angular_velocity;     ///< Dw, body against carrier, carrier axes, rad/s
  Eigen::Quaterniond turn;  ///< from the body's axes to the carrier's
};

/// How forces were measured.
struct ForceFrame {
  JointBody on = JointBody::body;       ///< that they act on
  JointBody axes = JointBody::carrier;  ///< that they are given in
};

/// One period of forces and motion of a joint, from values at some times:
/// periodic cubic splines through all of them.
class DutyCycle {
 public:
  /// Rad.
  DutyCycle(PeriodicSpline forces, ForceFrame frame, PeriodicSpline angles,
            TurnSequence sequence);
  /// Angular velocities Dw in carrier axes, rad/s. The turn, from the axes of
  /// the carrier at the first time, is integrated by Magnus' method of fourth
  /// order, four steps from each time to the next.
  DutyCycle(PeriodicSpline forces, ForceFrame frame, PeriodicSpline rates);

  CycleState at(double time) const;
  const std::vector<double>& times() const { return motion_.times(); }
  double period() const { return motion_.period(); }
  /// By what angle the turn after a period differs from the one before it, rad;
  /// 0 of angles.
  double closure() const { return closure_; }

  /// Gauss's rule of eight points in each interval of the times, of a pin four
  /// in each quarter. Intervals are divided where |Dw| has a kink, for it is 0,
  /// and again and again towards where it nearly has one.
  struct Node {
    double time;
    double weight;  ///< s
  };
  /// @param is_pin  of the rate the part about Z counts
  std::vector<Node> nodes(bool is_pin) const;

 private:
  Eigen::Quaterniond turned(Eigen::Quaterniond turn, double from,
                            double to) const;
  Eigen::Vector3d angular_velocity(double time) const;
  std::vector<double> reversals(bool is_pin) const;

  PeriodicSpline forces_;
  ForceFrame frame_;
  PeriodicSpline motion_;  // angles or rates
  std::optional<TurnSequence> sequence_;
  std::vector<Eigen::Quaterniond> turns_;  // of rates, at the times
  double closure_ = 0;
};

}  // namespace contact
