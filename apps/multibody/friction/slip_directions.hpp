#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "multibody/friction/hinges.hpp"

namespace multibody {

/// A hinge that begins to slide: the moment it could not hold, and its
/// direction.
struct Onset {
  int body;
  Eigen::Vector3d excess = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
};

/// Whether friction drives a hinge instead of holding it back, by more than the
/// rounding of directions.
bool is_driven(const Hinges& hinges, int body);

/// Directions in which ball joints begin to slide: each joint slides along its
/// acceleration, on which its contact and so its friction depend.
class SlipDirections {
 public:
  /// Keeps references to its arguments.
  /// @param evaluate  computes motion and friction; false if it fails
  /// @param balls     ball joints that slide
  SlipDirections(Hinges& hinges, std::function<bool()> evaluate,
                 std::vector<Onset> balls)
      : hinges_(hinges),
        evaluate_(std::move(evaluate)),
        balls_(std::move(balls)),
        tangents_(3, 2 * balls_.size()) {}

  std::vector<Eigen::Vector3d> get() const;
  void set(const std::vector<Eigen::Vector3d>& directions);
  /// Newton's method from the present directions. False: not converged.
  bool settle();
  /// Starts from the directions at onset; if this fails, from other directions.
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
