// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/friction/integrals.hpp"
#include "libcontact/half_angle/law.hpp"
#include "libcontact/pair/contact_conditions.hpp"
#include "libcontact/pair/friction_law.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"
#include "libcontact/pressure/law.hpp"
#include "libcontact/pressure/validity.hpp"

namespace contact {

/// State of a contact, by clearance and load.
enum class ContactState {
  closed,     ///< interference: pressed together all round, theta0 = pi
  lifted,     ///< interference, opened on the side that the load leaves
  zero,       ///< no clearance: theta0 is the limit half-angle at every load
  clearance,  ///< as most joints have it
};

/// The contact of a joint's two halves: everything that is fixed about it
/// (geometry, elastic pair, friction, laws of half-angle and pressure),
/// validated once, and the friction of a contact whose normal force and
/// slip axis are known.
///
/// Friction force, sliding and spinning moment of a contact are
///
///     pressure_part R_n c + area_part a                         (3.7), (3.8)
///
/// (moments: times rho) with the coefficients c and the area integrals a of
/// integrals() and the strength() of the friction: (f0, A rho^2) if dry, (k1
/// rho |Dw|, k0 rho^3 |Dw|) if viscous. So one solver serves both, and pins as
/// well as balls: a pin's friction has the integrals
///
///     c = {1, S, 0},  a = (l/rho) {2 sin theta0, 2 theta0, 0}
///
/// at any slip axis, with S of PressureLaw::force_ratio(). A FrictionStress has
/// no such parts: c is then the whole, over R_n, with a strength of (1, 0).
class JointContact {
 public:
  /// For laws of one's own, or shared by hand; else make it from a JointSpec.
  /// @param pair        the materials at the surfaces
  /// @param conditions  loading and walls that the laws were made for
  /// @throws Error if the kinds of joint differ, a law is missing, or one was
  ///   made for other materials, another loading or other walls, or does not
  ///   know the joint's clearance.
  JointContact(JointGeometry geometry, ElasticPair pair, FrictionModel friction,
               std::shared_ptr<const HalfAngleLaw> half_angle_law,
               std::shared_ptr<const PressureLaw> pressure_law,
               const ContactConditions& conditions = {});

  /// The same contact with another friction.
  JointContact with_friction(FrictionModel friction) const {
    JointContact other = *this;
    other.friction_ = std::move(friction);
    return other;
  }
  /// The same contact with another clearance.
  /// @param radial_clearance  m
  /// @throws Error if it is out of range.
  JointContact with_clearance(double radial_clearance) const;

  /// The same contact whose seat or hole has worn, see WornHalfAngle and
  /// RunningInPressure.
  /// @param wear_number  v, [0, infinity)
  /// @throws Error if v is out of range.
  JointContact worn(double wear_number) const;

  const JointGeometry& geometry() const { return geometry_; }
  const ElasticPair& pair() const { return pair_; }
  const FrictionModel& friction() const { return friction_; }
  const HalfAngleLaw& half_angle_law() const { return *half_angle_law_; }
  const PressureLaw& pressure_law() const { return *pressure_law_; }
  bool is_viscous() const {
    return std::holds_alternative<ViscousLaw>(friction_);
  }
  /// The stress of pressure and speed, if friction is one; else null.
  const FrictionStress* stress() const {
    return std::get_if<FrictionStress>(&friction_);
  }
  /// Why the joint has no answer at rest, for messages; "" if it has one.
  std::string rest_refusal() const;

  /// Notes of geometry and half-angle law on use outside their range, one if
  /// the pressure law ends before the half-angle law, one if interference alone
  /// exceeds the stiffness of the softer body, and notes on a less accurate
  /// friction stress.
  std::vector<std::string> validity_notes() const;
  /// A further one, on where its numbers are from.
  void add_validity_note(std::string note) {
    notes_.push_back(std::move(note));
  }

  /// How large the contacts may be.
  ContactLimits limits() const { return {*half_angle_law_, pair_, geometry_}; }

  /// @throws Error if the joint has no clearance, or interference.
  /// @param what  that needs a clearance, for the message
  void require_clearance(const std::string& what) const;

  /// eps < 0.
  bool has_interference() const { return unit_force_ < 0; }
  /// p_0, Pa: the pressure of interference alone, the same all round. 0
  /// without interference.
  double interference_pressure() const noexcept;
  /// Excess pressure of a contact closed all round over one about to lift off
  /// under the same load, Pa: p_0 - p_1. 0 for others.
  double uniform_pressure(double normal_force,
                          double half_angle) const noexcept {
    return is_closed(half_angle)
               ? interference_pressure() - first_harmonic(normal_force)
               : 0;
  }
  /// R_n, N, above which a contact with interference is open opposite the
  /// load. 0 without interference.
  double lift_off_force() const noexcept { return lift_off_force_; }
  /// The friction moment that interference causes without any load, alike about
  /// every axis of a ball, N m: pin rho l (f0 2 pi rho p_0 + 2 pi rho A), ball
  /// pi^2 rho^3 (f0 p_0 + A). 0 without interference.
  /// @param speed  |Dw|, rad/s; without influence on dry friction. At 0 it is
  ///               the moment at which the joint breaks away.
  double unloaded_moment(double speed) const noexcept;

