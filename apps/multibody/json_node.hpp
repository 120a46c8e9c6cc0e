#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "libcontact/error.hpp"
#include "multibody/system.hpp"

namespace multibody {

[[noreturn]] inline void fail(const std::string& place,
                              const std::string& message) {
  throw contact::Error(place + ": " + message);
}

/// A JSON value and where it is in the file; every reader throws
/// contact::Error with that place, the value and what is allowed.
class JsonNode {
 public:
  JsonNode(const nlohmann::json& value, std::string place)
      : value_(value), place_(std::move(place)) {}

  const std::string& place() const { return place_; }
  bool has(const char* key) const { return value_.contains(key); }

  JsonNode operator[](const char* key) const {
    const std::string place = place_.empty() ? key : place_ + "." + key;
    if (!value_.is_object()) fail(place_, "allowed is an object");
    if (!has(key)) fail(place, "missing");
    return {value_[key], place};
  }
  JsonNode operator[](std::size_t i) const {
    return {value_[i], fmt::format("{}[{}]", place_, i)};
  }
  std::size_t size() const { return value_.size(); }

  // An array of `count` elements, or of any number.
  const JsonNode& array(std::size_t count) const {
    if (!value_.is_array() || value_.size() != count) {
      fail(place_, fmt::format("{}, allowed is an array of {}", text(), count));
    }
    return *this;
  }
  const JsonNode& array() const {
    if (!value_.is_array()) {
      fail(place_, fmt::format("{}, allowed is an array", text()));
    }
    return *this;
  }
  double number() const {
    if (!value_.is_number() || !std::isfinite(value_.get<double>())) {
      fail(place_, fmt::format("{}, allowed is a finite number", text()));
    }
    return value_.get<double>();
  }
  std::string string() const {
    if (!value_.is_string()) {
      fail(place_, fmt::format("{}, allowed is a string", text()));
    }
    return value_.get<std::string>();
  }
  Eigen::Vector3d vector() const {
    array(3);
    Eigen::Vector3d v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = (*this)[i].number();
    return v;
  }
  Eigen::Vector3d vector_or_zero(const char* key) const {
    return has(key) ? (*this)[key].vector() : Eigen::Vector3d::Zero();
  }
  // A list of rows.
  Eigen::Matrix3d matrix() const {
    array(3);
    Eigen::Matrix3d m;
    for (std::size_t i = 0; i < 3; ++i) m.row(i) = (*this)[i].vector();
    return m;
  }
  Eigen::Matrix3d rotation() const {
    return checked_rotation(matrix(), place_);
  }

 private:
  std::string text() const {
    std::string text = value_.dump();
    return text.size() > 40 ? text.substr(0, 37) + "..." : text;
  }

  const nlohmann::json& value_;
  std::string place_;
};

}  // namespace multibody
