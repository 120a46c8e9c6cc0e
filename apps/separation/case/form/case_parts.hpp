#pragma once

#include <Eigen/Core>

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case.hpp"

/// Parts of a case in case files. A part depends on its own tables and the
/// carrier; bodies also on their parents, forces also on bodies.
namespace separation {

/// Gravity and [run].
void read_run_of(const contact::TomlTable& file, Case& c);
/// [carrier] with its start and its drive.
void read_carrier_of(const contact::TomlTable& file, Case& c);

/// A [[body]]; its copies are rotated copies of it.
/// @param made  laws of the case's joints
/// @param parent  the carrier or the parent body; the caller, which knows its
///   index, sets Hinge::on
Body read_body(const contact::TomlTable& table, const RigidBody& parent,
               const JointLaws& laws, contact::SharedLaws& made);

/// Throws for a body on a ball joint without inertia about the line from there
/// to its centre of mass, which cannot be where engines burn mass.
void check_beside_flow(const contact::TomlTable& table, const Body& body);

/// Copies of a body around an axis through the origin of its parent, or of the
/// points and directions of a force about one through that of their own body.
struct Pattern {
  int count = 1;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  double first = 0;

  /// Axes of the parent as written to its axes.
  /// @param copy  from 0
  Eigen::Matrix3d turn(int copy) const;
  Body copy_of(Body body, int copy, const Eigen::Vector3d& parent_com) const;
};
/// Calls a copy "NAME 1" for the copy 0.
void name_copy(Body& body, int copy);
/// A single copy without [.pattern].
Pattern read_pattern(const contact::TomlTable& of);

}  // namespace separation
