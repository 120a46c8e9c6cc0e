// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/half_angle/law.hpp"
#include "libcontact/pair/contact_conditions.hpp"

/// Half-angle laws by their names.
namespace contact {

/// How make_half_angle_law() finds theta0* of the laws that need one.
struct HalfAngleOptions {
  /// theta0*, rad, instead of a formula.
  std::optional<double> limit_half_angle = {};
  /// LimitHalfAngle::linear_formula() instead of arctan_formula().
  bool linear_limit = false;
  /// dtheta0/dx at x = 0 of arctan, tanh and blend; 57.3 * degree for the
  /// paper's own digits.
  double initial_slope = 1;

  friend bool operator==(const HalfAngleOptions&,
                         const HalfAngleOptions&) = default;
};

/// The law of joints and programs that name none.
inline constexpr std::string_view default_half_angle_law = "fitted";

/// Names that make_half_angle_law() knows, in the order of the sources:
/// hertz, arctan, tanh, blend, paper, fitted, exact.
const std::vector<std::string>& half_angle_law_names();

/// Whether the law of this name uses HalfAngleOptions: the laws of the paper
/// except hertz.
bool takes_half_angle_options(std::string_view name);

/// Whether the law of this name holds under these conditions: loaded through
/// the back and with finite walls `exact` alone, all others are of a force at
/// the centre and an infinite outer body.
bool half_angle_law_allows(std::string_view name,
                           const ContactConditions& conditions);

/// A law by its name.
///
/// @param name  "hertz", "arctan", "tanh", "blend" (the paper's k for the
///              kind of joint), "blend:K" with K in [0, 1], or "paper" (what
///              the paper recommends: blend:0.5 for a pin, tanh for a ball),
///              "fitted" (FittedLaw), "exact" (ExactLaw); these two take none
///              of the options
/// @param pair  the materials at the surfaces; ignored with walls
/// @throws Error if the name is not known, an option is out of range or the
///         law is not for these conditions.
std::unique_ptr<HalfAngleLaw> make_half_angle_law(
    std::string_view name, JointKind kind, const ElasticPair& pair,
    const HalfAngleOptions& options = {},
    const ContactConditions& conditions = {});

}  // namespace contact
