#include "libcontact/joint/contact.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/instruction_set.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/models.hpp"
#include "libcontact/friction/stress_rule.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/half_angle/worn.hpp"
#include "libcontact/pressure/factory.hpp"
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
  const ContactApproach unit = law.approach(half_angle);
  const double length = geometry.kind() == JointKind::ball ? geometry.radius()
                                                           : geometry.length();
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
  unit_force_ = force_at_load_parameter_one(geometry_, pair_);
  unit_pressure_area_ =
      geometry_.force_from_load(1) / geometry_.pressure_unit(1);
  // Some make a rule on first use: here, so that no solution has to allocate.
  integrals(0.5, SlipAxis{0, 1}, {1, 1});
}

JointContact JointContact::with_clearance(double radial_clearance) const {
  JointContact other = *this;
  other.geometry_ =
      geometry_.kind() == JointKind::ball
          ? JointGeometry::ball(geometry_.radius(), radial_clearance,
                                geometry_.inner_body())
          : JointGeometry::pin(geometry_.radius(), radial_clearance,
                               geometry_.length(), geometry_.inner_body());
  other.unit_force_ = force_at_load_parameter_one(other.geometry_, pair_);
  return other;
}

JointContact JointContact::worn(double wear_number) const {
  JointContact other = *this;
  other.half_angle_law_ =
      std::make_shared<WornHalfAngle>(half_angle_law_, wear_number);
  other.pressure_law_ =
      std::make_shared<RunningInPressure>(pressure_law_, wear_number);
  return other;
}

std::vector<std::string> JointContact::validity_notes() const {
  std::vector<std::string> notes = geometry_.validity_notes();
  for (std::string& note : half_angle_law_->validity_notes(pair_)) {
    notes.push_back(std::move(note));
  }
  // The two ends of the same solution differ by rounding.
  constexpr double rounding = 1e-9;
  const double largest = pressure_law_->largest_half_angle();
  if (half_angle_law_->limit_half_angle() > largest * (1 + rounding)) {
    notes.push_back(detail::message(
        "pressure law {} ends at {:.4g} deg, before the limit "
        "half-angle of law {}",
        pressure_law_->name(), largest / degree, half_angle_law_->name()));
  }
  if (stress() && !stress()->note().empty()) notes.push_back(stress()->note());
  return notes;
}

std::string JointContact::rest_refusal() const {
  if (!stress() || stress()->over_speed() != FrictionStress::OverSpeed::falls)
    return {};
  return "friction that does not fall with the speed: else a joint sticks and "
         "slips, and the moments that it holds are no convex set";
}

FrictionIntegrals JointContact::stress_integrals(
    double half_angle, SlipAxis axis, const Load& load) const noexcept {
  const bool is_ball = geometry_.kind() == JointKind::ball;
  const double rho = geometry_.radius();
  const StressedContact contact = {half_angle, pressure_unit(load.normal_force),
                                   rho * load.speed};
  const FrictionTriple sum =
      is_ball
          ? contact::stress_integrals(*pressure_law_, contact, axis, *stress())
          : pin_stress_integrals(*pressure_law_, contact, *stress());
  const double area = rho * (is_ball ? rho : geometry_.length());
  const double scale = area / load.normal_force;
  FrictionIntegrals i{};
  i.coefficient = {scale * sum.force, scale * sum.sliding,
                   scale * sum.spinning};
  i.normal = 1;
  i.pressure = i.coefficient;
  return i;
}

FrictionIntegrals JointContact::integrals(double half_angle, SlipAxis axis,
                                          const Load& load) const noexcept {
  if (stress()) return stress_integrals(half_angle, axis, load);
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
