// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "libcontact/files/setting.hpp"
#include "libcontact/joint/spec.hpp"
#include "libcontact/pair/friction_law.hpp"
#include "libcontact/pair/material.hpp"

/// Material pairs and joints from TOML files (keys:
/// docs/reference/joint_file.md).
///
/// Every reader throws contact::Error with one line that names file, line, key,
/// value and the allowed values; rejects unknown keys.
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

/// @param settings  keys whose values are others than in the file
JointSpec read_joint(const std::filesystem::path& path,
                     const KeySettings& settings = {});
/// @param source  what messages call the text
/// @param folder  what paths in it are relative to
JointSpec parse_joint(std::string_view text, const std::string& source,
                      const KeySettings& settings = {},
                      const std::filesystem::path& folder = {});

}  // namespace contact
