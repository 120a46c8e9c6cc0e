#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <string>

#include "hosts/joint_handle.hpp"

/// A ball in a cup, in a host with rotated bodies.
namespace contact::test {

/// Writes the file of a cup about the x axis of the half with the cup, the body
/// or its parent.
inline std::string cup(bool on_parent) {
  std::string path =
      testing::TempDir() + "/contact_cup_" +
      testing::UnitTest::GetInstance()->current_test_info()->name() +
      std::to_string(on_parent) + ".toml";
  std::ofstream(path) << "kind = 'ball'\ninner_body = '"
                      << (on_parent ? "body" : "carrier")
                      << "'\n[geometry]\nradius_mm = 14\n"
                         "radial_clearance_um = 100\n"
                         "[materials.inner]\nyoungs_modulus_GPa = 210\n"
                         "poissons_ratio = 0.3\n"
                         "[materials.outer]\nyoungs_modulus_GPa = 1\n"
                         "poissons_ratio = 0.4\n"
                         "[friction]\ncoefficient = 0.05\n"
                         "[seat]\ncup_deg = 90\naxis = [1, 0, 0]\n";
  return path;
}

/// Attitudes of both halves. A weight of 1 kN along -z presses 70 deg from the
/// axis of the half with the cup.
inline Eigen::Matrix3d attitude(bool on_parent, bool is_parent) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  if (on_parent != is_parent) {
    return AngleAxisd(0.7, Vector3d(0.36, 0.48, 0.8)).toRotationMatrix();
  }
  const double up = (on_parent ? 20 : -20) * M_PI / 180;
  return (AngleAxisd(up, Vector3d::UnitY()) *
          AngleAxisd(0.8, Vector3d::UnitX()))
      .toRotationMatrix();
}

/// Moment of the cup from C; vectors are in world axes.
/// @param axes  of the half with the cup, as columns
inline Eigen::Vector3d moment_in(const std::string& file,
                                 const Eigen::Matrix3d& axes,
                                 const Eigen::Vector3d& reaction,
                                 const Eigen::Vector3d& rate) {
  using Eigen::Vector3d;
  const auto joint = contact_hosts::read_joint(file, "", CONTACT_BALL);
  contact_slip slip{};
  Vector3d::Map(slip.reaction) = axes.transpose() * reaction;
  Vector3d::Map(slip.angular_velocity) = axes.transpose() * rate;
  contact_solution s;
  contact_hosts::must(contact_joint_solve(joint.get(), &slip, nullptr, &s));
  EXPECT_TRUE(std::isnan(s.half_angle));  // it is at its rim
  return axes * Vector3d(s.friction_moment);
}

}  // namespace contact::test
