#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace cli {

/// A part of a sphere seen from outside in Lambert's equal-area projection: a
/// point at the angle t from `up` lies 2 sin(t/2) from the middle.
struct SphereView {
  Eigen::Vector3d up;     ///< towards the eye
  Eigen::Vector3d right;  ///< to the right of the picture
  Eigen::Vector3d top;
  double radius = 0;  ///< radius of the part shown, at most 2

  /// Z points up in the picture, or Y if the eye looks along Z.
  /// @param towards_eye  unit vector
  explicit SphereView(const Eigen::Vector3d& towards_eye);

  /// Projects a point of the unit sphere into the picture.
  Eigen::Vector2d at(const Eigen::Vector3d& point) const;
  /// The point of the sphere at a place of the picture.
  Eigen::Vector3d point(double x, double y) const;

  /// gnuplot's labels of the visible axes X, Y, Z.
  std::string axis_labels() const;
  /// gnuplot's circles at 30, 60, ... deg from the middle.
  std::string circles() const;

 private:
  /// The visible directions among X, -X, ...
  std::vector<Eigen::Vector3d> axes() const;
  /// A place on a circle, away from the axes.
  Eigen::Vector2d free_place(double size) const;
};

}  // namespace cli
