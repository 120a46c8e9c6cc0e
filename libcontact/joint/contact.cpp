#include "libcontact/joint/contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/instruction_set.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/harmonics.hpp"
#include "libcontact/friction/models.hpp"
#include "libcontact/friction/stress_rule.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/half_angle/worn.hpp"
#include "libcontact/pressure/registry.hpp"
#include "libcontact/pressure/running_in.hpp"

namespace contact {
namespace {

void check_kind(JointKind joint, JointKind law, const char* what) {
  if (joint == law) return;
  throw Error(
      detail::must_be(detail::message("{} joint: {} law for a {} joint",
                                      to_string(joint), what, to_string(law)),
                      detail::message("for a {} joint", to_string(joint))));
}

// A law of another joint would give plausible numbers.
template <class Law>
void check_made_for(const Law& law, bool allowed, const ElasticPair& pair,
                    const ContactConditions& conditions, const char* what) {
  const auto& made_for = law.made_for();
  if (made_for ? made_for->fits(pair, conditions) : allowed) return;
  throw Error(detail::must_be(
      detail::message("{} joint: {} law {}", to_string(law.joint_kind()), what,
                      law.name()),
      "made for the materials, the loading and the walls of this joint"));
}

double force_at_load_parameter_one(const JointGeometry& geometry,
                                   const ElasticPair& pair) {
  return geometry.force_from_load(LoadScale(geometry, pair).unit_load());
}

}  // namespace

ContactApproach JointContact::approach(const HalfAngleLaw& law,
                                       const JointGeometry& geometry,
                                       const ElasticPair& pair,
                                       double half_angle) noexcept {
  const double length = geometry.kind() == JointKind::ball ? geometry.radius()
                                                           : geometry.length();
  if (!(geometry.radial_clearance() > 0)) {
    using detail::nan;
    const double stiffness = law.shift(half_angle).stiffness;
    return {nan, stiffness * (pair.effective_modulus() * length)};
  }
  const ContactApproach unit = law.approach(half_angle);
  return {unit.approach * geometry.radial_clearance(),
          unit.stiffness * (pair.effective_modulus() * length)};
}

JointContact::JointContact(JointGeometry geometry, ElasticPair pair,
                           FrictionModel friction,
                           std::shared_ptr<const HalfAngleLaw> half_angle_law,
                           std::shared_ptr<const PressureLaw> pressure_law,
                           const ContactConditions& conditions)
    : geometry_(geometry),
      pair_(std::move(pair)),
      friction_(std::move(friction)),
      half_angle_law_(std::move(half_angle_law)),
      pressure_law_(std::move(pressure_law)) {
  detail::check_instruction_set();
  const JointKind kind = geometry_.kind();
  if (!half_angle_law_ || !pressure_law_) {
    throw Error(detail::needs(to_string(kind) + " joint",
                              "a half-angle law and a pressure law"));
  }
  check_kind(kind, half_angle_law_->joint_kind(), "half-angle");
  check_kind(kind, pressure_law_->joint_kind(), "pressure");
  if (conditions.walls && conditions.walls->radius() != geometry_.radius()) {
    throw Error(detail::must_be(
        detail::message("{} joint: radius of its walls = {} m", to_string(kind),
                        conditions.walls->radius()),
        detail::message("the joint's, {} m", geometry_.radius())));
  }
  check_made_for(*half_angle_law_,
                 half_angle_law_allows(half_angle_law_->name(), conditions),
                 pair_, conditions, "half-angle");
  check_made_for(*pressure_law_,
                 pressure_law_allows(pressure_law_->name(), conditions), pair_,
                 conditions, "pressure");
  unit_pressure_area_ =
      geometry_.force_from_load(1) / geometry_.pressure_unit(1);
  set_clearance(geometry_);
  // Some integrals build a quadrature rule on first use: do it here, so that
  // solve() never allocates.
  integrals(0.5, SlipAxis{0, 1}, {1, 1});
}

JointContact JointContact::with_clearance(double radial_clearance) const {
  JointContact other = *this;
  other.set_clearance(geometry_.with_clearance(radial_clearance));
  return other;
}

void JointContact::set_clearance(const JointGeometry& geometry) {
  geometry_ = geometry;
  unit_force_ = force_at_load_parameter_one(geometry_, pair_);
  load_factor_ = half_angle_law_->load_factor(geometry_.relative_clearance());
  lift_off_force_ = 0;
  check_clearance();
  // Makes the tables of interference too, so that no solution has to.
  if (has_interference()) {
    lift_off_force_ = half_angle_law_->closing_load() * unit_force_;
  }
}

void JointContact::check_clearance() const {
  const ContactConditions conditions{
      .clearance = clearance_of(geometry_.radial_clearance())};
  const std::string half_angle = half_angle_law_->name();
  if (!half_angle_law_allows(half_angle, conditions)) {
    detail::refuse_law("half-angle law", half_angle,
                       detail::half_angle_entries(), conditions);
  }
  const std::string pressure = pressure_law_->name();
  if (!pressure_law_allows(pressure, conditions)) {
    detail::refuse_law("pressure law", pressure, detail::pressure_entries(),
                       conditions);
  }
  if (has_interference()) half_angle_law_->require_closing_load();
}

void JointContact::require_clearance(const std::string& what) const {
  if (unit_force_ > 0) return;
  throw Error(detail::needs(
      what, detail::message("a radial_clearance above 0 m, not {}",
                            geometry_.radial_clearance())));
}

JointContact JointContact::worn(double wear_number) const {
  require_clearance("a worn joint");
  JointContact other = *this;
  other.half_angle_law_ =
      std::make_shared<WornHalfAngle>(half_angle_law_, wear_number);
  other.pressure_law_ =
      std::make_shared<RunningInPressure>(pressure_law_, wear_number);
  return other;
}

std::vector<std::string> JointContact::validity_notes() const {
  std::vector<std::string> notes = geometry_.validity_notes();
  notes.insert(notes.end(), notes_.begin(), notes_.end());
  for (std::string& note : half_angle_law_->validity_notes(pair_)) {
    notes.push_back(std::move(note));
  }
  // The two ends of the same solution differ by rounding.
  constexpr double rounding = 1e-9;
  const double largest = pressure_law_->largest_half_angle();
  const bool goes_on = pressure_law_->closing_half_angle() == std::numbers::pi;
  if (!goes_on &&
      half_angle_law_->limit_half_angle() > largest * (1 + rounding)) {
    notes.push_back(detail::message(
        "pressure law {} ends at {:.4g} deg, before the limit "
        "half-angle of law {}",
        pressure_law_->name(), largest / degree, half_angle_law_->name()));
  }
  const double softer =
      std::min(pair_.inner().youngs_modulus, pair_.outer().youngs_modulus);
  if (interference_pressure() > softer) {
    notes.push_back(detail::message(
        "interference pressure {:.4g} MPa exceeds Young's modulus of the "
        "softer body, {:.4g} MPa: a nearly incompressible layer cannot be "
        "pressed together",
        interference_pressure() / 1e6, softer / 1e6));
  }
  if (stress() && !stress()->note().empty()) notes.push_back(stress()->note());
  return notes;
}

std::string JointContact::rest_refusal() const {
  if (!stress() || stress()->over_speed() != FrictionStress::OverSpeed::falls)
    return {};
  return "friction that does not fall with the speed: otherwise the joint "
         "sticks and slips, and the moments that it holds form no convex set";
}

namespace {

// S of p_0/p_1.
double sum_factor(JointKind kind) { return kind == JointKind::ball ? 3 : 2; }

}  // namespace

double JointContact::first_harmonic(double normal_force) const noexcept {
  const bool is_ball = geometry_.kind() == JointKind::ball;
  return pressure_unit(normal_force) / std::numbers::pi * (is_ball ? 0.75 : 1);
}

double JointContact::interference_pressure() const noexcept {
  return first_harmonic(lift_off_force_);
}

double JointContact::closed_pressure(double theta,
                                     double normal_force) const noexcept {
  return interference_pressure() +
         first_harmonic(normal_force) * std::cos(theta);
}

double JointContact::unloaded_moment(double speed) const noexcept {
  if (!has_interference()) return 0;
  return geometry_.radius() *
         friction_at(std::numbers::pi, SlipAxis{0, 1}, {0, speed}).sliding;
}

ContactState JointContact::state(double normal_force) const noexcept {
  if (unit_force_ > 0) return ContactState::clearance;
  if (unit_force_ == 0) return ContactState::zero;
  return normal_force <= lift_off_force_ ? ContactState::closed
                                         : ContactState::lifted;
}

double JointContact::sum_of_pressures(double normal_force,
                                      double half_angle) const noexcept {
  if (is_closed(half_angle)) {
    return sum_factor(geometry_.kind()) * lift_off_force_;
  }
  return pressure_law_->force_ratio(half_angle) * normal_force;
}

double JointContact::shift(double normal_force,
                           double half_angle) const noexcept {
  const double eps = geometry_.radial_clearance();
  if (eps > 0) return eps + approach(half_angle).approach;
  // K_1 = (4 rho/E) p_1
  return half_angle_law_->shift(half_angle).approach * 4 * geometry_.radius() /
         pair_.effective_modulus() * first_harmonic(normal_force);
}

// A pressure p_0 + p_1 cos(theta) all round.
FrictionIntegrals JointContact::closed_integrals(
    SlipAxis axis, double normal_force) const noexcept {
  using detail::pi;
  const double ratio = lift_off_force_ / normal_force;  // p_0/p_1
  FrictionIntegrals i{};
  if (geometry_.kind() == JointKind::pin) {
    i.coefficient = {1, 2 * ratio, 0};
    i.area = {0, 2 * pi * geometry_.length() / geometry_.radius(), 0};
    i.normal = 1;
    i.pressure = i.coefficient;
    return i;
  }
  const std::array harmonics = {ratio, 1.0};
  i = is_viscous() ? viscous_friction_integrals(pi, axis)
                   : friction_integrals(pi, axis);
  // Forces of opposite sides balance to the last digit.
  i.area.force = 0;
  i.coefficient = is_viscous()
                      ? detail::viscous_by_harmonics(harmonics, axis)
                      : detail::coefficients_by_harmonics(harmonics, axis);
  i.normal = 4 * pi / 3 / (1 + ratio);
  const FrictionTriple& c = i.coefficient;
  i.pressure = {i.normal * c.force, i.normal * c.sliding,
                i.normal * c.spinning};
  return i;
}

FrictionTriple JointContact::stress_forces(double half_angle, SlipAxis axis,
                                           const Load& load) const noexcept {
  const bool is_ball = geometry_.kind() == JointKind::ball;
  const double rho = geometry_.radius();
  const StressedContact contact = {
      half_angle, pressure_unit(load.normal_force), rho * load.speed,
      uniform_pressure(load.normal_force, half_angle)};
  const FrictionTriple sum =
      is_ball
          ? contact::stress_integrals(*pressure_law_, contact, axis, *stress())
          : pin_stress_integrals(*pressure_law_, contact, *stress());
  const double area = rho * (is_ball ? rho : geometry_.length());
  return {area * sum.force, area * sum.sliding, area * sum.spinning};
}

FrictionIntegrals JointContact::stress_integrals(
    double half_angle, SlipAxis axis, const Load& load) const noexcept {
  const FrictionTriple sum = stress_forces(half_angle, axis, load);
  const double scale = 1 / load.normal_force;
  FrictionIntegrals i{};
  i.coefficient = {scale * sum.force, scale * sum.sliding,
                   scale * sum.spinning};
  i.normal = 1;
  i.pressure = i.coefficient;
  return i;
}

// Sliding and spinning depend on the mean pressure alone: cos(theta) of the
// load is odd where the slip is even.
FrictionTriple JointContact::closed_friction(SlipAxis axis,
                                             const Load& load) const noexcept {
  using detail::pi;
  const auto [pressure_part, area_part] = strength(load.speed);
  const double sum = sum_factor(geometry_.kind()) * lift_off_force_;
  if (geometry_.kind() == JointKind::pin) {
    const double area = 2 * pi * geometry_.length() / geometry_.radius();
    return {pressure_part * load.normal_force,
            pressure_part * sum + area_part * area, 0};
  }
  // |r x w| over the sphere on average: pi/4, its square 2/3.
  const double share = is_viscous() ? 2.0 / 3 : pi / 4;
  const double moment = share * (pressure_part * sum + area_part * 4 * pi);
  // Forces of opposite sides balance except for the load's.
  const double chi = is_viscous() ? 1 : 3 * pi / 8;
  return {pressure_part * chi * axis.cos * load.normal_force, moment * axis.cos,
          moment * axis.sin};
}

FrictionTriple JointContact::friction_at(double half_angle, SlipAxis axis,
                                         const Load& load) const noexcept {
  if (stress()) return stress_forces(half_angle, axis, load);
  if (is_closed(half_angle)) return closed_friction(axis, load);
  const FrictionIntegrals i = integrals(half_angle, axis, load);
  const auto [pressure_part, area_part] = strength(load.speed);
  const double scale = pressure_part * load.normal_force;
  return {scale * i.coefficient.force + area_part * i.area.force,
          scale * i.coefficient.sliding + area_part * i.area.sliding,
          scale * i.coefficient.spinning + area_part * i.area.spinning};
}

FrictionIntegrals JointContact::integrals(double half_angle, SlipAxis axis,
                                          const Load& load) const noexcept {
  if (stress()) return stress_integrals(half_angle, axis, load);
  if (is_closed(half_angle)) return closed_integrals(axis, load.normal_force);
  if (geometry_.kind() == JointKind::ball) {
    return is_viscous()
               ? viscous_friction_integrals(*pressure_law_, half_angle, axis)
               : friction_integrals(*pressure_law_, half_angle, axis);
  }
  const double span = 2 * geometry_.length() / geometry_.radius();
  FrictionIntegrals pin;
  pin.coefficient = {1, pressure_law_->force_ratio(half_angle), 0};
  pin.area = {span * std::sin(half_angle), span * half_angle, 0};
  // A pin's integrals are normalised to carry the force.
  pin.normal = 1;
  pin.pressure = pin.coefficient;
  return pin;
}

JointContact::Strength JointContact::strength(double speed) const noexcept {
  const double rho = geometry_.radius();
  if (const auto* dry = std::get_if<FrictionLaw>(&friction_)) {
    return {dry->coefficient(), dry->adhesion() * rho * rho};
  }
  if (stress()) return {1, 0};
  const auto& viscous = std::get<ViscousLaw>(friction_);
  const double scale = rho * speed;
  return {viscous.pressure_slope() * scale,
          viscous.constant() * rho * rho * scale};
}

double JointContact::area(double half_angle) const noexcept {
  const double rho = geometry_.radius();
  if (geometry_.kind() == JointKind::pin) {
    return 2 * rho * geometry_.length() * half_angle;
  }
  const double h = rho * std::sin(half_angle / 2);
  return 4 * std::numbers::pi * h * h;
}

}  // namespace contact
