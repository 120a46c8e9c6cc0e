// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <string_view>

#include "libcontact/base/error.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/friction/integrals.hpp"
#include "libcontact/joint/contact.hpp"

/// Results of a Joint. All vectors are in the frame of the given reaction;
/// forces and moments act on the body (the opposite ones on the carrier); Dw is
/// the angular velocity of the body relative to the carrier.
namespace contact {

namespace detail {
struct ContactWork;  // joint/contact_model.hpp
}  // namespace detail

/// Motion of the two halves of a joint against each other.
enum class JointState {
  sliding,   ///< they turn against each other
  resting,   ///< relative angular velocity exactly 0: no friction
  unloaded,  ///< no reaction and no interference: no contact, no friction
};

/// "ok", "out_of_range", "not_converged", "out_of_seat".
constexpr std::string_view to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::out_of_range:
      return "out_of_range";
    case Status::not_converged:
      return "not_converged";
    case Status::out_of_seat:
      break;
  }
  return "out_of_seat";
}

/// "sliding", "resting", "unloaded".
constexpr std::string_view to_string(JointState state) {
  switch (state) {
    case JointState::sliding:
      return "sliding";
    case JointState::resting:
      return "resting";
    case JointState::unloaded:
      break;
  }
  return "unloaded";
}

/// "closed", "lifted", "zero", "clearance".
constexpr std::string_view to_string(ContactState state) {
  switch (state) {
    case ContactState::closed:
      return "closed";
    case ContactState::lifted:
      return "lifted";
    case ContactState::zero:
      return "zero";
    case ContactState::clearance:
      break;
  }
  return "clearance";
}

/// When the solvers stop.
struct SolveOptions {
  /// Stop when |f/tan g - 1| is estimated to be at most this; f is the
  /// friction coefficient of the contact, g the friction angle.
  double tolerance = 1e-13;
  /// Largest number of contact evaluations.
  int evaluation_limit = 200;
};

/// Friction of one joint.
///
/// At rest (resting) and without load the friction is 0 and the slip axis
/// {0, 1} has no meaning; n = R/|R| at rest, 0 without load. A joint with
/// interference slides and rests without load too: n = 0 then, the moment is
/// opposite to Dw, and its coefficient over R_n is infinite. If the status is
/// out_of_range or out_of_seat all numbers are NaN.
///
/// A contact at a rim of its seat has no axis of symmetry: numbers about one
/// (slip axis, sliding and spinning coefficient, half-angle, load parameter,
/// slip velocity at the centre, friction angle) are NaN, and so is the
/// residual. n is the direction of the sum of the pressures, and R_t need not
/// be normal to it. If it is not_converged it has no numbers at all.
struct JointSolution {
  /// Start of the next solution: where this one was found and how it changes
  /// with R and Dw. Travels inside JointSolution; not for users.
  struct Memory {
    bool valid = false;
    double reaction_force = 0;     ///< R
    SineCosine reaction = {0, 1};  ///< min(b, pi - b)
    double tangent = 0;            ///< tan psi
    double normal_force = 0;       ///< R_n
    double cosine = 0;             ///< cos a
    double friction = 0;           ///< f/cos a
    /// dln(f/cos a) over dln R_n and dln cos^2 a.
    double force_slope = 0;
    double cosine_slope = 0;
    /// d(residual) over dln tan psi; dln tan psi over dln R and db.
    double residual_slope = 1;
    double force_response = 0;
    double angle_response = 0;
  };

  Status status = Status::out_of_range;
  JointState state = JointState::sliding;
  /// Evaluations of the contact's friction that were needed.
  int evaluations = 0;
  /// Estimate of |f/tan g - 1| that is left.
  double residual = 0;

  /// R = R_n n + R_t, N.
  Eigen::Vector3d reaction = Eigen::Vector3d::Zero();
  /// n, unit vector along the normal force.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  /// R_n, N.
  double normal_force = 0;
  /// R_t, N; normal to n and to Dw.
  Eigen::Vector3d friction_force = Eigen::Vector3d::Zero();
  /// M_t about the joint's centre, N m.
  Eigen::Vector3d friction_moment = Eigen::Vector3d::Zero();
  /// Velocity of the body's half over the carrier's at the centre, m/s.
  Eigen::Vector3d slip_velocity = Eigen::Vector3d::Zero();
  /// M_t . Dw, W; never positive.
  double power = 0;

