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

/// Reads the bodies, each after the one that it hangs on: on = "NAME" of its
/// hinge, of a body or of one of its copies. What hangs on a body with copies
/// is copied with it.
/// @throws contact::Error at the key, of names that there are not, bodies that
///   hang on themselves, by way of others too, and as read_body()
BodyTree read_bodies(const contact::TomlTable& file, const RigidBody& carrier,
                     const JointLaws& laws, contact::SharedLaws& made);

}  // namespace separation
