#include "libcontact/joint/presliding/stuck_joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/conforming/stuck/stuck.hpp"

namespace contact {

double StuckJoint::lugre_stiffness() const {
  // 1 - exp(-x) against 1 - (1 - x/b)^b, both 1/2.
  return load_stiffness * std::numbers::ln2 /
         (shape * (1 - std::exp2(-1 / shape)));
}

StuckJoint stuck_joint(const JointSpec& joint, const JointContact& contact,
                       double normal_force, double half_angle) {
  using detail::nan;
  StuckJoint result{nan, nan, nan, nan, nan};
  if (contact.has_interference() || !(normal_force > 0)) return result;
  const JointGeometry& geometry = joint.geometry;
  const LayeredPair pair(geometry.radius(), joint.inner, joint.outer);
  const bool pin = geometry.kind() == JointKind::pin;
  const double rho = geometry.radius();
  const double unit = pair.surfaces().effective_modulus() * rho * rho *
                      (pin ? geometry.length() : rho);
  const detail::StuckStiffness k =
      detail::stuck_stiffness(geometry.kind(), pair, half_angle);
  const bool is_endless =
      pin && joint.outer.backing.kind() == Backing::Kind::medium;
  result.load_stiffness = unit * k.load();
  result.held_stiffness = is_endless ? nan : unit * k.turn;
  result.spin_stiffness = unit * k.spin;
  if (std::holds_alternative<FrictionLaw>(contact.friction())) {
    result.friction_moment =
        rho *
        contact.friction_at(half_angle, {0, 1}, {normal_force, 0}).sliding;
  }
  // The elastic part of the turn slips as a held contact would, b = 1.5 of
  // Cattaneo; liners slip before they roll.
  result.shape = 1 + 0.5 * k.load() / k.turn +
                 0.8 * std::max(0.0, 1 - k.load() / k.frictionless);
  return result;
}

namespace {

// Why there is no stiffness; "" if there is one.
std::string why_none(const JointSpec& joint, double half_angle) {
  if (joint.geometry.radial_clearance() < 0) {
    return "the joint has interference";
  }
  const double thickness =
      LayeredPair(joint.geometry.radius(), joint.inner, joint.outer)
          .relative_thickness();
  if (thickness < detail::thinnest_stuck) {
    return detail::message(
        "a layer is {:.3g} radii thick: layers below {} cannot be computed",
        thickness, detail::thinnest_stuck);
  }
  const bool is_outside =
      half_angle < detail::narrowest_stuck || half_angle > detail::widest_stuck;
  if (!is_outside) return {};
  return detail::message(
      "the half-angle is {:.3g} deg: only {:.2g} to {:.4g} deg are computed",
      half_angle / degree, detail::narrowest_stuck / degree,
      detail::widest_stuck / degree);
}

}  // namespace

std::string stuck_refusal(const JointSpec& joint, double half_angle) {
  const std::string why = why_none(joint, half_angle);
  if (why.empty()) return {};
  return "the stuck contact has no stiffness here, because " + why;
}

std::vector<std::string> stuck_notes(const JointSpec& joint,
                                     double half_angle) {
  std::string refusal = stuck_refusal(joint, half_angle);
  if (!refusal.empty()) return {std::move(refusal)};
  // Measured with the inner body held by a rigid core of half its radius: 0.92
  // of K_load at 43 deg, 0.69 at 65 deg; below 20 deg 1.01.
  constexpr double widest = 43 * degree;
  const bool is_homogeneous = joint.inner.layers.empty() &&
                              joint.outer.layers.empty() &&
                              joint.inner.surface().youngs_modulus <
                                  std::numeric_limits<double>::infinity();
  std::vector<std::string> notes;
  if (is_homogeneous && half_angle > widest) {
    notes.push_back(detail::message(
        "half-angle {:.3g} deg: above 43 deg the stiffness of a stuck contact "
        "of homogeneous bodies is that of the shaft's attachment as much as of "
        "the contact; it is counted against the mean rotation of ball or pin",
        half_angle / degree));
  }
  const auto& zone = joint.geometry.drawn_seat();
  const auto leave_out = [&](const char* what) {
    notes.push_back(
        detail::message("the stiffness of the stuck contact ignores {}", what));
  };
  if (zone && half_angle > zone->reach()) {
    leave_out("the rims, which it reaches");
  }
  if (joint.loading.is_back()) leave_out("that the load presses on the back");
  return notes;
}

}  // namespace contact
