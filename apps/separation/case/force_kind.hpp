#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case_names.hpp"
#include "separation/case/force_law.hpp"
#include "separation/case/reading.hpp"

namespace separation {

/// A [[force]] being read for one of its bodies.
struct ForceTable {
  const TomlTable& table;
  const CaseNames& names;
  int body;    ///< rigid body
  int copy;    ///< its number among the named bodies
  int copies;  ///< number of the named bodies
  /// Points and directions as written to those of its place in a pattern.
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();

  const RigidBody& rigid_body() const { return names.of.rigid_body(body); }
  /// none for the carrier.
  multibody::HingeKind hinge() const;
  /// Throws unless it acts on a body.
  void refuse_carrier() const;
  /// Throws unless it acts on a body on an axis.
  void refuse_without_axis() const;

  /// A point of the body, from its centre of mass, body axes.
  Eigen::Vector3d point() const;
  Eigen::Vector3d point_or_com() const;
  /// A point of the carrier, from its centre of mass; the copy's.
  Eigen::Vector3d carrier_point() const;
  /// A direction of the body, in its axes, or of the carrier; the copy's.
  Eigen::Vector3d body_direction() const;
  Eigen::Vector3d carrier_direction() const;
  /// KEY_at (a time), or KEY_at_event with KEY_delay.
  Clock clock(const std::string& key, const Clock& otherwise) const;
};

/// A kind of force: its keys in files. A file in separation/forces defines its
/// action.
struct ForceKind {
  std::string_view name;
  /// Keys in addition to the keys of all forces.
  contact::KnownKeys keys;
  std::shared_ptr<const ForceLaw> (*read)(const ForceTable& from);
  bool has_pattern = false;  ///< it may have copies: [force.pattern]
};

/// All kinds; separation/forces/list.cpp contains the list.
const std::vector<ForceKind>& force_kinds();

}  // namespace separation
