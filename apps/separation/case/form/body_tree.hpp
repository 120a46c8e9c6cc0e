#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// All [[body]] of a file with their copies, in the order of the file.
struct BodyTree {
  std::vector<Body> bodies;
  std::vector<int> counts;  ///< copies of each [[body]], 1 for none
  /// Turn of each body's copy: CaseNames::turns.
  std::vector<Eigen::Matrix3d> turns;
};

/// Reads the bodies, each after its parent: on = "NAME" of its hinge names a
/// body or one of its copies. Bodies that hang on a body with copies are copied
/// with it.
/// @throws contact::Error at the key, for unknown names, for bodies that hang
///   on themselves, directly or through others, and as read_body()
BodyTree read_bodies(const contact::TomlTable& file, const RigidBody& carrier,
                     const JointLaws& laws, contact::SharedLaws& made);

}  // namespace separation
