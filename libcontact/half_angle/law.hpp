// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/pair/contact_conditions.hpp"
#include "libcontact/pair/inner_loading.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"

/// Half-angle theta0 of the contact against load, in both directions.
///
/// The load parameter is mu (ball) or lambda (pin), see
/// LoadScale; x is cbrt(mu) or 2 sqrt(lambda). Angles in radians.
namespace contact {

/// A half-angle and how it was found.
struct HalfAngleResult {
  double half_angle;  ///< theta0, rad; NaN if out_of_range
  Status status;
  /// dln(theta0)/dln(load): 1/3 (ball) or 1/2 (pin) at load 0. Absolute error
  /// at most 1e-15 (half_angle/paper_laws_test.cpp; Hertz: relative) unless a
  /// law says otherwise. NaN where a law does not know it.
  double log_slope = std::numeric_limits<double>::quiet_NaN();
};

/// A load parameter and how it was found.
struct LoadParameterResult {
  double load_parameter;  ///< mu or lambda; NaN if out_of_range
  Status status;
};

/// A law theta0(load) for one joint: fixed constants inside, both directions
/// as a pair of const functions. They do not allocate and do not throw.
class HalfAngleLaw {
 public:
  virtual ~HalfAngleLaw() = default;

  /// Name by which make_half_angle_law() (factory.hpp) makes it.
  virtual std::string name() const = 0;

  /// theta0 at a load.
  /// @param load_parameter  mu or lambda, [0, infinity]: infinite without
  ///         clearance. Below 0, -0.0 included, it belongs to an interference,
  ///         whose contact grows to 180 deg as the load falls: there only laws
  ///         with a closing_load() have values.
  /// @return theta0, rad; 0 at 0, limit_half_angle() at infinity. NaN with
  ///         out_of_range for NaN and where the law has no value.
  virtual HalfAngleResult half_angle(double load_parameter) const noexcept = 0;

  /// Inverse of half_angle().
  /// @param half_angle  theta0, rad, [0, limit_half_angle()]
  /// @return mu or lambda; 0 at 0. NaN with out_of_range for NaN and outside
  ///         the interval.
  virtual LoadParameterResult load_parameter(
      double half_angle) const noexcept = 0;

  /// Factor of a joint's load parameter where this law takes it, for ebar =
  /// eps/rho: 1, and 1 + ebar of Hertz', whose relative curvature takes both
  /// radii, eps/(rho^2 (1 + ebar)).
  virtual double load_factor(double /*relative_clearance*/) const noexcept {
    return 1;
  }

  /// Largest half-angle of the law with a clearance, rad.
  virtual double limit_half_angle() const noexcept = 0;

  /// The load parameter, below 0, at which a joint with interference begins to
  /// lift off: nearer to 0 its contact is closed all round, theta0 = pi. NaN of
  /// laws that know no interference: of all but ExactLaw.
  virtual double closing_load() const {
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// @throws Error if a joint with interference has no such load: its inner
  ///   body is loaded through the back, or the two cannot be pressed together.
  void require_closing_load() const;

  /// The shift D of the centres from where they coincide, over
  /// K_1 = (4 rho/E) p_1 (a pin's P = pi rho p_1, a ball's
  /// R_n = (4 pi/3) rho^2 p_1), and the stiffness as approach() has it, at
  /// half-angles that joints without clearance and with interference have:
  /// [limit_half_angle(), pi]. NaN outside, and where approach() is.
  virtual ContactApproach shift(double /*half_angle*/) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }

  /// Approach and stiffness at a half-angle in (0, limit_half_angle()), NaN
  /// outside. ExactLaw has them, and makes a table when first asked.
  virtual ContactApproach approach(double /*half_angle*/) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }

  /// Notes where the law is used outside the range stated by its source: one
  /// sentence each, empty inside it. Programs print them as warnings.
  /// @param pair  the materials of the joint
  virtual std::vector<std::string> validity_notes(
      const ElasticPair& pair) const = 0;

  JointKind joint_kind() const noexcept { return kind_; }
  /// The joints that it is for; none if it is for all.
  const std::optional<MadeFor>& made_for() const noexcept { return made_for_; }

 protected:
  explicit HalfAngleLaw(JointKind kind, std::optional<MadeFor> made_for = {})
      : kind_(kind), made_for_(std::move(made_for)) {}

 private:
  JointKind kind_;
  std::optional<MadeFor> made_for_;
};

}  // namespace contact
