#include "multibody_oracle/json_node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "multibody/system/system.hpp"

namespace multibody {

using contact::detail::printable;

void JsonNode::allow_keys(std::span<const std::string> keys,
                          const char* what) const {
  if (!value_.is_object()) fail("an object");
  std::vector<std::string> absent;
  std::ranges::copy_if(
      keys, std::back_inserter(absent),
      [this](const std::string& key) { return !has(key.c_str()); });
  for (const auto& [key, value] : value_.items()) {
    if (std::ranges::find(keys, key) != keys.end()) continue;
    const std::string meant = contact::detail::nearest(key, absent);
    throw contact::Error(fmt::format(
        "{}{}: unknown key of {}: {}", place_.empty() ? "" : place_ + ".",
        printable(key), what,
        meant.empty() ? fmt::format("allowed: {}", fmt::join(keys, ", "))
                      : fmt::format("did you mean {}?", meant)));
  }
}

JsonNode JsonNode::operator[](const char* key) const {
  if (!value_.is_object()) fail("an object");
  const std::string place = place_.empty() ? key : place_ + "." + key;
  if (!has(key)) throw contact::Error(place + ": missing");
  return {value_[key], place};
}

JsonNode JsonNode::operator[](std::size_t i) const {
  return {value_[i], fmt::format("{}[{}]", place_, i)};
}

std::size_t JsonNode::size() const {
  if (!value_.is_array()) fail("an array");
  return value_.size();
}

double JsonNode::number() const {
  if (!value_.is_number() || !std::isfinite(value_.get<double>())) {
    fail("a finite number");
  }
  return value_.get<double>();
}

bool JsonNode::boolean() const {
  if (!value_.is_boolean()) fail("true or false");
  return value_.get<bool>();
}

std::string JsonNode::string() const {
  if (!value_.is_string()) fail("a string");
  return value_.get<std::string>();
}

Eigen::Vector3d JsonNode::vector() const {
  if (size() != 3) fail("an array of 3 numbers");
  Eigen::Vector3d v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = (*this)[i].number();
  return v;
}

Eigen::Vector3d JsonNode::vector_or_zero(const char* key) const {
  return has(key) ? (*this)[key].vector() : Eigen::Vector3d::Zero();
}

Eigen::Matrix3d JsonNode::matrix() const {
  if (size() != 3) fail("an array of 3 rows");
  Eigen::Matrix3d m;
  for (std::size_t i = 0; i < 3; ++i) m.row(i) = (*this)[i].vector();
  return m;
}

Eigen::Matrix3d JsonNode::rotation() const {
  return checked_rotation(matrix(), place_);
}

void JsonNode::fail(const std::string& allowed) const {
  throw contact::Error(fmt::format("{}: {}, allowed is {}",
                                   place_.empty() ? "file" : place_,
                                   printable(value_.dump()), allowed));
}

}  // namespace multibody
