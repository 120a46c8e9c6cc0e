#include "libcontact/joint/joint.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/joint/contact_model.hpp"
#include "libcontact/joint/slip/slip_equation.hpp"
#include "libcontact/joint/slip/taken_force.hpp"

namespace contact {
namespace {

using detail::nan;

}  // namespace

JointSolution detail::not_a_number(Status status,
                                   const Eigen::Vector3d& reaction) {
  const Eigen::Vector3d none = Eigen::Vector3d::Constant(nan);
  JointSolution s;
  s.status = status;
  s.residual = nan;
  s.reaction = reaction;
  s.normal = s.friction_force = s.friction_moment = s.slip_velocity = none;
  s.reaction_direction = s.friction_direction = {nan, nan};
  s.slip_axis = {nan, nan};
  s.normal_force = s.power = s.textbook_moment = nan;
  s.force_coefficient = s.sliding_coefficient = s.spinning_coefficient = nan;
  s.adhesion_number = s.load_parameter = s.half_angle = nan;
  s.peak_pressure = s.contact_area = nan;
  return s;
}

std::vector<std::string> detail::failure_notes(Status status,
                                               const char* without) {
  if (status == Status::ok) return {};
  if (status != Status::not_converged) return {without};
  return {"the solution has not converged"};
}

void detail::set_state(JointSolution& s, const JointContact& contact,
                       const JointContact::Strength& strength) {
  s.contact_state = contact.state(s.normal_force);
  s.adhesion_number =
      strength.area_part == 0
          ? 0
          : strength.area_part / (strength.pressure_part * s.normal_force);
}

double detail::textbook_moment(const JointContact& contact,
                               const Eigen::Vector3d& reaction) {
  const auto* dry = std::get_if<FrictionLaw>(&contact.friction());
  return dry ? dry->coefficient() * contact.geometry().radius() *
                   magnitude(reaction)
             : nan;
}

namespace {

using detail::not_a_number;
using detail::SlipEquation;
using detail::SlipRoot;
using detail::taken;
using detail::textbook_moment;
using Eigen::Vector3d;

using detail::infinity;

// A vector as length and direction; NaN if it has none. No overflow.
struct Polar {
  double length;
  Vector3d direction;