  /// Contact state under a load.
  ContactState state(double normal_force) const noexcept;
  /// The sum of the pressures without regard to their direction, N: S R_n, and
  /// for a closed contact the sum from its interference, at any load.
  double sum_of_pressures(double normal_force,
                          double half_angle) const noexcept;
  /// D, m: the shift of the centres from where they coincide; eps + approach
  /// with a clearance. NaN where the laws have none.
  double shift(double normal_force, double half_angle) const noexcept;

  /// mu or lambda; infinite without clearance, below 0 with interference; NaN
  /// of a pull.
  /// @param normal_force  R_n, N, >= 0
  double load_parameter(double normal_force) const noexcept {
    if (!(normal_force >= 0)) return std::numeric_limits<double>::quiet_NaN();
    return unit_force_ == 0 ? std::numeric_limits<double>::infinity()
                            : (normal_force + 0.0) / unit_force_;  // no -0
  }
  /// theta0 of the half-angle law.
  HalfAngleResult half_angle(double normal_force) const noexcept {
    return half_angle_law_->half_angle(load_factor_ *
                                       load_parameter(normal_force));
  }

  /// Arguments of a friction stress beside half-angle and slip axis.
  struct Load {
    double normal_force;  ///< R_n, N
    double speed;         ///< |Dw|, rad/s
  };
  static constexpr Load no_load = {std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::quiet_NaN()};
  /// Friction integrals for this joint's kind, friction and pressure law.
  /// @param half_angle  theta0, rad
  /// @param axis        slip axis; without influence for a pin
  /// @param load        without influence but for a friction stress, which is
  ///                    NaN without
  FrictionIntegrals integrals(double half_angle, SlipAxis axis,
                              const Load& load = no_load) const noexcept;

  /// Factors of the integrals.
  struct Strength {
    double pressure_part;  ///< f0 or k1 rho |Dw|
    double area_part;      ///< A rho^2 or k0 rho^3 |Dw|, N
  };
  /// @param speed  |Dw|, rad/s; without influence but for viscous friction
  Strength strength(double speed) const noexcept;

  /// Integrals of a load times their strength, N: friction force, and both
  /// moments over rho. They have values without load too, where coefficients
  /// over R_n have none.
  FrictionTriple friction_at(double half_angle, SlipAxis axis,
                             const Load& load) const noexcept;

  /// Area of the contact, m^2: 4 pi rho^2 sin^2(theta0/2) or 2 rho l theta0.
  double area(double half_angle) const noexcept;
  /// Peak pressure, Pa.
  double peak_pressure(double normal_force, double half_angle) const noexcept {
    if (is_closed(half_angle)) return closed_pressure(0, normal_force);
    return pressure_law_->peak(half_angle) * normal_force / unit_pressure_area_;
  }
  /// JointGeometry::pressure_unit() under R_n, Pa.
  double pressure_unit(double normal_force) const noexcept {
    return geometry_.pressure_unit(geometry_.load_from_force(normal_force));
  }
  /// p(theta), Pa; 0 outside the contact.
  /// @param theta  angle from the contact's centre, rad
  double pressure(double theta, double normal_force,
                  double half_angle) const noexcept {
    if (is_closed(half_angle)) return closed_pressure(theta, normal_force);
    return pressure_law_->pressure(theta, half_angle) *
           pressure_unit(normal_force);
  }
  /// How far the halves are pressed into each other, m from first touch, and
  /// dR_n/d(approach), N/m: HalfAngleLaw::approach() in SI units, with the same
  /// NaN. Without clearance and with interference there is no first touch: NaN.
  /// @param half_angle  theta0, rad
  ContactApproach approach(double half_angle) const noexcept {
    return approach(*half_angle_law_, geometry_, pair_, half_angle);
  }
  /// As above, for callers that need no friction.
  static ContactApproach approach(const HalfAngleLaw& law,
                                  const JointGeometry& geometry,
                                  const ElasticPair& pair,
                                  double half_angle) noexcept;
  /// Mean pressure over the contact, Pa.
  double mean_pressure(double normal_force, double half_angle) const noexcept {
    if (is_closed(half_angle)) return interference_pressure();
    return pressure_law_->mean(half_angle) * normal_force / unit_pressure_area_;
  }

 private:
  void set_clearance(const JointGeometry& geometry);
  void check_clearance() const;
  // All round: p_0 + p_1 cos(theta).
  bool is_closed(double half_angle) const noexcept {
    return has_interference() && half_angle == std::numbers::pi;
  }
  double first_harmonic(double normal_force) const noexcept;
  double closed_pressure(double theta, double normal_force) const noexcept;
  FrictionIntegrals closed_integrals(SlipAxis axis,
                                     double normal_force) const noexcept;
  FrictionTriple closed_friction(SlipAxis axis,
                                 const Load& load) const noexcept;
  FrictionTriple stress_forces(double half_angle, SlipAxis axis,
                               const Load& load) const noexcept;
  FrictionIntegrals stress_integrals(double half_angle, SlipAxis axis,
                                     const Load& load) const noexcept;

  JointGeometry geometry_;
  ElasticPair pair_;
  FrictionModel friction_;
  std::shared_ptr<const HalfAngleLaw> half_angle_law_;
  std::shared_ptr<const PressureLaw> pressure_law_;
  std::vector<std::string> notes_;
  double unit_force_;   // R_n at load parameter 1, of eps' sign
  double load_factor_;  // factor of the half-angle law
  double lift_off_force_ = 0;
  double unit_pressure_area_;  // rho^2 or rho l
};

}  // namespace contact
