#include "libcontact/play/play_joint.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <unsupported/Eigen/AutoDiff>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"

// e, n, t, N, T, M as in docs/how-to/play.md.
namespace contact {
namespace {

using detail::pi;

// A number with its derivatives over position, velocity and angular velocity.
using Derivatives = Eigen::Matrix<double, 9, 1>;
using Dual = Eigen::AutoDiffScalar<Derivatives>;
template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;

double value_of(double x) { return x; }
double value_of(const Dual& x) { return x.value(); }

// f(x) by its value and slope, of any number x.
double chained(double, double value, double) { return value; }
Dual chained(const Dual& x, double value, double slope) {
  return {value, slope * x.derivatives()};
}
double chained(double, double, double value, double, double) { return value; }
Dual chained(const Dual& x, const Dual& y, double value, double over_x,
             double over_y) {
  return {value, over_x * x.derivatives() + over_y * y.derivatives()};
}

// The three vectors of a motion, number `first` of them the first variable.
template <class Real>
Vector<Real> variables(const Eigen::Vector3d& v, int first) {
  if constexpr (std::is_same_v<Real, double>) {
    return v;
  } else {
    Vector<Dual> result;
    for (int i = 0; i < 3; ++i) result(i) = Dual(v(i), 9, first + i);
    return result;
  }
}

}  // namespace

// Smoothed friction of a ball at one half-angle and slip axis: friction force
// over cos a, the sliding moment over cos a and the spinning moment over sin a,
// each as its part of pressure and of area.
struct PlayJoint::Coefficients {
  std::array<double, 3> pressure;
  std::array<double, 3> area;
};

// Kinematics of a motion at the contact.
template <class Real>
struct PlayJoint::Touch {
  Vector<Real> n, velocity, angular_velocity, axis;
  Real delta, normal;
  ForceState at;
};

template <class Real>
struct PlayJoint::Wrench {
  Vector<Real> force = Vector<Real>(Real(0), Real(0), Real(0));
  Vector<Real> moment = Vector<Real>(Real(0), Real(0), Real(0));
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double normal_force = 0;
  ForceState state = {0, 0, 0, 0, 1, 0};
};

PlayJoint::PlayJoint(const JointSpec& joint, const Options& options,
                     ForceLaw law)
    : law_(std::move(law)), options_(options) {
  if (!joint.friction) return;
  const auto* dry = std::get_if<FrictionLaw>(&*joint.friction);
  if (!dry) {
    throw Error(detail::needs(
        to_string(joint.geometry.kind()) + " joint with play", "dry friction"));
  }
  const double speed = options.regularisation_speed;
  detail::require(detail::is_above_zero(speed), "joint with play",
                  "regularisation_speed", speed, "above 0 m/s");
  coefficient_ = dry->coefficient();
  adhesion_ = dry->adhesion();
  contact_.emplace(joint.without_seat().contact());
}

// e, of a pin normal to its axis.
Eigen::Vector3d PlayJoint::offset(const PlayMotion& motion) const noexcept {
  if (law_.geometry().kind() == JointKind::ball) return motion.position;
  return motion.position - motion.axis.dot(motion.position) * motion.axis;
}

double PlayJoint::penetration(const PlayMotion& motion) const noexcept {
  return offset(motion).norm() - law_.geometry().radial_clearance();
}

double PlayJoint::penetration_rate(const PlayMotion& motion) const noexcept {
  return offset(motion).normalized().dot(motion.velocity);
}

PlayJoint::Coefficients PlayJoint::coefficients(double half_angle,
                                                double axis) const noexcept {
  const SlipAxis a = SlipAxis::from_angle(axis);
  const FrictionIntegrals i = contact_->integrals(half_angle, a);
  return {
      {i.coefficient.force / a.cos, i.coefficient.sliding / a.cos,
       i.coefficient.spinning / a.sin},
      {i.area.force / a.cos, i.area.sliding / a.cos, i.area.spinning / a.sin}};
}

template <class Real>
PlayJoint::Wrench<Real> PlayJoint::wrench(const PlayMotion& motion) const {
  using std::sqrt;
  const JointGeometry& geometry = law_.geometry();
  const bool ball = geometry.kind() == JointKind::ball;
  Vector<Real> e = variables<Real>(motion.position, 0);
  Touch<Real> touch;
  touch.velocity = variables<Real>(motion.velocity, 3);
  touch.angular_velocity = variables<Real>(motion.angular_velocity, 6);
  touch.axis = motion.axis.template cast<Real>();
  if (!ball) e -= touch.axis * Real(touch.axis.dot(e));

  Wrench<Real> result;
  const Real distance = sqrt(Real(e.squaredNorm()));
  touch.delta = distance - geometry.radial_clearance();
  // At touch the contact has begun, and NaN goes through.
  if (value_of(touch.delta) < 0) return result;
  touch.at = result.state = law_.at(value_of(touch.delta));
  touch.n = e / distance;
  const Real rate = touch.n.dot(touch.velocity);
  touch.normal = chained(touch.delta, touch.at.force, touch.at.slope) *
                 (1 + options_.damping.damping() * rate);
  // Such outward speeds do not come from an impact.
  if (value_of(touch.normal) < 0) touch.normal = Real(0) * touch.normal;
  result.force = -touch.normal * touch.n;
  for (int i = 0; i < 3; ++i) result.normal(i) = value_of(touch.n(i));
  result.normal_force = value_of(touch.normal);
  if (!contact_ || value_of(touch.delta) == 0) return result;
  if (ball) {
    add_ball_friction(touch, result);
  } else {
    add_pin_friction(touch, result);
  }
  return result;
}

template <class Real>
void PlayJoint::add_ball_friction(const Touch<Real>& touch,
                                  Wrench<Real>& to) const {
  using std::sqrt;
  const double rho = law_.geometry().radius();
  const double vs = options_.regularisation_speed;
  // u = Dw_eff/|Dw_eff| with the regularisation: smooth through 0.
  const Vector<Real> slip =
      touch.angular_velocity + touch.n.cross(touch.velocity) / rho;
  const Real speed2 = slip.squaredNorm();
  const Vector<Real> u = slip * (rho / sqrt(rho * rho * speed2 + vs * vs));
  // sin^2 a; the coefficients are even about a = 0 and 90 deg, where they
  // would be 0/0.
  const Real spin = touch.n.dot(slip);
  const Real sine2 =
      value_of(speed2) > 0 ? Real(spin * spin / speed2) : Real(0 * spin);
  constexpr double margin = 1e-3;
  const double angle =
      std::clamp(std::asin(std::sqrt(std::clamp(value_of(sine2), 0.0, 1.0))),
                 margin, pi / 2 - margin);
  constexpr double step = 1e-4;
  const double half_angle = touch.at.half_angle;
  const double half_angle_step = step * half_angle;
  const Coefficients c = coefficients(half_angle, angle);
  Coefficients ends[4] = {c, c, c, c};
  if constexpr (!std::is_same_v<Real, double>) {
    ends[0] = coefficients(half_angle - half_angle_step, angle);
    ends[1] = coefficients(half_angle + half_angle_step, angle);
    ends[2] = coefficients(half_angle, angle - step);
    ends[3] = coefficients(half_angle, angle + step);
  }
  const Real theta0 =
      chained(touch.delta, half_angle, touch.at.half_angle_slope);
  const auto number = [&](auto part, int i) -> Real {
    const double over_theta0 =
        ((ends[1].*part)[i] - (ends[0].*part)[i]) / (2 * half_angle_step);
    // d sin^2 a/da = sin 2a
    const double over_sine2 = ((ends[3].*part)[i] - (ends[2].*part)[i]) /
                              (2 * step * std::sin(2 * angle));
    return chained(theta0, sine2, (c.*part)[i], over_theta0, over_sine2);
  };
  const auto strength = [&](int i) -> Real {
    return coefficient_ * touch.normal * number(&Coefficients::pressure, i) +
           adhesion_ * rho * rho * number(&Coefficients::area, i);
  };
  const Vector<Real> along = touch.n * Real(touch.n.dot(u));
  to.force -= u.cross(touch.n) * strength(0);
  to.moment = -rho * ((u - along) * strength(1) + along * strength(2));
}

// Two parts: the force from the slip at the contact's centre, and the addition
// of the curved surface to its moment.
template <class Real>
void PlayJoint::add_pin_friction(const Touch<Real>& touch,
                                 Wrench<Real>& to) const {
  using std::sin;
  using std::sqrt;
  const JointGeometry& geometry = law_.geometry();
  const ForceState& at = touch.at;
  const double rho = geometry.radius();
  const double vs = options_.regularisation_speed;
  const auto direction = [vs](const Real& v) -> Real {
    return v / sqrt(v * v + vs * vs);
  };
  const Vector<Real> t = touch.axis.cross(touch.n);
  const Real turn = rho * Real(touch.axis.dot(touch.angular_velocity));
  const Real slip = turn + Real(t.dot(touch.velocity));
  const double area = 2 * adhesion_ * rho * geometry.length();
  const Real theta0 = chained(touch.delta, at.half_angle, at.half_angle_slope);
  // S - 1 and its slope, from W = (F/2) (delta - eps (S - 1)).
  const Real excess =
      chained(touch.delta, at.force_ratio - 1,
              (2 * at.energy * at.slope / (at.force * at.force) - 1) /
                  geometry.radial_clearance());
  const Real friction =
      (coefficient_ * touch.normal + area * sin(theta0)) * direction(slip);
  const Real own =
      (coefficient_ * touch.normal * excess + area * (theta0 - sin(theta0))) *
      direction(turn);
  to.force -= t * friction;
  to.moment = touch.axis * Real(-rho * (friction + own));
}

namespace {

PlayForce force_of(const PlayMotion& motion, const Eigen::Vector3d& force,
                   const Eigen::Vector3d& moment, const Eigen::Vector3d& normal,
                   double normal_force, const ForceState& state,
                   double penetration) {
  const Eigen::Vector3d tangential = force + normal_force * normal;
  const double rate = normal.dot(motion.velocity);
  return {.force = force,
          .moment = moment,
          .penetration = penetration,
          .normal_force = normal_force,
          .energy = state.energy,
          .damping_power = (state.force - normal_force) * rate,
          .friction_power = tangential.dot(motion.velocity) +
                            moment.dot(motion.angular_velocity)};
}

}  // namespace

PlayForce PlayJoint::operator()(const PlayMotion& motion) const noexcept {
  const auto w = wrench<double>(motion);
  return force_of(motion, w.force, w.moment, w.normal, w.normal_force, w.state,
                  penetration(motion));
}

PlayForce PlayJoint::operator()(const PlayMotion& motion,
                                PlayDerivatives& derivatives) const noexcept {
  const auto w = wrench<Dual>(motion);
  Eigen::Vector3d force;
  Eigen::Vector3d moment;
  for (int i = 0; i < 3; ++i) {
    force(i) = w.force(i).value();
    moment(i) = w.moment(i).value();
    derivatives.row(i) = w.force(i).derivatives();
    derivatives.row(3 + i) = w.moment(i).derivatives();
  }
  return force_of(motion, force, moment, w.normal, w.normal_force, w.state,
                  penetration(motion));
}

FrictionBounds PlayJoint::friction_bounds(
    const PlayMotion& motion) const noexcept {
  const ForceState at = law_.at(penetration(motion));
  const double rho = law_.geometry().radius();
  const double area = 2 * adhesion_ * rho * law_.geometry().length();
  const double sine = std::sin(at.half_angle);
  return {coefficient_ * at.force + area * sine,
          rho * (coefficient_ * at.force * (at.force_ratio - 1) +
                 area * (at.half_angle - sine))};
}

MomentSet PlayJoint::moment_set(const PlayMotion& motion) const noexcept {
  const ForceState at = law_.at(penetration(motion));
  return {*contact_, offset(motion).normalized(), at.force, at.half_angle};
}

std::vector<std::string> PlayJoint::notes(const PlayMotion& motion) const {
  std::vector<std::string> notes;
  const double delta = penetration(motion);
  if (delta > law_.largest_penetration()) {
    notes.push_back(detail::message(
        "a penetration of {:.4g} m is beyond the force law, which ends at "
        "{:.4g} m, a half-angle of {:.4g} deg",
        delta, law_.largest_penetration(),
        law_.half_angle(law_.largest_penetration()) / degree));
    return notes;
  }
  // Measured: docs/how-to/play.md, "Friction".
  constexpr double largest_share = 0.1;
  constexpr double wide = 30 * degree;
  const double turning =
      law_.geometry().radius() * motion.angular_velocity.norm();
  if (contact_ && law_.half_angle(delta) > wide &&
      motion.velocity.norm() > largest_share * turning) {
    notes.push_back(detail::message(
        "a half-angle of {:.4g} deg and a centre that moves at {:.3g} times "
        "the speed of the turning surface: friction holds for narrower "
        "contacts, or below 0.1 times",
        law_.half_angle(delta) / degree, motion.velocity.norm() / turning));
  }
  return notes;
}

}  // namespace contact
