// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/pair/material.hpp"
#include "libcontact/pair/seat_zone.hpp"

/// Shape of a joint: a ball or pin of radius rho1 in a seat or hole of radius
/// rho1 + eps. eps may be 0, and below 0: interference, by which the two are
/// pressed together before any load (docs/explanation/preload.md).
namespace contact {

enum class JointKind {
  ball,  ///< ball in a seat
  pin,   ///< pin in a hole
};

/// "ball" or "pin".
std::string to_string(JointKind kind);

/// The two bodies that a joint connects. Friction is reported as it acts on
/// the body.
enum class JointBody { carrier, body };

/// A ball or pin joint, validated once. Lengths in m.
class JointGeometry {
 public:
  /// Ball in a seat.
  ///
  /// @param radius            rho1, m, > 0
  /// @param radial_clearance  eps = rho2 - rho1, m, less than the radius in
  ///                          size; the difference of the radii, not of the
  ///                          diameters
  /// @param inner_body        the body that has the ball
  /// @throws Error if an argument is out of range.
  static JointGeometry ball(double radius, double radial_clearance,
                            JointBody inner_body = JointBody::carrier);

  /// Pin in a hole.
  ///
  /// @param length  of the contact along the axis, m, > 0
  /// @throws Error if an argument is out of range; the others as for ball().
  static JointGeometry pin(double radius, double radial_clearance,
                           double length,
                           JointBody inner_body = JointBody::carrier);

  /// The same with another radial clearance, m.
  /// @throws Error if it is out of range.
  JointGeometry with_clearance(double radial_clearance) const {
    JointGeometry other(kind_, radius_, radial_clearance, length_, inner_body_);
    other.seat_ = seat_;
    other.left_out_ = left_out_;
    return other;
  }
  /// The same ball in a seat that ends.
  /// @throws Error of a pin.
  JointGeometry with_seat(const SeatZone& zone) const;
  /// The same ball in a seat without end.
  JointGeometry without_seat() const;

  JointKind kind() const { return kind_; }
  /// rho1, m: of the ball or pin.
  double radius() const { return radius_; }
  /// eps = rho2 - rho1, m.
  double radial_clearance() const { return radial_clearance_; }
  /// ebar = eps/rho1.
  double relative_clearance() const { return radial_clearance_ / radius_; }
  /// Length of a pin, m; NaN for a ball.
  double length() const { return length_; }
  /// The body that has the ball or pin.
  JointBody inner_body() const { return inner_body_; }
  /// 1 if the carrier has the ball or pin, -1 if the body has it: the push on
  /// the body is along the force on the seat or hole, or against it.
  double side() const { return inner_body_ == JointBody::carrier ? 1 : -1; }
  /// Zone of a ball's seat, if it ends: Joint confines the contact to it.
  const std::optional<SeatZone>& seat() const { return seat_; }
  /// The same, or the one that without_seat() has left out: ContactLimits notes
  /// contacts that would reach a rim.
  const std::optional<SeatZone>& drawn_seat() const {
    return seat_ ? seat_ : left_out_;
  }

  /// The load of the half-angle laws that belongs to a normal force:
  /// R_n itself (N) for a ball, P = R_n/length (N/m) for a pin.
  double load_from_force(double force) const {
    return kind_ == JointKind::ball ? force : force / length_;
  }
  /// Inverse of load_from_force().
  double force_from_load(double load) const {
    return kind_ == JointKind::ball ? load : load * length_;
  }
  /// The unit of dimensionless pressures, Pa: R_n/rho1^2 for a ball, P/rho1
  /// for a pin.
  /// @param load  R_n, N (ball) or P, N/m (pin)
  double pressure_unit(double load) const {
    return kind_ == JointKind::ball ? load / radius_ / radius_ : load / radius_;
  }

  /// The projected area of catalogues, m^2: 2 rho1 length of a pin, pi rho1^2
  /// of a ball, of a seat that ends SeatZone::nominal_area().
  double nominal_area() const {
    if (drawn_seat()) return drawn_seat()->nominal_area(radius_);
    return kind_ == JointKind::ball ? std::numbers::pi * radius_ * radius_
                                    : 2 * radius_ * length_;
  }
  /// The force over nominal_area(), Pa.
  double nominal_pressure(double force) const { return force / nominal_area(); }

  /// Notes where the joint leaves the range of the theory, one sentence each;
  /// empty inside it. The theory is of first order in eps/rho1: a note above
  /// 0.015, below -0.01 and near 0 (1e-5); the effects of interference beside
  /// the contact; for a ball without clearance, that its seat has to retain it.
  std::vector<std::string> validity_notes() const;

  friend bool operator==(const JointGeometry& a, const JointGeometry& b) {
    return a.kind_ == b.kind_ && a.radius_ == b.radius_ &&
           a.radial_clearance_ == b.radial_clearance_ &&
           a.inner_body_ == b.inner_body_ && a.seat_ == b.seat_ &&
           (a.kind_ == JointKind::ball || a.length_ == b.length_);
  }

 private:
  JointGeometry(JointKind kind, double radius, double radial_clearance,
                double length, JointBody inner_body);

  JointKind kind_;
  double radius_;
  double radial_clearance_;
  double length_;
  JointBody inner_body_;
  std::optional<SeatZone> seat_ = {};
  std::optional<SeatZone> left_out_ = {};
};

/// Ties the load of a joint to its dimensionless load parameter.
///
/// | joint | load | load parameter |
/// |---|---|---|
/// | ball | R_n, N | mu = 3 R_n/(2 ebar rho1^2 E) |
/// | pin | P, N/m | lambda = 2 P/(pi ebar rho1 E) |
///
/// E is the effective modulus of the paper (twice E*), ebar = eps/rho1. Without
/// clearance the load parameter is infinite, with interference below 0.
/// Accuracy: relative error at most 5e-16 both ways
/// (pair/pair_test.cpp, against 50-digit arithmetic).
/// NaN passes through. Source: the paper, section 2.
class LoadScale {
 public:
  LoadScale(const JointGeometry& geometry, const ElasticPair& pair);

  /// @param load  R_n, N, or P, N/m
  double load_parameter(double load) const {
    return (load + 0.0) / unit_load_;  // no -0: its sign is the clearance's
  }
  /// @param load_parameter  mu or lambda
  double load(double load_parameter) const {
    return load_parameter * unit_load_;
  }
  /// The load at which the load parameter is 1, N or N/m; 0 without clearance,
  /// below 0 with interference.
  double unit_load() const { return unit_load_; }

  /// The variable x in which the half-angle laws are written: cbrt(mu) for a
  /// ball, 2 sqrt(lambda) for a pin. Relative error at most 5e-16
  /// (pair/pair_test.cpp). Negative lambda gives NaN.
  static double x_from_load_parameter(JointKind kind, double load_parameter);

  /// Inverse of x_from_load_parameter(): x^3 for a ball, x^2/4 for a pin.
  /// Relative error at most 3e-16 (pair/pair_test.cpp).
  static double load_parameter_from_x(JointKind kind, double x);

 private:
  double unit_load_;
};

}  // namespace contact
