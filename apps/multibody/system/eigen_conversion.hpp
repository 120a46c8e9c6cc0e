#pragma once

#include <Eigen/Core>

#include "multibody/system/linear3.hpp"

namespace multibody {

inline Vec3<double> vec3(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
inline Eigen::Vector3d vec3(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

inline Mat3<double> mat3(const Eigen::Matrix3d& m) {
  return {vec3(Eigen::Vector3d(m.col(0))), vec3(Eigen::Vector3d(m.col(1))),
          vec3(Eigen::Vector3d(m.col(2)))};
}

/// The upper triangle.
inline Sym3<double> sym3(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}

}  // namespace multibody
