#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "multibody/friction/hinges.hpp"

namespace multibody {

/// A hinge that begins to slide: what it could not hold, and where it gave way.
struct Onset {
  int body;
  Eigen::Vector3d excess = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// Friction that drives what it should hold back, by more than the rounding of
/// directions.
bool is_driven(const Hinges& hinges, int body);

/// Directions in which ball joints begin to slide: each that of its own
/// acceleration, on which its contact and so its friction depend.
class SlipDirections {
 public:
  /// Refers to all of them.
  /// @param evaluate  finds motion and friction; false if it cannot
  /// @param balls     ball joints that slide
  SlipDirections(Hinges& hinges, std::function<bool()> evaluate,
                 std::vector<Onset> balls)
      : hinges_(hinges),
        evaluate_(std::move(evaluate)),
        balls_(std::move(balls)),
        tangents_(3, 2 * balls_.size()) {}

  std::vector<Eigen::Vector3d> get() const;
  void set(const std::vector<Eigen::Vector3d>& directions);
  /// From the present directions, by Newton's method. False: not found.
  bool settle();
  /// From where the resting joints gave way; if that fails, from other starts.
  bool find();

 private:
  HingeMemory& memory(std::size_t k) { return hinges_.memory(balls_[k].body); }
  bool across(Eigen::VectorXd& parts);
  bool follow_excess();

  Hinges& hinges_;
  std::function<bool()> evaluate_;
  std::vector<Onset> balls_;
  Eigen::MatrixXd tangents_;  // two for each joint
};

}  // namespace multibody
