// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>

/// Elastic constants of the two bodies of a joint. Body 1 is the inner one
/// (ball, pin), body 2 the outer one (seat, hole).
namespace contact {

/// An isotropic, linearly elastic material.
struct Material {
  /// Young's modulus, Pa, (0, infinity]; infinity is a rigid body.
  double youngs_modulus;
  /// Poisson's ratio, [0, 0.5]; without influence for a rigid body.
  double poissons_ratio;
  /// For messages only; may be empty.
  std::string name = {};
  /// Largest contact pressure that it bears, Pa, (0, infinity]: where it
  /// yields or creeps, or what a catalogue allows. For warnings only.
  double limit_pressure = std::numeric_limits<double>::infinity();
  /// Coefficient of linear thermal expansion, 1/K, -1e-3 to 1e-3: required only
  /// by joints at another temperature than their clearance
  /// (pair/temperatures.hpp).
  std::optional<double> thermal_expansion = {};
  /// Whether it comes as a layer of some thickness, as liners and cups do: a
  /// body of it without end is noted (infinite_liner_notes()).
  bool liner = false;

  friend bool operator==(const Material&, const Material&) = default;
};

namespace detail {
/// Throws contact::Error, which names the place, unless the constants are in
/// their intervals.
void check_material(const Material& material, std::string place);
}  // namespace detail

/// The elastic constants on which the contact of two bodies depends.
///
/// With the compliances c_i = (1 - nu_i^2)/E_i (0 for a rigid body):
///
/// | quantity | formula |
/// |---|---|
/// | contact modulus E* | 1/(c_1 + c_2) |
/// | effective modulus E of the paper | 2/(c_1 + c_2) = 2 E* |
/// | modulus ratio Ebar | E_1/E_2 |
/// | compliance shares | w_i = c_i/(c_1 + c_2) |
/// | Dundurs' alpha | w_2 - w_1 |
/// | Dundurs' beta | w_2 b(nu_2) - w_1 b(nu_1), b(v) = (1-2v)/(2(1-v)) |
///
/// Dundurs' parameters hold for plane strain.
///
/// Accuracy: relative error at most 5e-16 for all but alpha and beta, whose
/// absolute error is at most 4e-16 (pair/pair_test.cpp, against 50-digit
/// arithmetic).
/// Sources: the paper, section 2 (E, Ebar);
/// `docs/reference/references.md#dundurs-1969`, on edge-bonded wedges (alpha,
/// beta, where the sign is here the one that makes alpha = -1 a rigid outer
/// body).
class ElasticPair {
 public:
  /// @param inner  body 1: ball or pin
  /// @param outer  body 2: seat or hole
  /// @throws Error if a constant is out of range or both bodies are rigid.
  ElasticPair(const Material& inner, const Material& outer);

  /// A pair known by its dimensionless constants only. The moduli are scaled
  /// so that effective_modulus() is 1: forces are then in units of E rho1^2.
  ///
  /// @param modulus_ratio  Ebar = E_1/E_2, [0, infinity]; 0 is a rigid seat,
  ///                       infinity a rigid ball
  /// @param inner_poissons_ratio  nu_1, [0, 0.5]
  /// @param outer_poissons_ratio  nu_2, [0, 0.5]
  /// @throws Error if an argument is out of range.
  static ElasticPair from_modulus_ratio(double modulus_ratio,
                                        double inner_poissons_ratio,
                                        double outer_poissons_ratio);

  const Material& inner() const { return inner_; }
  const Material& outer() const { return outer_; }

  /// Ebar = E_1/E_2, [0, infinity]: 0 for a rigid outer body, infinity for a
  /// rigid inner one.
  double modulus_ratio() const { return modulus_ratio_; }
  /// E* = 1/(c_1 + c_2), Pa: the modulus of most contact codes.
  double contact_modulus() const { return contact_modulus_; }
  /// E = 2/(c_1 + c_2), Pa: the modulus of the paper, twice E*.
  double effective_modulus() const { return 2 * contact_modulus_; }

  /// w_1, [0, 1]: 0 for a rigid inner body.
  double inner_compliance_share() const { return inner_share_; }
  /// w_2 = 1 - w_1, [0, 1]: 0 for a rigid outer body.
  double outer_compliance_share() const { return outer_share_; }
  /// alpha = w_2 - w_1, [-1, 1]: -1 for a rigid outer body, 0 for equal
  /// compliances. 1 + alpha and 1 - alpha are 2 w_2 and 2 w_1: take the
  /// shares where alpha is near -1 or 1.
  double dundurs_alpha() const { return dundurs_alpha_; }
  /// beta, [-0.5, 0.5]: 0 for identical materials and if both bodies that
  /// deform are incompressible.
  double dundurs_beta() const { return dundurs_beta_; }

  friend bool operator==(const ElasticPair&, const ElasticPair&) = default;
  /// True if inner and outer body have the same elastic constants.
  bool identical() const;

 private:
  ElasticPair(Material inner, Material outer, double modulus_ratio);

  Material inner_;
  Material outer_;
  double modulus_ratio_;
  double contact_modulus_;
  double inner_share_;
  double outer_share_;
  double dundurs_alpha_;
  double dundurs_beta_;
};

}  // namespace contact
