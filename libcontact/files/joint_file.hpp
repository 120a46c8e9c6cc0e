#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libcontact/files/toml_reader.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/contact.hpp"
#include "libcontact/pair/contact_conditions.hpp"
#include "libcontact/pair/fit.hpp"
#include "libcontact/pair/friction_law.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/material.hpp"
#include "libcontact/pressure/factory.hpp"

/// Material pairs and joints from TOML files (keys: docs/joint_file.md).
///
/// Every reader throws contact::Error with one line that names file, line,
/// key, value and what they must be; unknown keys are refused.
namespace contact {

/// A material pair file.
struct MaterialPair {
  std::string name;
  ElasticPair elastic;
  /// [friction], if the file has it: dry or viscous.
  std::optional<FrictionModel> friction;
};

MaterialPair read_material_pair(const std::filesystem::path& path);
/// @param source  what messages call the text
MaterialPair parse_material_pair(std::string_view text,
                                 const std::string& source);

/// One material: the keys of [inner].
Material read_material(const std::filesystem::path& path);

class SharedLaws;

/// A joint file: all that is known of one joint.
struct JointSpec {
  std::string name;
  JointGeometry geometry;
  /// What the geometry is from, if the file has a fit.
  std::optional<Fit> fit = {};
  /// At the surfaces, also where there are walls.
  ElasticPair pair;
  /// [friction] of the joint, else of its material pair file.
  std::optional<FrictionModel> friction;
  /// [half_angle], for make_half_angle_law().
  std::string half_angle_law;
  HalfAngleOptions half_angle_options;
  /// [pressure], for make_pressure_law().
  std::string pressure_law;
  /// [loading], [wall] and [[coating]], for both.
  ContactConditions conditions = {};

  /// What a Joint is made of:
  ///
  ///     contact::Joint hip(contact::read_joint("hip.toml").contact());
  ///
  /// @throws Error if there is no friction
  JointContact contact() const;
  /// The same, of several joints that share their laws.
  JointContact contact(SharedLaws& laws) const;

  std::unique_ptr<HalfAngleLaw> make_half_angle_law() const;
  std::unique_ptr<PressureLaw> make_pressure_law() const;
  /// Load from and to load parameter.
  LoadScale load_scale() const { return {geometry, pair}; }
  /// Notes of the geometry and of the half-angle law.
  std::vector<std::string> validity_notes() const;
};

/// The laws of joints that belong together: those that are alike share one.
class SharedLaws {
 public:
  /// As the functions of JointSpec make them.
  std::shared_ptr<const HalfAngleLaw> half_angle(const JointSpec& joint);
  std::shared_ptr<const PressureLaw> pressure(const JointSpec& joint);

 private:
  std::vector<std::pair<JointSpec, std::shared_ptr<const HalfAngleLaw>>>
      half_angle_;
  std::vector<std::pair<JointSpec, std::shared_ptr<const PressureLaw>>>
      pressure_;
};

/// @param settings  keys whose values are others than in the file
JointSpec read_joint(const std::filesystem::path& path,
                     const KeySettings& settings = {});
/// @param source  what messages call the text
/// @param folder  what paths in it are relative to
JointSpec parse_joint(std::string_view text, const std::string& source,
                      const KeySettings& settings = {},
                      const std::filesystem::path& folder = {});
/// A joint that is part of a larger file, which has joint_keys() among its own.
/// Paths are relative to the folder of the table's file.
JointSpec joint_from_table(const TomlTable& table);
/// A joint that is all of a file with joint_keys().
JointSpec joint_of_file(const TomlTable& file);
/// All keys that a joint may have.
KnownKeys joint_keys();

}  // namespace contact
