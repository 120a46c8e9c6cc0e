#pragma once

#include <string>
#include <vector>

#include "programs/separation/replay/motion.hpp"
#include "separation/case/case.hpp"

/// Bodies and their motion as animated glTF 2.0.
namespace separation {

/// A run to show.
struct Take {
  const Case* of;    ///< same bodies as the other takes, in the same order
  std::string name;  ///< appended to names of bodies; "" for a single run
  bool faint;        ///< drawn faint, for comparison
  const Rows* rows;
  std::vector<std::size_t> kept;  ///< rows shown: replay_rows()
};

struct Scene {
  std::string glb;  ///< the file's bytes
  double size;      ///< how far from the carrier's centre bodies reach at first
  std::vector<int> nodes;  ///< bodies of the first take, in the glTF
};

/// Tolerances of position (as a fraction of Scene::size) and rotation (rad)
/// between key frames.
inline constexpr double shown_position = 1e-4;
inline constexpr double shown_turn = 0.05 * 3.14159265358979 / 180;

/// Colour of a body, sRGB, "#rrggbb", from the Okabe-Ito palette; the carrier
/// is grey.
std::string colour_of(int body);

/// Upward direction in inertial axes: against gravity, or z.
Eigen::Vector3d upwards(const Case& c);

/// Bodies without shapes, which are shown as a cross of axes.
std::vector<std::string> shapeless(const Case& c);

/// Places all bodies under one node, which rotates the upward direction to y;
/// positions are relative to the carrier's centre of mass, m. Bodies without
/// shapes are crosses of axes with a bar to their hinge. Balls and cubes mark
/// hinges and locks; their size becomes 0 at the row where they break.
/// @param takes  the first one sets the size
/// @param tolerance  factor on shown_position and shown_turn
Scene make_scene(const std::vector<Take>& takes, double tolerance);

}  // namespace separation
