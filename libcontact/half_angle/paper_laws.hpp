#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libcontact/half_angle/law.hpp"

/// The half-angle laws of Hertz and of the paper.
namespace contact {

/// theta0*, to which theta0 tends as the load grows, of a pin in a hole.
class LimitHalfAngle {
 public:
  /// Any value, (0, pi) rad.
  /// @throws Error if out of range.
  static LimitHalfAngle given(double half_angle);

  /// The paper's formula for nu1 = nu2 = 0.3, in degrees
  ///
  ///     84.85 + 4.89 atan(0.436 (1/Ebar - 1))    Ebar <= 1
  ///     84.85 - 2.88 atan(0.711 (Ebar - 1))      Ebar >= 1
  ///
  /// from 92.53 (Ebar = 0) to 80.33 (infinity). Against exact solutions it is
  /// within 0.7 % (docs/explanation/half_angle.md); computed to 4e-16 relative
  /// (half_angle/paper_laws_test.cpp).
  /// @param modulus_ratio  Ebar, [0, infinity]
  /// @throws Error if out of range.
  static LimitHalfAngle arctan_formula(double modulus_ratio);

  /// The paper's short form for nu1 = nu2 = 0.3 and 0.5 <= Ebar <= 2:
  /// 84.85 + 2 (1/Ebar - 1) or 84.85 - 2 (Ebar - 1) degrees; within 0.3 % of
  /// arctan_formula().
  /// @throws Error if Ebar is out of that range.
  static LimitHalfAngle linear_formula(double modulus_ratio);

  /// theta0*, rad.
  double value() const { return value_; }
  /// The ratio of the moduli that a formula was given.
  const std::optional<MadeFor>& made_for() const { return made_for_; }

  /// Sentences on the use of a formula outside its range: another Poisson's
  /// ratio than 0.3 in a body that deforms, or a ball. Empty for given().
  std::vector<std::string> validity_notes(JointKind kind,
                                          const ElasticPair& pair) const;

 private:
  LimitHalfAngle(double value, std::optional<MadeFor> made_for)
      : value_(value), made_for_(std::move(made_for)) {}

  double value_;
  std::optional<MadeFor> made_for_;  // pair of a formula
};

/// Hertz: theta0 = arcsin x (2.1), for x <= 1; beyond it NaN, out_of_range.
///
/// Exact as the load tends to 0, at any clearance if x takes both radii
/// (load_factor()), which the paper leaves out; already 5 % too large at lambda
/// = 0.03. Accuracy: relative error at most 1e-15 both ways, x -> 1 included
/// (half_angle/paper_laws_test.cpp, against 50-digit arithmetic).
class HertzLaw : public HalfAngleLaw {
 public:
  explicit HertzLaw(JointKind kind) : HalfAngleLaw(kind) {}

  std::string name() const override { return "hertz"; }
  HalfAngleResult half_angle(double load_parameter) const noexcept override;
  LoadParameterResult load_parameter(double half_angle) const noexcept override;
  double load_factor(double relative_clearance) const noexcept override {
    return 1 + relative_clearance;
  }
  double limit_half_angle() const noexcept override;
  std::vector<std::string> validity_notes(
      const ElasticPair& pair) const override;
};

/// The laws that depend on x/theta0* alone: theta0 = theta0* g(m x/theta0*),
/// g(xi) = xi + O(xi^3), g -> 1.
///
/// The initial slope m = dtheta0/dx is 1 (Hertz). The paper prints its laws in
/// degrees with 57.3 for 180/pi and computed its examples so: m = 57.3 deg =
/// 1.00007 rad repeats its numbers to their last digits.
///
/// At infinite load theta0 is theta0*, whose inverse is infinity. Close to
/// theta0* a rounding of theta0 changes the load much; the inverse is
/// accurate for the theta0 that it is given.
class SaturatingLaw : public HalfAngleLaw {
 public:
  HalfAngleResult half_angle(double load_parameter) const noexcept final;
  LoadParameterResult load_parameter(double half_angle) const noexcept final;
  double limit_half_angle() const noexcept final { return limit_.value(); }
  std::vector<std::string> validity_notes(
      const ElasticPair& pair) const override;

 protected:
  struct Shape {
    double value;  // g
    double slope;  // dg/dxi
  };
  struct InverseResult {
    double xi;
    Status status;
  };

  SaturatingLaw(JointKind kind, LimitHalfAngle limit, double initial_slope);

 private:
  // g(xi), 0 <= xi <= infinity.
  virtual Shape shape(double xi) const noexcept = 0;
  // xi for a ratio r = theta0/theta0* in (0, 1), given with 1 - r.
  virtual InverseResult inverse_shape(double ratio,
                                      double complement) const noexcept = 0;

  LimitHalfAngle limit_;
  double initial_slope_;
};

/// theta0 = C atan(x/C), C = 2 theta0*/pi (2.3).
///
/// Accuracy: relative error at most 1e-15 forward, 2e-15 inverse
/// (half_angle/paper_laws_test.cpp, against 50-digit arithmetic).
class ArctanLaw final : public SaturatingLaw {
 public:
  /// @throws Error if initial_slope is not positive and finite.
  ArctanLaw(JointKind kind, LimitHalfAngle limit, double initial_slope = 1)
      : SaturatingLaw(kind, std::move(limit), initial_slope) {}
  std::string name() const override { return "arctan"; }

 private:
  Shape shape(double xi) const noexcept override;
  InverseResult inverse_shape(double ratio,
                              double complement) const noexcept override;
};

/// theta0 = theta0* tanh(x/theta0*) (2.4); the paper's choice for balls.
///
/// Accuracy: relative error at most 1e-15 forward, 2e-15 inverse
/// (half_angle/paper_laws_test.cpp, against 50-digit arithmetic). In double
/// precision theta0 reaches theta0* near x = 19 theta0*.
class TanhLaw final : public SaturatingLaw {
 public:
  /// @throws Error if initial_slope is not positive and finite.
  TanhLaw(JointKind kind, LimitHalfAngle limit, double initial_slope = 1)
      : SaturatingLaw(kind, std::move(limit), initial_slope) {}
  std::string name() const override { return "tanh"; }

 private:
  Shape shape(double xi) const noexcept override;
  InverseResult inverse_shape(double ratio,
                              double complement) const noexcept override;
};

/// theta0 = k arctan law + (1 - k) tanh law. The paper recommends k = 1/2 for
/// pins with 0.5 < Ebar < 2 (within 3 %) and k = 0 for balls.
///
/// The inverse is a bracketed root between the inverses of the two laws.
/// Accuracy: relative error at most 1e-15 forward, 3e-15 inverse
/// (half_angle/paper_laws_test.cpp, against 50-digit arithmetic).
class BlendLaw final : public SaturatingLaw {
 public:
  /// @param arctan_share  k, [0, 1]
  /// @throws Error if k is out of range or initial_slope is not positive and
  ///         finite.
  BlendLaw(JointKind kind, LimitHalfAngle limit, double arctan_share,
           double initial_slope = 1);

  /// The paper's k: 1/2 for a pin, 0 for a ball.
  static double recommended_arctan_share(JointKind kind) {
    return kind == JointKind::pin ? 0.5 : 0.0;
  }

  /// "blend:K".
  std::string name() const override;
  double arctan_share() const { return arctan_share_; }
  std::vector<std::string> validity_notes(
      const ElasticPair& pair) const override;

 private:
  Shape shape(double xi) const noexcept override;
  InverseResult inverse_shape(double ratio,
                              double complement) const noexcept override;

  double arctan_share_;
};

}  // namespace contact
