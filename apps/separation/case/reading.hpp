#pragma once

#include <Eigen/Core>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "libcontact/files/toml_reader.hpp"

/// Helpers of the readers of case files.
namespace separation {

using contact::Interval;
using contact::TomlTable;

/// Angles, to more turns than anyone means.
inline constexpr Interval most_turns{-100 * std::numbers::pi,
                                     100 * std::numbers::pi};

/// A text that becomes part of the names of columns and data sets.
std::string column_text(const TomlTable& table, std::string_view key);

std::optional<Eigen::Vector3d> optional_vector(const TomlTable& table,
                                               std::string_view key);
Eigen::Vector3d vector(const TomlTable& table, std::string_view key);
Eigen::Vector3d vector_or_zero(const TomlTable& table, std::string_view key);
/// A direction of any length but 0, made a unit vector.
Eigen::Vector3d direction(const TomlTable& table, std::string_view key);
/// A rotation vector (axis times angle); none if the key is missing.
std::optional<Eigen::Matrix3d> optional_rotation(const TomlTable& table,
                                                 std::string_view key);
/// Increasing numbers.
std::vector<double> increasing(const TomlTable& table, std::string_view key);

/// Times of a table: a repeated time is a jump.
std::vector<double> times_with_jumps(const TomlTable& table,
                                     std::string_view key);

/// The rotation by the vector's length about it.
Eigen::Matrix3d rotation_of(const Eigen::Vector3d& vector);

}  // namespace separation
