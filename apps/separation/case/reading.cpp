#include "separation/case/reading.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace separation {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::string column_text(const TomlTable& table, std::string_view key) {
  std::string text = table.text(key);
  if (text.find_first_of("./,\"\n\r") != std::string::npos) {
    table.must_be(key, "a name without . / , \" and line ends");
  }
  return text;
}

std::optional<Vector3d> optional_vector(const TomlTable& table,
                                        std::string_view key) {
  const auto values = table.optional_numbers(key, {3});
  if (!values) return {};
  return Vector3d((*values)[0], (*values)[1], (*values)[2]);
}

Vector3d vector(const TomlTable& table, std::string_view key) {
  const auto values = table.numbers(key, {3});
  return {values[0], values[1], values[2]};
}

Vector3d vector_or_zero(const TomlTable& table, std::string_view key) {
  return optional_vector(table, key).value_or(Vector3d::Zero());
}

Vector3d direction(const TomlTable& table, std::string_view key) {
  const Vector3d v = vector(table, key);
  Vector3d unit = v.stableNormalized();
  if (!(unit.norm() > 0.5)) table.must_be(key, "a vector that is not 0");
  return unit;
}

Matrix3d rotation_of(const Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

std::optional<Matrix3d> optional_rotation(const TomlTable& table,
                                          std::string_view key) {
  const auto v = table.optional_numbers(key, {3});
  if (!v) return {};
  return rotation_of({(*v)[0], (*v)[1], (*v)[2]});
}

namespace {
constexpr contact::ArrayShape one_or_more{.rows = 1, .or_more = true};
}  // namespace

std::vector<double> increasing(const TomlTable& table, std::string_view key) {
  auto values = table.numbers(key, one_or_more);
  if (!std::is_sorted(values.begin(), values.end(), std::less_equal<>())) {
    table.must_be(key, "numbers that grow from one to the next");
  }
  return values;
}

std::vector<double> times_with_jumps(const TomlTable& table,
                                     std::string_view key) {
  auto times = table.numbers(key, one_or_more);
  bool in_order = std::is_sorted(times.begin(), times.end());
  for (std::size_t i = 2; i < times.size(); ++i) {
    in_order = in_order && times[i - 2] < times[i];
  }
  if (!in_order) {
    table.must_be(key, "times in order, the same one at most twice: a jump");
  }
  return times;
}

}  // namespace separation
