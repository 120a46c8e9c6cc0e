#pragma once

#include <string>
#include <vector>

#include "programs/separation/replay/motion.hpp"
#include "separation/case/case.hpp"

/// Bodies and their motion as animated glTF 2.0.
namespace separation {

/// A run that is shown.
struct Take {
  const Case* of;    ///< with the bodies of the others, in their order
  std::string name;  ///< added to names of bodies; "" for the only one
  bool faint;        ///< for comparison with the other one
  const Rows* rows;
  std::vector<std::size_t> kept;  ///< rows shown: replay_rows()
};

struct Scene {
  std::string glb;  ///< the file's bytes
  double size;      ///< how far from the carrier's centre bodies reach at first
  std::vector<int> nodes;  ///< bodies of the first take, in the glTF
};

/// Tolerances of a position and a turn between key frames: a part of
/// Scene::size, and rad.
inline constexpr double shown_position = 1e-4;
inline constexpr double shown_turn = 0.05 * 3.14159265358979 / 180;

/// Colour of a body, sRGB, "#rrggbb": of Okabe and Ito; the carrier is grey.
std::string colour_of(int body);

/// Upwards in inertial axes: against gravity, or z.
Eigen::Vector3d upwards(const Case& c);

/// Bodies that are shown as a cross of axes because they have no shapes.
std::vector<std::string> shapeless(const Case& c);

/// All bodies under one node, which turns upwards to y; places are from the
/// carrier's centre of mass, in m. Bodies without shapes are crosses of axes
/// with a bar to their hinge. Hinges and locks are marked by balls and cubes,
/// of size 0 from the row on at which they are broken.
/// @param takes  the first one is looked at
/// @param tolerance  times shown_position and shown_turn
Scene make_scene(const std::vector<Take>& takes, double tolerance);

}  // namespace separation
