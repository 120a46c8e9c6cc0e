#pragma once

#include <array>
#include <vector>

#include "libcontact/half_angle/newton.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"

/// The fitted laws' relation between load and half-angle
/// (docs/internals/fitted_laws.md): a closed form, exact for some elastic
/// pairs, and a polynomial in r = sin(theta0/2) whose coefficients are sums
/// over the features of the pair,
///
///     F = closed form + weight(r) sum_k r^k sum_i feature_i C_ik,
///     k = 1 ... fitted_terms,   weight = 1 (pin), cos^4(theta0/2) (ball).
///
/// The fit of C (reference/half_angle_fit.hpp) uses these functions too.
namespace contact::detail {

inline constexpr int fitted_terms = 5;

/// Constant of the closed form: w_2 (pin), d_0 (ball).
double fitted_constant(JointKind kind, const ElasticPair& pair);

/// Pin: beta, w_2 beta. Ball: d_2, d_3, k, c_0 d_2.
std::vector<double> fitted_features(JointKind kind, const ElasticPair& pair);

/// weight(r), given cos(theta0/2).
inline double fitted_weight(JointKind kind, double cosine) {
  const double c = cosine * cosine;
  return kind == JointKind::ball ? c * c : 1;
}

/// F of the closed form at theta0 in (0, pi]. Relative error below 1e-14.
RelationValue fitted_closed_form(JointKind kind, double constant,
                                 double half_angle, double sine, double cosine);

/// The relation of one elastic pair, with the committed coefficients.
class FittedRelation {
 public:
  FittedRelation(JointKind kind, const ElasticPair& pair);
  RelationValue operator()(double half_angle, double sine, double cosine) const;
  /// solve_half_angle() of this relation.
  HalfAngleResult solve(const HalfAngleStart& start, double limit,
                        double load_parameter) const;

 private:
  template <JointKind kind>
  RelationValue at(double half_angle, double sine, double cosine) const;

  JointKind kind_;
  double constant_;
  std::array<double, fitted_terms> coefficients_{};
};

}  // namespace contact::detail
