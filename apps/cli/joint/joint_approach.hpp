#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/quantities/tables.hpp"

namespace cli {

/// Approach of a ball or pin and its seat under load, in SI units, as columns
/// of tables.
class JointApproach {
 public:
  /// True for the exact law, the only one that gives an approach.
  static bool of(const contact::HalfAngleLaw& law) {
    return law.name() == "exact";
  }

  /// @param joint  with a size
  JointApproach(std::shared_ptr<const contact::HalfAngleLaw> law,
                const Joint& joint)
      : law_(std::move(law)),
        per_length_(!joint.has_length),
        geometry_(joint.spec.geometry),
        pair_(joint.pair) {}

  /// approach, m, from first touch of the unloaded bodies; stiffness d load/d
  /// approach. NaN without load, for a load through the back, and for a pin in
  /// an unbounded body.
  contact::ContactApproach operator()(double half_angle) const {
    return contact::JointContact::approach(*law_, geometry_, pair_, half_angle);
  }

  /// Names of both columns.
  std::vector<std::string> columns() const {
    std::vector<std::string> names;
    for (const auto& q : contact::approach_quantities()) {
      names.push_back(columns_of(q)[0].name);
    }
    if (per_length_) names[1] += '2';  // N/m of N/m
    return names;
  }

 private:
  std::shared_ptr<const contact::HalfAngleLaw> law_;
  bool per_length_;
  contact::JointGeometry geometry_;
  contact::ElasticPair pair_;
};

}  // namespace cli
