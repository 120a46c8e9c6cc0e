#pragma once

#include <optional>

#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"

namespace hinge_angle {

/// In what a load is given.
enum class LoadVariable { load, load_parameter, x };

/// The loads of one joint in terms of each variable.
class Loads {
 public:
  /// @param geometry  without it there are load_parameter and x alone
  Loads(contact::JointKind kind,
        const std::optional<contact::JointGeometry>& geometry,
        const contact::ElasticPair& pair)
      : kind_(kind) {
    if (geometry) scale_.emplace(*geometry, pair);
  }

  /// Whether `load` is one of them.
  bool have_load() const { return scale_.has_value(); }
  /// A load in terms of another variable.
  double convert(LoadVariable from, double load, LoadVariable to) const;

 private:
  contact::JointKind kind_;
  std::optional<contact::LoadScale> scale_;
};

}  // namespace hinge_angle
