#pragma once

#include <limits>

#include "libcontact/finite_pin/finite_pin.hpp"

/// Sums of FinitePin along its pin.
namespace contact {

struct FinitePin::Sums {
  Eigen::Vector4d load = Eigen::Vector4d::Zero();  // F, G
  double energy = 0;
  Eigen::Matrix4d stiffness = Eigen::Matrix4d::Zero();
  double pressure_moment = 0;
  Eigen::Vector4d area = Eigen::Vector4d::Zero();  // tangent, its z-moment
  double area_moment = 0;
  double peak = 0;
  double peak_place = std::numeric_limits<double>::quiet_NaN();
};

namespace detail {

/// By 90 deg about z.
inline Eigen::Vector2d turned(const Eigen::Vector2d& v) {
  return {-v.y(), v.x()};
}

}  // namespace detail
}  // namespace contact
