#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/duty/wear_map.hpp"

namespace hinge_duty {

/// Wear of one body over one period.
struct BodyWear {
  std::string body;         ///< "carrier" or "body"
  std::string surface;      ///< "seat" or "inner"
  std::optional<double> k;  ///< mm^3/(N m), if given
  contact::WearMap map;
  std::vector<Eigen::Vector3d> points;
  std::vector<contact::WearMap::Wear> wear;
  contact::WearMap::Deepest deepest;
  double volume_defect;

  /// Wear depth of one cycle at a point, mm; NaN without k.
  double depth(const contact::WearMap::Wear& at) const {
    return k.value_or(std::numeric_limits<double>::quiet_NaN()) * 1e-6 * at.pv;
  }
};

}  // namespace hinge_duty