  /// f0 rho R of dry friction, N m: the friction moment of textbooks, which
  /// know no contact; NaN of other friction.
  double textbook_moment = 0;

  /// Sine and cosine of b, the angle between R and Dw, [0, pi].
  SineCosine reaction_direction = {0, 1};
  /// Sine and cosine of the friction angle g, tan g = R_t/R_n.
  SineCosine friction_direction = {0, 1};
  /// Sine and cosine of the slip axis angle a.
  SlipAxis slip_axis = {0, 1};

  /// R_t/R_n = f = tan g.
  double force_coefficient = 0;
  /// Moment about the part of Dw normal to n, over -rho R_n.
  double sliding_coefficient = 0;
  /// Moment about n, over -rho R_n: of the sign of Dw . n unless tau(v) falls.
  double spinning_coefficient = 0;
  /// Abar = A rho^2/(f0 R_n): adhesion against pressure (viscous:
  /// k0 rho^2/(k1 R_n)); infinite without the latter.
  double adhesion_number = 0;

  /// Contact state under this load.
  ContactState contact_state = ContactState::clearance;
  /// mu or lambda; infinite without clearance, below 0 with interference.
  double load_parameter = 0;
  /// theta0, rad.
  double half_angle = 0;
  /// Largest contact pressure by the joint's pressure law, Pa; 0 without a
  /// contact.
  double peak_pressure = 0;
  /// Area of the contact, m^2: 4 pi rho^2 sin^2(theta0/2), of a pin
  /// 2 rho l theta0.
  double contact_area = 0;

  Memory memory;

  /// The work that found a contact at a rim; null of a joint without end.
  /// Joint::rims() and others read it.
  std::shared_ptr<const detail::ContactWork> work = {};
  /// The same without the grid of a contact at a rim, of 0.1 to 0.2 MB: for
  /// those who keep many. Joint::with_grid() finds it again.
  JointSolution without_grid() const;

  /// f_M = |M_t|/(rho R): what catalogues call the coefficient of friction;
  /// to 1e-14 over cos a of the vectors, which lose digits towards spinning
  /// (joint/ball_joint_test.cpp, joint/pin_joint_test.cpp).
  double moment_coefficient() const;
  /// Heat of friction over the contact's area, W/m^2; 0 at rest and without a
  /// contact. To 1e-15 (joint/ball_joint_test.cpp).
  double mean_heat_flux() const {
    return power == 0 ? 0 : -power / contact_area;
  }

  /// b, rad, [0, pi].
  double reaction_angle() const {
    return std::atan2(reaction_direction.sin, reaction_direction.cos);
  }
  /// g, rad, [0, pi/2].
  double friction_angle() const {
    return std::atan2(friction_direction.sin, friction_direction.cos);
  }
  /// min(b, pi - b) - g, rad, to full relative accuracy however strong the
  /// friction: what is left of the range of g.
  double friction_angle_margin() const {
    // sin^2 b - sin^2 g = cos^2 g cos^2 a
    const SineCosine b = reaction_direction;
    const SineCosine g = friction_direction;
    const double cb = std::abs(b.cos);
    const double leg = g.cos * slip_axis.cos;
    if (leg == 0) return 0;
    return std::atan2(leg * (leg / (b.sin * g.cos + cb * g.sin)),
                      cb * g.cos + b.sin * g.sin);
  }
  /// a, rad, [-pi/2, pi/2].
  double slip_axis_angle() const {
    return std::atan2(slip_axis.sin, slip_axis.cos);
  }
  /// pi/2 - |a|, rad, to full relative accuracy.
  double slip_axis_complement() const {
    return std::atan2(slip_axis.cos, std::abs(slip_axis.sin));
  }
};

}  // namespace contact
