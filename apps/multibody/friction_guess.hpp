#pragma once

#include <Eigen/Core>

#include "multibody/loading.hpp"

namespace multibody {

/// What the friction of a hinge will be, from what it was at its last
/// solutions: straight lines through the last one, with slopes from secants
/// (Broyden's update), in axes that turn with R and Dw. A start for the outer
/// loop, and the next step of it; never the answer.
class FrictionGuess {
 public:
  explicit FrictionGuess(bool is_axis) : is_axis_(is_axis) {}

  void forget() { solutions_ = 0; }
  bool valid() const { return solutions_ >= 2; }

  /// M_t, load axes.
  /// @return false if there is no guess for these
  bool predict(const Reaction<double>& reaction, const Eigen::Vector3d& rate,
               Eigen::Vector3d& moment) const;
  /// A solution.
  void learn(const Reaction<double>& reaction, const Eigen::Vector3d& rate,
             const Eigen::Vector3d& moment);

 private:
  // Numbers that the friction depends on, of order 1.
  using Input = Eigen::Matrix<double, 6, 1>;
  struct Place {
    Input input;
    Eigen::Matrix3d axes;  // of the moment
    double size;           // of the moment
  };
  bool place(const Reaction<double>& reaction, const Eigen::Vector3d& rate,
             Place& place) const;
  void set_units(const Reaction<double>& reaction, const Eigen::Vector3d& rate);

  bool is_axis_;
  int solutions_ = 0;
  double per_force_ = 1;
  double per_moment_ = 1;
  double per_rate_ = 1;
  Input input_ = Input::Zero();
  Eigen::Vector3d output_ = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 6> slope_ = Eigen::Matrix<double, 3, 6>::Zero();
};

}  // namespace multibody
