#include "libcontact/duty/sliding_contact.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "libcontact/base/highest.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/pressure/expanded.hpp"
#include "libcontact/pressure/profile.hpp"

namespace contact {
namespace {

using Eigen::Vector3d;

// Part of a triple about the slip axis.
double about(const FrictionTriple& triple, SlipAxis axis) {
  return triple.sliding * axis.cos + triple.spinning * axis.sin;
}

// The root of a function that falls from `at_zero` at 0 to less than 0 at
// `end`, and bends more the nearer it is to `edge`: by secants from 0 and a
// guess. Four or five secants leave 1e-13, where TOMS 748 takes ten.
template <class Function>
double falling_root(const Function& function, double at_zero, double guess,
                    double end, double edge) {
  double low = 0;
  double high = end;
  double last = 0;
  double at_last = at_zero;
  double x = guess;
  for (int i = 0; i < 100; ++i) {
    const double at_x = function(x);
    if (at_x == 0) break;
    (at_x > 0 ? low : high) = x;
    const double step = -at_x * (x - last) / (at_x - at_last);
    const double step_before = x - last;
    last = x;
    at_last = at_x;
    if (x + step >= low && x + step <= high) {
      x += step;
      // The error left by a step is about its product with the one before.
      const double bend = std::min(x, edge - x);
      if (std::abs(step * step_before) < 1e-14 * x * bend &&
          std::abs(step) < 1e-4 * bend) {
        break;
      }
    } else {
      x = low + (high - low) / 2;
    }
  }
  return x;
}

// Place of the maximum of (1 - u^2)^n (1 + k u), u in [0, 1]: a pressure, n 0.5
// to 1, times slip on a contact so small that it is flat.
double flat_peak(double n, double k) {
  const double r = n / k;
  return 1 / (r + std::sqrt(r * r + 1 + 2 * n));
}

// Pa, of pressure and sliding speed.
double friction_stress(const FrictionModel& friction, double pressure,
                       double speed) {
  if (const auto* dry = std::get_if<FrictionLaw>(&friction)) {
    return dry->stress_at(pressure);
  }
  if (const auto* viscous = std::get_if<ViscousLaw>(&friction)) {
    return viscous->stress_at(pressure, speed);
  }
  return std::get<FrictionStress>(friction).stress_at(pressure, speed);
}

}  // namespace

SlidingContact::SlidingContact(const JointContact& contact,
                               const JointSolution& solution,
                               const Vector3d& angular_velocity)
    : contact_(&contact),
      profile_(std::make_shared<const detail::PressureProfile>(
          contact.pressure_law(), solution.half_angle)),
      angular_velocity_(angular_velocity),
      half_angle_(solution.half_angle),
      normal_force_(solution.normal_force),
      axis_{std::abs(solution.slip_axis.sin), solution.slip_axis.cos} {
  const JointGeometry& geometry = contact.geometry();
  const double rho = geometry.radius();
  const bool is_carrier = geometry.inner_body() == JointBody::carrier;
  centre_ = is_carrier ? solution.normal : Vector3d(-solution.normal);
  pressure_unit_ = contact.pressure_unit(normal_force_);
  rim_speed_ = rho * magnitude(angular_velocity);
  if (const auto* dry = std::get_if<FrictionLaw>(&contact.friction())) {
    heat_stress_ = {dry->coefficient(), dry->adhesion(), 1};
  } else if (const auto* viscous =
                 std::get_if<ViscousLaw>(&contact.friction())) {
    heat_stress_ = {viscous->pressure_slope(), viscous->constant(), 2};
  }
  uniform_pressure_ = contact.uniform_pressure(normal_force_, half_angle_);
  const bool is_pressed = normal_force_ != 0 || contact.has_interference();
  if (!is_pressed || rim_speed_ == 0) {
    pressure_unit_ = uniform_pressure_ = rim_speed_ = 0;
    return;
  }
  // Without load any place serves.
  if (centre_.isZero(0)) centre_ = angular_velocity.unitOrthogonal();
  add_totals(solution);
  pv_nominal_ =
      geometry.nominal_pressure(magnitude(solution.reaction)) * rim_speed_;
}

SlidingContact::Peaks SlidingContact::search(bool pv,
                                             bool heat_flux) const noexcept {
  const Peak none = {0, 0, centre_};
  Peaks found = {none, none};
  if (rim_speed_ == 0) return found;
  // Under walls it is less accurate than the law, and no faster.
  std::optional<detail::ExpandedPressure> expanded;
  if (!profile_->is_beyond_expansions()) {
    expanded.emplace(contact_->pressure_law(), half_angle_);
    if (expanded->is_empty()) expanded.reset();
  }
  const bool is_alike = !contact_->stress() &&
                        heat_stress_.constant_part == 0 &&
                        heat_stress_.power == 1;
  if (pv || is_alike) found.pv = largest({1, 0, 1}, expanded);
  if (!heat_flux) return found;
  if (is_alike) {
    found.heat_flux = found.pv;
    found.heat_flux.value *= heat_stress_.pressure_part;
  } else if (contact_->stress()) {
    found.heat_flux = largest_of_stress();
  } else {
    found.heat_flux = largest(heat_stress_, expanded);
  }
  return found;
}

SlidingContact::Rating SlidingContact::rating() const noexcept {
  const Peaks found = peaks();
  return {.pv = found.pv,
          .heat_flux = found.heat_flux,
          .pv_mean = pv_mean(),
          .pv_nominal = pv_nominal(),
          .nominal_area = contact_->geometry().nominal_area(),
          .pv_total = pv_total(),
          .heat = heat(),
          .slip_coefficient = slip_coefficient(),
          .slides = rim_speed_ > 0};
}

void SlidingContact::add_totals(const JointSolution& s) noexcept {
  const JointContact& contact = *contact_;
  const bool is_ball = contact.geometry().kind() == JointKind::ball;
  if (uniform_pressure_ > 0) {  // closed all round: pi/4 is the mean slip
    heat_ = -s.power;
    pv_total_ = rim_speed_ * (is_ball ? std::numbers::pi / 4 : 1) *
                contact.sum_of_pressures(normal_force_, half_angle_);
    slip_coefficient_ = pv_total_ / (rim_speed_ * normal_force_);
    return;
  }
  add_slip(s);
  pv_total_ = rim_speed_ * normal_force_ * slip_coefficient_;
}

void SlidingContact::add_slip(const JointSolution& s) noexcept {
  const JointContact& contact = *contact_;
  const bool is_ball = contact.geometry().kind() == JointKind::ball;
  const auto pressed = [&] {
    return about(friction_integrals(contact.pressure_law(), half_angle_, axis_)
                     .coefficient,
                 axis_);
  };
  if (contact.stress()) {
    heat_ = -s.power;
    slip_coefficient_ =
        is_ball ? pressed() : contact.pressure_law().force_ratio(half_angle_);
    return;
  }
  const auto& [pressure_part, constant_part, power] = heat_stress_;
  // All that friction needed the integrals for.
  if (constant_part == 0 && power == 1 && s.force_coefficient > 0) {
    heat_ = -s.power;
    slip_coefficient_ = heat_ / (rim_speed_ * normal_force_ * pressure_part);
    return;
  }
  const FrictionIntegrals i = contact.integrals(
      half_angle_, axis_, {normal_force_, magnitude(angular_velocity_)});
  const auto strength = contact.strength(magnitude(angular_velocity_));
  heat_ = rim_speed_ * (strength.pressure_part * normal_force_ *
                            about(i.coefficient, axis_) +
                        strength.area_part * about(i.area, axis_));
  // Integrals of viscous friction have |v| twice.
  slip_coefficient_ =
      power == 2 && is_ball ? pressed() : about(i.coefficient, axis_);
}

double SlidingContact::pressure_at(double theta) const noexcept {
  return is_at_work()
             ? pressure_unit_ * profile_->pressure(theta) + uniform_pressure_
             : 0;
}

double SlidingContact::pressure(const Vector3d& place) const noexcept {
  return pressure_at(2 * std::asin(std::min((place - centre_).norm() / 2, 1.)));
}

Vector3d SlidingContact::slip(const Vector3d& place) const noexcept {
  return contact_->geometry().radius() * angular_velocity_.cross(place);
}

double SlidingContact::pv(const Vector3d& place) const noexcept {
  return pressure(place) * slip(place).norm();
}

double SlidingContact::heat_flux(const Vector3d& place) const noexcept {
  const double chord = (place - centre_).norm();
  if (!is_at_work() || chord > 2 * std::sin(half_angle_ / 2)) return 0;
  const double speed = slip(place).norm();
  return friction_stress(contact_->friction(), pressure(place), speed) * speed;
}

// The largest |v| over rho |Dw| on the parallel theta.
double SlidingContact::share_of_speed(double theta) const noexcept {
  const double cosine = std::cos(theta);
  const double sine = std::sin(theta);
  if (axis_.sin * cosine <= axis_.cos * sine) return 1;  // theta >= a
  return axis_.cos * cosine + axis_.sin * sine;
}

double SlidingContact::value(const Stress& stress,
                             double theta) const noexcept {
  return (stress.pressure_part * pressure_at(theta) + stress.constant_part) *
         std::pow(rim_speed_ * share_of_speed(theta), stress.power);
}

double SlidingContact::peak_angle(const Stress& stress,
                                  const Expanded& expanded) const noexcept {
  if (!profile_->falls_outwards()) {
    return detail::highest([&](double theta) { return value(stress, theta); },
                           half_angle_);
  }
  const double part = stress.pressure_part * pressure_unit_;
  const double constant =
      stress.constant_part + stress.pressure_part * uniform_pressure_;
  // Derivative of the logarithm of strength and speed, times the strength
  // squared: finite at the edge, where slopes may be infinite and p is 0.
  using Value = detail::ExpandedPressure::Value;
  const auto slope = [&](double theta) {
    const auto [pressure, fall] =
        expanded ? expanded->at(theta)
                 : Value{profile_->pressure(theta), profile_->slope(theta)};
    const double s = part * pressure + constant;
    const double change = -part * fall;
    const double cosine = std::cos(theta);
    const double sine = std::sin(theta);
    const double ahead = axis_.sin * cosine - axis_.cos * sine;
    return s * (change * (axis_.cos * cosine + axis_.sin * sine) +
                stress.power * s * ahead);
  };
  const double peak = part * profile_->pressure(0);
  const double strength = peak + constant;
  const double at_centre = strength * strength * stress.power * axis_.sin;
  if (!(at_centre > 0)) return 0;
  const double axis_angle = std::atan2(axis_.sin, axis_.cos);
  double end = axis_angle;
  if (half_angle_ <= axis_angle) {
    end = half_angle_ * (1 - 1e-12);
    if (slope(end) >= 0) return half_angle_;  // the speed prevails
  }
  const double guess =
      half_angle_ * flat_peak(0.7 * peak / strength / stress.power,
                              half_angle_ * axis_.sin / axis_.cos);
  return falling_root(slope, at_centre, std::min(guess, 0.9 * end), end,
                      half_angle_);
}

SlidingContact::Peak SlidingContact::largest(
    const Stress& stress, const Expanded& expanded) const noexcept {
  const double theta = peak_angle(stress, expanded);
  return peak_at(theta, value(stress, theta));
}

SlidingContact::Peak SlidingContact::largest_of_stress() const noexcept {
  const auto flux = [&](double theta) {
    const double speed = rim_speed_ * share_of_speed(theta);
    return contact_->stress()->stress_at(pressure_at(theta), speed) * speed;
  };
  const double inside = detail::highest(flux, half_angle_);
  const double theta = flux(0) >= flux(inside) ? 0 : inside;
  return peak_at(theta, flux(theta));
}

SlidingContact::Peak SlidingContact::peak_at(double theta,
                                             double value) const noexcept {
  const double cosine = std::cos(theta);
  const double sine = std::sin(theta);
  const Vector3d w = angular_velocity_.stableNormalized();
  if (theta == 0) return {value, 0, centre_};
  // Away from Dw; of a pin round it.
  const Vector3d across = centre_.cross(w);
  const bool is_pin = contact_->geometry().kind() == JointKind::pin;
  Vector3d to = is_pin ? across : Vector3d(across.cross(centre_));
  if (to.isZero(0)) to = centre_.unitOrthogonal();
  if (w.dot(centre_) > 0 && !is_pin) to = -to;
  return {value, theta, cosine * centre_ + sine * to.normalized()};
}

double SlidingContact::pv_mean() const noexcept {
  return !is_at_work() ? 0 : pv_total() / contact_->area(half_angle_);
}

}  // namespace contact
