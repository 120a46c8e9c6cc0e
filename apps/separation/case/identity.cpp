#include "separation/case/identity.hpp"

#include <fmt/format.h>

#include <variant>

namespace separation {
namespace {

std::string text_of(const contact::Material& material) {
  return fmt::format("{} {} ", material.youngs_modulus,
                     material.poissons_ratio);
}

std::string text_of(const contact::LayeredBody& body) {
  std::string text;
  for (const contact::Layer& layer : body.layers) {
    text += fmt::format("{} ", layer.thickness) + text_of(layer.material);
  }
  return text + fmt::format("{} ", static_cast<int>(body.backing.kind())) +
         text_of(body.backing.material());
}

}  // namespace

std::string identity(const contact::JointSpec& joint) {
  const contact::JointGeometry& g = joint.geometry;
  const contact::ElasticPair& pair = joint.pair;
  std::string text = fmt::format(
      "{} {} {} {} {} {} {} {} {} {}", static_cast<int>(g.inner_body()),
      g.radius(), g.radial_clearance(), g.length(), pair.modulus_ratio(),
      pair.contact_modulus(), pair.inner_compliance_share(),
      pair.dundurs_beta(), joint.half_angle_law, joint.pressure_law);
  const auto& limit = joint.half_angle_options;
  const auto& [loading, walls] = joint.conditions;
  text += fmt::format(" {} {} {} {} {}", limit.limit_half_angle.value_or(0),
                      limit.linear_limit, limit.initial_slope,
                      loading.is_back(), loading.patch_half_angle());
  if (walls) {
    text += " walls " + text_of(walls->inner()) + text_of(walls->outer());
  }
  if (const auto* dry = std::get_if<contact::FrictionLaw>(&*joint.friction)) {
    return text +
           fmt::format(" dry {} {}\n", dry->coefficient(), dry->adhesion());
  }
  const auto& viscous = std::get<contact::ViscousLaw>(*joint.friction);
  return text + fmt::format(" viscous {} {}\n", viscous.constant(),
                            viscous.pressure_slope());
}

std::string identity(const Case& c) {
  std::string text;
  for (const Body& body : c.bodies) {
    for (const HingeJoint& joint : body.hinge.joints) {
      text += identity(joint.joint);
    }
  }
  return text + c.content;
}

}  // namespace separation
