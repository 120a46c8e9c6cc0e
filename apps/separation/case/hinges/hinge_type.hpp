#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "separation/case/case.hpp"

namespace separation {

/// A [body.hinge] being read.
struct HingeTable {
  const contact::TomlTable& table;
  const RigidBody& body;
  const RigidBody& parent;
};

/// A kind of hinge: its keys in case files and its angle. Its dynamics:
/// multibody/system/hinges.
struct HingeType {
  multibody::HingeKind kind;
  std::string_view name;
  /// Keys in addition to the keys of all hinges.
  contact::KnownKeys keys;
  /// Whether its angle counts full turns; else the angle lies between two
  /// directions, 0 to 180 deg.
  bool counts_turns;
  /// Key of the rate in [body.start].
  std::string_view rate_key;
  /// Reads its own keys,
  void (*read)(const HingeTable& from, Hinge& hinge);
  /// and the keys about its joints; rejects joints that do not suit the kind.
  void (*read_joints)(const contact::TomlTable& table, Hinge& hinge);
  void (*read_start)(const contact::TomlTable& table,
                     multibody::BodyStart& start);
  /// Sets up the hinge of a body with the hinge's points.
  void (*place)(const Hinge& hinge, multibody::Body& body);
  /// Its angle, without full turns.
  /// @param rotation  body axes to parent axes
  double (*angle)(const Hinge& hinge, const Eigen::Matrix3d& rotation);
  /// Component of an angular velocity, or acceleration, of the body relative to
  /// its parent that changes the angle; for a ball joint its length.
  /// @param parent  parent axes to the axes of the vector
  double (*turn)(const Hinge& hinge, const Eigen::Matrix3d& parent,
                 const Eigen::Vector3d& relative);
};

/// All kinds; list.cpp contains the list.
const std::vector<HingeType>& hinge_types();
/// Type of an existing hinge.
const HingeType& hinge_type(const Hinge& hinge);

/// "parent_point" of a hinge with on = "NAME", else "carrier_point"; rejects
/// the other key.
std::string parent_key(const contact::TomlTable& hinge, std::string_view end);

/// Rejects angles outside the range of its hinges.
/// @param where  text after "0 deg to 180 deg on "
void check_angles(const contact::TomlTable& table, const Hinge& hinge,
                  double low, double high, const std::string& where);

bool is_ball(const HingeJoint& joint);

}  // namespace separation
