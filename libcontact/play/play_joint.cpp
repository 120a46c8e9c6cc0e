#include "libcontact/play/play_joint.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <unsupported/Eigen/AutoDiff>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"

// e, n, t, N, T, M as in docs/play.md.
namespace contact {
namespace {

constexpr double pi = std::numbers::pi;

// A number with its derivatives over position, velocity and rate.
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

template <class Real>
Real square(const Real& x) {
  return x * x;
}

}  // namespace

// Of a ball's friction at one half-angle and slip axis, made smooth: the
// friction force over cos a, the sliding moment over cos a and the spinning
// moment over sin a, each as its part of pressure and of area.
struct PlayJoint::Coefficients {
  std::array<double, 3> pressure;
  std::array<double, 3> area;
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
  detail::require(speed > 0 && std::isfinite(speed), "joint with play",
                  "regularisation_speed", speed, "above 0 m/s");
  coefficient_ = dry->coefficient();
  adhesion_ = dry->adhesion();
  contact_.emplace(joint.contact());
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
  const double rho = geometry.radius();
  const double eps = geometry.radial_clearance();
  const double vs = options_.regularisation_speed;
  Vector<Real> e = variables<Real>(motion.position, 0);
  const Vector<Real> velocity = variables<Real>(motion.velocity, 3);
  const Vector<Real> rate = variables<Real>(motion.rate, 6);
  const Vector<Real> axis = motion.axis.template cast<Real>();
  if (!ball) e -= axis * Real(axis.dot(e));

  Wrench<Real> result;
  const Real distance = sqrt(Real(e.squaredNorm()));
  const Real delta = distance - eps;
  // At touch the contact has begun, and NaN goes through.
  if (value_of(delta) < 0) return result;
  const ForceState at = law_.at(value_of(delta));
  result.state = at;
  const Vector<Real> n = e / distance;
  const Real force = chained(delta, at.force, at.slope);
  Real normal =
      force * (1 + options_.damping.damping() * Real(n.dot(velocity)));
  // Such speeds outwards are not those of an impact.
  if (value_of(normal) < 0) normal = Real(0) * normal;
  result.force = -normal * n;
  for (int i = 0; i < 3; ++i) result.normal(i) = value_of(n(i));
  result.normal_force = value_of(normal);
  if (!contact_ || value_of(delta) == 0) return result;

  const Real theta0 = chained(delta, at.half_angle, at.half_angle_slope);
  if (ball) {
    // u = Dw_eff/|Dw_eff| with the regularisation: smooth through 0.
    const Vector<Real> slip = rate + n.cross(velocity) / rho;
    const Real speed2 = slip.squaredNorm();
    const Vector<Real> u = slip * (rho / sqrt(rho * rho * speed2 + vs * vs));
    // sin^2 a; the coefficients are even about a = 0 and 90 deg, where they
    // would be 0/0.
    const bool slips = value_of(speed2) > 0;
    const Real spin = Real(n.dot(slip));
    const Real sine2 = slips ? Real(square(spin) / speed2) : Real(0 * spin);
    constexpr double margin = 1e-3;
    const double angle =
        std::clamp(std::asin(std::sqrt(std::clamp(value_of(sine2), 0.0, 1.0))),
                   margin, pi / 2 - margin);
    constexpr double step = 1e-4;
    const double theta_step = step * at.half_angle;
    const Coefficients c = coefficients(at.half_angle, angle);
    Coefficients slopes[4] = {c, c, c, c};
    if constexpr (!std::is_same_v<Real, double>) {
      slopes[0] = coefficients(at.half_angle - theta_step, angle);
      slopes[1] = coefficients(at.half_angle + theta_step, angle);
      slopes[2] = coefficients(at.half_angle, angle - step);
      slopes[3] = coefficients(at.half_angle, angle + step);
    }
    // d sin^2 a/da
    const double growth = std::sin(2 * angle);
    const auto number = [&](auto part, int i) -> Real {
      const auto difference = [&](int low, double width) {
        return ((slopes[low + 1].*part)[i] - (slopes[low].*part)[i]) /
               (2 * width);
      };
      return chained(theta0, sine2, (c.*part)[i], difference(0, theta_step),
                     difference(2, step) / growth);
    };
    const auto strength = [&](int i) -> Real {
      return coefficient_ * normal * number(&Coefficients::pressure, i) +
             adhesion_ * rho * rho * number(&Coefficients::area, i);
    };
    const Vector<Real> along = n * Real(n.dot(u));
    result.force -= u.cross(n) * strength(0);
    result.moment = -rho * ((u - along) * strength(1) + along * strength(2));
    return result;
  }
  // A pin's two parts: the force that goes with the slip at the contact's
  // centre, and what its curved surface adds to the moment.
  const auto direction = [vs](const Real& v) -> Real {
    return v / sqrt(v * v + vs * vs);
  };
  using std::sin;
  const Vector<Real> t = axis.cross(n);
  const Real turn = rho * Real(axis.dot(rate));
  const Real slip = turn + Real(t.dot(velocity));
  const double area = 2 * adhesion_ * rho * geometry.length();
  const Real excess =
      chained(delta, at.force_ratio - 1,
              (2 * at.energy * at.slope / (at.force * at.force) - 1) / eps);
  const Real friction =
      (coefficient_ * normal + area * sin(theta0)) * direction(slip);
  const Real own =
      (coefficient_ * normal * excess + area * (theta0 - sin(theta0))) *
      direction(turn);
  result.force -= t * friction;
  result.moment = axis * Real(-rho * (friction + own));
  return result;
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
          .friction_power =
              tangential.dot(motion.velocity) + moment.dot(motion.rate)};
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
  // Measured: docs/play.md, "Friction".
  constexpr double largest_share = 0.1;
  constexpr double wide = 30 * degree;
  const double turning = law_.geometry().radius() * motion.rate.norm();
  if (contact_ && law_.half_angle(delta) > wide &&
      motion.velocity.norm() > largest_share * turning) {
    notes.push_back(detail::message(
        "a half-angle of {:.4g} deg and a centre that moves at {:.3g} times "
        "the speed of the turning surface: friction is for narrower contacts, "
        "or below 0.1 times",
        law_.half_angle(delta) / degree, motion.velocity.norm() / turning));
  }
  return notes;
}

}  // namespace contact
