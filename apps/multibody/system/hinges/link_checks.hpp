#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <string>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

/// Checks common to all bodies.
namespace multibody {

// A moment of inertia this small relative to the largest is rounding of zero.
inline constexpr double zero_inertia = 1e-14;

[[noreturn]] inline void refuse(const std::string& what,
                                const std::string& rule) {
  throw contact::Error(contact::detail::must_be(what, rule));
}

inline std::string above_rounding(double scale) {
  return fmt::format("above {} kg m^2, the rounding of the largest moment",
                     zero_inertia * scale);
}

inline Eigen::Matrix3d turn_about_z(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

}  // namespace multibody
