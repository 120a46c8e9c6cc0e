#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace multibody {

/// A JSON value and its place in the file. Every reader throws contact::Error
/// with the place, the value and what is allowed.
class JsonNode {
 public:
  /// @param place  "" for the whole file
  JsonNode(const nlohmann::json& value, std::string place)
      : value_(value), place_(std::move(place)) {}

  /// Throws if an object has other keys than these.
  /// @param what  has them, for the message: "the carrier"
  void allow_keys(std::span<const std::string> keys, const char* what) const;
  bool has(const char* key) const { return value_.contains(key); }
  /// Member of an object, which has to be there.
  JsonNode operator[](const char* key) const;
  /// Element of an array.
  JsonNode operator[](std::size_t i) const;
  /// Number of elements of an array.
  std::size_t size() const;

  double number() const;  ///< finite
  bool boolean() const;
  std::string string() const;
  Eigen::Vector3d vector() const;
  Eigen::Vector3d vector_or_zero(const char* key) const;
  Eigen::Matrix3d matrix() const;  ///< list of rows
  /// Orthogonal to 1e-6 and right-handed; the rest is put right.
  Eigen::Matrix3d rotation() const;

  /// Throws "place: value, allowed is ...".
  [[noreturn]] void fail(const std::string& allowed) const;

 private:
  const nlohmann::json& value_;
  std::string place_;
};

}  // namespace multibody
