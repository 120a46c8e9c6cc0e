#pragma once

#include <memory>
#include <string>
#include <vector>

#include "libcontact/half_angle/law.hpp"
#include "libcontact/pair/joint_geometry.hpp"

namespace contact {

/// A seat or hole that wear has widened: any law with theta0 from
///
///     g(theta0) = g(theta0 of the law) + v,
///     g = (1 - cos)^2/cos (ball), tan theta - theta (pin).
///
/// g is the volume by which the two undeformed shapes overlap, over pi rho^2
/// eps or 2 rho eps l; v, the wear number, is the wear volume in the same unit.
/// The elastic part hardly changes: against joints that wear step by step,
/// half-angles 20 to 70 deg, theta0 is within 1.1 deg, on thin layers 0.4 deg
/// (duty/wear_in_test.cpp). Below 90 deg.
class WornHalfAngle final : public HalfAngleLaw {
 public:
  /// @param law          of the joint before wear
  /// @param wear_number  v, [0, infinity)
  /// @throws Error if v is out of range.
  WornHalfAngle(std::shared_ptr<const HalfAngleLaw> law, double wear_number);

  /// g; inverse to 1e-14 (half_angle/worn_test.cpp).
  /// @param half_angle  rad, [0, pi/2)
  static double overlap(JointKind kind, double half_angle);
  static double half_angle_of_overlap(JointKind kind, double overlap);

  /// The volume of wear number 1, m^3: pi rho^2 eps or 2 rho eps l.
  static double unit_volume(const JointGeometry& geometry);

  const HalfAngleLaw& law() const { return *law_; }
  double wear_number() const { return wear_number_; }

  std::string name() const override { return law_->name() + "_worn"; }
  HalfAngleResult half_angle(double load_parameter) const noexcept override;
  LoadParameterResult load_parameter(double half_angle) const noexcept override;
  double load_factor(double relative_clearance) const noexcept override {
    return law_->load_factor(relative_clearance);
  }
  double limit_half_angle() const noexcept override;
  std::vector<std::string> validity_notes(
      const ElasticPair& pair) const override;

 private:
  std::shared_ptr<const HalfAngleLaw> law_;
  double wear_number_;
};

}  // namespace contact
