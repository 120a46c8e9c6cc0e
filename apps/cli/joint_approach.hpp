#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/half_angle/law.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"

namespace cli {

/// How far a load presses a ball or pin into the outer body, in SI units, as
/// columns of tables.
class JointApproach {
 public:
  /// Whether a law has it: exact.
  static bool of(const contact::HalfAngleLaw& law) {
    return law.name() == "exact";
  }

  /// @param length  of the pin that the stiffness is for: its own, or 1 m where
  ///                loads are per length
  JointApproach(std::shared_ptr<const contact::HalfAngleLaw> law,
                const contact::JointGeometry& geometry,
                const contact::ElasticPair& pair, double length)
      : law_(std::move(law)),
        clearance_(geometry.radial_clearance()),
        stiffness_(pair.effective_modulus() *
                   (geometry.kind() == contact::JointKind::ball
                        ? geometry.radius()
                        : length)) {}

  /// approach, m, from first touch of the unloaded bodies; stiffness,
  /// d load/d approach. NaN where there is none: without load, loaded through
  /// the back, and for a pin in an infinite hole.
  contact::ContactApproach operator()(double half_angle) const {
    const contact::ContactApproach value = law_->approach(half_angle);
    return {value.approach * clearance_, value.stiffness * stiffness_};
  }

  /// Names of both columns.
  /// @param kind  of a joint whose loads are per length if it is a pin
  static std::vector<std::string> columns(contact::JointKind kind) {
    return {"approach_m", kind == contact::JointKind::ball
                              ? "stiffness_N_per_m"
                              : "stiffness_N_per_m2"};
  }

 private:
  std::shared_ptr<const contact::HalfAngleLaw> law_;
  double clearance_;
  double stiffness_;
};

}  // namespace cli
