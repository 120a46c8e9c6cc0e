#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "separation/case/case.hpp"
#include "separation/results/record.hpp"

/// The motion between the rows of a history, as it is shown.
namespace separation {

/// Place of a body: its centre of mass from the carrier's, in inertial
/// directions, m, and its turn from body axes to inertial ones. Without the
/// drift of the carrier, floats have room for millimetres.
struct Pose {
  Eigen::Vector3d position;
  Eigen::Quaterniond rotation;
};

/// The rows of which a replay is made: every `every`-th, the first, the last,
/// and those before and after events.
std::vector<std::size_t> replay_rows(const Rows& rows, int every);

/// The motion of one body between rows: cubics through poses and velocities at
/// both ends. As long as the hinge holds, the body stays on it, and about an
/// axis it is the angle that is a cubic, so that a wheel may turn many times
/// between two rows.
class BodyPath {
 public:
  /// @param body  0: the carrier
  /// @param kept  rows that count; of several at one time the last does
  /// Case and rows have to outlive this object.
  BodyPath(const Case& c, const Rows& rows,
           const std::vector<std::size_t>& kept, int body);

  std::size_t size() const { return kept_.size(); }
  /// At a place between the rows kept, from 0 to size() - 1.
  double time(double place) const;
  Pose pose(double place) const;
  /// Largest turn between two rows that the cubics have to guess, rad: of all
  /// but an axis.
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
    std::size_t motion;     // the first of position, velocity, ...
    std::size_t mode = 0;   // 0: no hinge
    std::size_t angle = 0;  // 0: no axis
  };
  // Of the carrier, of each body that hangs on the one before, of the body.
  std::vector<Columns> columns_;
};

/// Key frames between which poses are interpolated: positions on straight
/// lines, turns about a fixed axis.
struct KeyFrames {
  std::vector<double> times;
  std::vector<Pose> poses;
};

/// As few as keep within these of the path: twice as many as are needed, at
/// most.
/// @param length  m
/// @param angle   rad
KeyFrames key_frames(const BodyPath& path, double length, double angle);

}  // namespace separation
