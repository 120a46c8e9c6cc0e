#pragma once

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// Reads the parts of [body.hinge] that do not depend on the copy.
/// @param made  laws of the case's joints
Hinge read_hinge(const contact::TomlTable& table, const RigidBody& body,
                 const RigidBody& parent, const JointLaws& laws,
                 contact::SharedLaws& made);

/// The friction of a hinge.
/// @throws contact::Error if its joints do not suit each other, which
///   read_hinge() has checked
multibody::HingeFriction make_friction(const Hinge& hinge,
                                       FrictionChoice choice);

}  // namespace separation
