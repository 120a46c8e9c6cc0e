#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "separation/case/case.hpp"
#include "separation/results/record.hpp"

/// Interpolates the motion between the rows of a history.
namespace separation {

/// Position of a body's centre of mass relative to the carrier's, in inertial
/// directions, m, and the rotation from body axes to inertial axes. Positions
/// are relative because the carrier drifts away, and floats would then not
/// resolve millimetres.
struct Pose {
  Eigen::Vector3d position;
  Eigen::Quaterniond rotation;
};

/// Selects the rows of a replay: every `every`-th, the first, the last, and the
/// rows before and after events.
std::vector<std::size_t> replay_rows(const Rows& rows, int every);

/// The motion of one body between rows: cubics through poses and velocities at
/// both ends. While the hinge holds, the body stays on it. For a hinge with an
/// axis the angle is interpolated, so that a wheel may turn many times between
/// two rows.
class BodyPath {
 public:
  /// @param body  0: the carrier
  /// @param kept  rows to use; of several rows at one time the last one counts
  /// Case and rows must outlive this object.
  BodyPath(const Case& c, const Rows& rows,
           const std::vector<std::size_t>& kept, int body);

  std::size_t size() const { return kept_.size(); }
  /// Time at a place between the rows kept, from 0 to size() - 1.
  double time(double place) const;
  Pose pose(double place) const;
  /// Largest rotation between two rows that the cubics interpolate without a
  /// known angle, rad.
  double largest_turn() const;

 private:
  struct State {
    double time;
    Eigen::Vector3d position, velocity;  // inertial
    Eigen::Quaterniond rotation;
    Eigen::Vector3d rates;  // body axes
  };
  State state(std::size_t i, int link) const;
  Eigen::Quaterniond rotation(std::size_t i, double part, int link) const;
  Eigen::Vector3d position(std::size_t i, double part, int link) const;
  bool is_held(std::size_t i, int link) const;
  const Hinge& hinge(int link) const {
    return case_.bodies[columns_[link].body - 1].hinge;
  }
  int last() const { return static_cast<int>(columns_.size()) - 1; }
  double value(std::size_t i, std::size_t column) const {
    return rows_.at(kept_[i], column);
  }

  const Case& case_;
  const Rows& rows_;
  std::vector<std::size_t> kept_;
  struct Columns {
    int body;
    std::size_t motion;     // first of position, velocity, ...
    std::size_t mode = 0;   // 0: no hinge
    std::size_t angle = 0;  // 0: no axis
  };
  // Columns of the carrier, each body in the chain, and the body.
  std::vector<Columns> columns_;
};

/// Key frames. Poses between them are interpolated: positions linearly,
/// rotations about a fixed axis.
struct KeyFrames {
  std::vector<double> times;
  std::vector<Pose> poses;
};

/// Selects key frames that keep within these tolerances of the path: at most
/// twice as many as needed.
/// @param length  m
/// @param angle   rad
KeyFrames key_frames(const BodyPath& path, double length, double angle);

}  // namespace separation
