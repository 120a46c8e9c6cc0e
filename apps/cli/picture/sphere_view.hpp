#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace cli {

/// A part of a sphere as it is seen from outside, in Lambert's projection,
/// equal in area: at the angle t from `up`, 2 sin(t/2) from the middle.
struct SphereView {
  Eigen::Vector3d up;     ///< towards the eye
  Eigen::Vector3d right;  ///< to the right of the picture
  Eigen::Vector3d top;
  double radius = 0;  ///< radius of the part shown, at most 2

  /// Z at the top, or Y where the eye looks along Z.
  /// @param towards_eye  unit vector
  explicit SphereView(const Eigen::Vector3d& towards_eye);

  /// Place of a point of the unit sphere in the picture.
  Eigen::Vector2d at(const Eigen::Vector3d& point) const;
  /// The point that is there.
  Eigen::Vector3d point(double x, double y) const;

  /// gnuplot's labels of the axes X, Y, Z that can be seen.
  std::string axis_labels() const;
  /// gnuplot's circles at 30, 60, ... deg from the middle.
  std::string circles() const;

 private:
  /// Visible ones of the directions X, -X, ...
  std::vector<Eigen::Vector3d> axes() const;
  /// On a circle, away from the axes.
  Eigen::Vector2d free_place(double size) const;
};

}  // namespace cli