  explicit Polar(const Vector3d& v) : length(magnitude(v)) {
    direction = detail::has_square(length)
                    ? Vector3d(v / length)
                    : (v / v.cwiseAbs().maxCoeff()).normalized();
  }
};

// Sets what follows from all of a solution, or that there is none: laws of
// half-angle and pressure may end at different half-angles, and say nothing of
// larger ones.
void finish(JointSolution& s, const JointContact& contact) {
  const bool is_known =
      std::isfinite(s.half_angle) && s.friction_force.allFinite() &&
      s.friction_moment.allFinite() && !std::isnan(s.peak_pressure);
  s.textbook_moment = textbook_moment(contact, s.reaction);
  if (!is_known) s = not_a_number(Status::out_of_range, s.reaction);
}

// Sets the quantities that depend on R_n and theta0 alone.
void set_contact(JointSolution& s, const JointContact& contact, double force,
                 double half_angle, JointContact::Strength strength) {
  s.normal_force = force;
  s.load_parameter = contact.load_parameter(force);
  s.half_angle = half_angle;
  s.contact_area = contact.area(half_angle);
  const bool is_pressed = force > 0 || contact.has_interference();
  s.peak_pressure = is_pressed ? contact.peak_pressure(force, half_angle) : 0;
  detail::set_state(s, contact, strength);
}

// No relative motion: the reaction alone.
JointSolution resting_solution(const JointContact& contact,
                               const Vector3d& reaction, const Polar& force) {
  const bool loaded = force.length > 0;
  const HalfAngleResult half_angle = contact.half_angle(force.length);
  if (half_angle.status != Status::ok) {
    return not_a_number(Status::out_of_range, reaction);
  }
  JointSolution s;
  s.status = Status::ok;
  s.state = loaded || contact.has_interference() ? JointState::resting
                                                 : JointState::unloaded;
  s.reaction = reaction;
  s.normal = loaded ? force.direction : Vector3d(Vector3d::Zero());
  s.friction_force = s.friction_moment = s.slip_velocity = Vector3d::Zero();
  s.power = 0;
  s.reaction_direction = {1, 0};
  s.friction_direction = {0, 1};
  s.slip_axis = {0, 1};
  s.force_coefficient = s.sliding_coefficient = s.spinning_coefficient = 0;
  set_contact(s, contact, force.length, half_angle.half_angle,
              contact.strength(0));
  finish(s, contact);
  return s;
}

// Sliding under interference alone: closed all round, every axis alike.
JointSolution without_load(const JointContact& contact, const Polar& spin) {
  JointSolution s;
  s.status = Status::ok;
  s.state = JointState::sliding;
  s.evaluations = 1;
  const double moment = contact.unloaded_moment(spin.length);
  s.friction_moment = -moment * spin.direction;
  s.power = -moment * spin.length;
  s.reaction_direction = s.friction_direction = {0, 1};
  s.sliding_coefficient = infinity;
  set_contact(s, contact, 0, contact.half_angle(0).half_angle,
              contact.strength(spin.length));
  finish(s, contact);
  return s;
}

// The contact in the plane that Dw sees along itself: d is the direction of
// the part of n normal to w, and R_t lies along -+ t = w x d.
struct SlipFrame {
  Vector3d w;
  Vector3d d;
  Vector3d t;
};

void set_vectors(JointSolution& s, const JointContact& contact,
                 const SlipFrame& frame, double speed, double friction_force) {
  const double rho = contact.geometry().radius();
  const double swap = contact.geometry().side();
  const double sin_a = s.slip_axis.sin;
  const double cos_a = s.slip_axis.cos;
  s.normal = sin_a * frame.w + cos_a * frame.d;
  s.friction_force = -swap * friction_force * frame.t;
  s.slip_velocity = swap * rho * speed * cos_a * frame.t;
  // (3.8) with j = w cos a - d sin a, n = w sin a + d cos a.
  const double scale = rho * s.normal_force;
  const double along =
      s.sliding_coefficient * cos_a + s.spinning_coefficient * sin_a;
  const double across =
      s.spinning_coefficient * cos_a - s.sliding_coefficient * sin_a;
  s.friction_moment = -scale * (along * frame.w + across * frame.d);
  s.power = -scale * along * speed;
}

}  // namespace

Joint::Joint(JointContact contact) : contact_(std::move(contact)) {
  if (contact_.geometry().seat()) {
    throw Error(detail::needs("a joint of a contact in a seat that ends",
                              "its JointSpec, or without_seat()"));
  }
}

namespace {

// A Placement asks for a pin that ends, and there is none.
JointSolution refused(const Vector3d& reaction) {
  JointSolution s = not_a_number(Status::out_of_range, reaction);
  s.work = std::make_shared<detail::PlacementRefused>();
  return s;
}

}  // namespace

JointSolution Joint::solve_confined(
    const Slip& slip, const JointSolution& last,
    const SolveOptions& options) const noexcept {
  if (slip.placement && (is_pin() || slip.placement->ends_pin())) {
    if (tilted_) return tilted_->solve(slip, last, options);
    return refused(slip.reaction);
  }
  if (model_) return model_->solve(slip, last, options);
  return solve_from(last.memory, slip, options);
}

MomentSet Joint::confined_moment_set(
    const JointSolution& solution) const noexcept {
  if (auto moments = model_->moments(solution)) {
    return {contact_, std::move(moments)};
  }
  return {contact_, solution.normal, solution.normal_force,
          solution.half_angle};
}

std::shared_ptr<const detail::ContactMoments> detail::moments_of(
    const Joint& joint, const JointSolution& solution) {
  return joint.model_ ? joint.model_->moments(solution) : nullptr;
}

JointSolution Joint::solve_from(const JointSolution::Memory& last,
                                const Slip& slip,
                                const SolveOptions& options) const noexcept {
  const Vector3d reaction =
      taken(*this, slip.reaction, slip.angular_velocity, slip.axis);
  const Polar force(reaction);
  const Polar spin(slip.angular_velocity);
  if (!(force.length < infinity && spin.length < infinity)) {
    return not_a_number(Status::out_of_range, reaction);
  }
  if (force.length == 0 && spin.length > 0 && contact_.has_interference()) {
    return without_load(contact_, spin);
  }
  if (force.length == 0 || spin.length == 0) {
    return resting_solution(contact_, reaction, force);
  }
  const Vector3d& w = spin.direction;
  const Vector3d& e = force.direction;
  // The frame of w: e = w cos b + p sin b, q = w x p.
  const Vector3d cross = w.cross(e);
  const double sin_b = cross.norm();
  // A pin's reaction is normal to its axis, rounding or not.
  const double cos_b = is_pin() ? 0 : w.dot(e);
  const Vector3d q = sin_b > 0 ? Vector3d(cross / sin_b) : w.unitOrthogonal();
  const Vector3d p = q.cross(w);

  const SlipEquation equation(contact_, spin.length, force.length,
                              {sin_b, std::abs(cos_b)});
  const SlipRoot root = solve_slip(equation, last, options);
  if (root.status == Status::out_of_range ||
      root.point.half_angle.status != Status::ok) {
    return not_a_number(Status::out_of_range, reaction);
  }

  JointSolution s;
  s.status = root.status;
  s.state = JointState::sliding;
  s.evaluations = root.evaluations;
  s.residual = root.residual;
  s.memory = root.memory;
  s.reaction = reaction;
  const detail::SlipTriangle<double>& t = root.point.triangle;
  const double sin_g = sin_b * t.sin_psi;
  s.reaction_direction = {sin_b, cos_b};
  s.friction_direction = {sin_g, t.cos_g};
  s.slip_axis = {std::copysign(t.axis_sin, cos_b), t.axis_cos};
  s.force_coefficient = sin_g / t.cos_g;
  s.sliding_coefficient = root.point.sliding;
  s.spinning_coefficient = std::copysign(1.0, cos_b) * root.point.spinning;
  set_contact(s, contact_, root.point.normal_force,
              root.point.half_angle.half_angle, equation.strength());
  const double turn = contact_.geometry().side() * t.sin_psi;
  const SlipFrame frame = {w, t.cos_psi * p + turn * q,
                           t.cos_psi * q - turn * p};
  set_vectors(s, contact_, frame, spin.length, force.length * sin_g);
  finish(s, contact_);
  return s;
}

JointSolution Joint::solve_contact(const KnownContact& known) const noexcept {
  if (known.placement && (is_pin() || known.placement->ends_pin()))
      [[unlikely]] {
    if (tilted_) return tilted_->solve_contact(known);
    return refused(known.normal_force);
  }
  if (model_) [[unlikely]]
    return model_->solve_contact(known);
  const Vector3d normal_force =
      taken(*this, known.normal_force, known.angular_velocity, known.axis);
  const Polar force(normal_force);
  const Polar spin(known.angular_velocity);
  if (!(force.length < infinity && spin.length < infinity)) {
    return not_a_number(Status::out_of_range, normal_force);
  }
  if (force.length == 0 && spin.length > 0 && contact_.has_interference()) {
    return without_load(contact_, spin);
  }
  if (force.length == 0 || spin.length == 0) {
    return resting_solution(contact_, normal_force, force);
  }
  const HalfAngleResult half_angle = contact_.half_angle(force.length);
  if (half_angle.status != Status::ok) {
    return not_a_number(Status::out_of_range, normal_force);
  }
  const Vector3d& w = spin.direction;
  const Vector3d cross = w.cross(force.direction);
  const double cos_a = cross.norm();
  const Vector3d t = cos_a > 0 ? Vector3d(cross / cos_a) : w.unitOrthogonal();

  JointSolution s;
  s.status = Status::ok;
  s.state = JointState::sliding;
  s.evaluations = 1;
  s.slip_axis = {is_pin() ? 0 : w.dot(force.direction), cos_a};
  const JointContact::Strength strength = contact_.strength(spin.length);
  const FrictionIntegrals i = contact_.integrals(
      half_angle.half_angle, s.slip_axis, {force.length, spin.length});
  const double area = strength.area_part / force.length;
  const auto coefficient = [&](double pressure_part, double area_part) {
    return strength.pressure_part * pressure_part + area * area_part;
  };
  s.force_coefficient = coefficient(i.coefficient.force, i.area.force);
  s.sliding_coefficient = coefficient(i.coefficient.sliding, i.area.sliding);
  s.spinning_coefficient = coefficient(i.coefficient.spinning, i.area.spinning);
  const double f = s.force_coefficient;
  const double hypotenuse_f = std::hypot(1, f);
  s.friction_direction = {f / hypotenuse_f, 1 / hypotenuse_f};
  set_contact(s, contact_, force.length, half_angle.half_angle, strength);
  set_vectors(s, contact_, {w, t.cross(w), t}, spin.length, f * force.length);
  s.reaction = normal_force + s.friction_force;
  // cos b = sin a cos g; sin b is the length of the part of R normal to w.
  s.reaction_direction = {s.friction_direction.cos * std::hypot(cos_a, f),
                          s.friction_direction.cos * s.slip_axis.sin};
  finish(s, contact_);
  return s;
}

JointSolution JointSolution::without_grid() const {
  JointSolution other = *this;
  if (work) other.work = work->without_grid();
  return other;
}

double JointSolution::moment_coefficient() const {
  if (work && std::isnan(sliding_coefficient)) return work->moment_coefficient;
  if (normal_force == 0) return 0;
  return std::hypot(sliding_coefficient, spinning_coefficient) *
         (normal_force / magnitude(reaction));
}

}  // namespace contact
