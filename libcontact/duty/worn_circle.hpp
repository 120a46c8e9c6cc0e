#pragma once

#include <Eigen/Core>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact::detail {

/// Something between pin and hole that yields to the pressure, m/Pa.
struct CircleSprings {
  double local = 0;  ///< at each point by itself
  double mean = 0;   ///< alike all round, by the mean pressure
};

/// A pin in a hole at points of the circle, symmetric about the load, for
/// shapes that wear has made: where the two touch, they do so with a pressure
/// above 0, and elsewhere with a gap. Any clearance, and any shape.
///
///     gap(t) = eps + h(t) + u(t) - D cos t >= 0,   u_n = C_n p_n
///
/// With springs, which yield by `spring` times the pressure, it is an implicit
/// step of wear: h grows by that much (docs/preload_wear.md).
///
/// Accuracy with 180 intervals (duty/worn_circle_test.cpp): S to 3e-4,
/// the half-angle to 0.5 deg of exact contacts without wear.
class WornCircle {
 public:
  /// @param intervals  between 0 and 180 deg
  explicit WornCircle(const LayeredPair& pair, int intervals = 180);

  /// Points from 0 to 180 deg.
  Eigen::Index size() const { return weight_.size(); }
  const Eigen::VectorXd& angle() const { return angle_; }
  /// Mean over the circle of a function of its points.
  double mean(const Eigen::VectorXd& values) const {
    return weight_.dot(values);
  }
  double radius() const { return radius_; }
  /// C_0, m/Pa.
  double mean_compliance() const { return mean_compliance_; }

  struct Contact {
    Eigen::VectorXd pressure;  ///< Pa
    double shift = 0;          ///< D, m; of a pin in an infinite body up to C_1
    double half_angle = 0;     ///< rad: pi if it is closed all round
    Status status = Status::not_converged;
  };
  /// @param load  P, N/m, >= 0
  /// @param gap   eps + h at the points, m
  /// @param last  a contact that is near, from whose points it starts
  Contact press(double load, const Eigen::VectorXd& gap,
                const CircleSprings& springs = {},
                const Contact* last = nullptr) const;

  /// A step of wear: gap grows by local p + mean of p, both implicitly, with
  /// an error of the third order (SDIRK of Alexander, two stages).
  /// @return the contact after it; its status is that of both stages
  Contact wear(double load, Eigen::VectorXd& gap, const CircleSprings& growth,
               const Contact* last = nullptr) const;

 private:
  double radius_;
  double mean_compliance_;
  Eigen::VectorXd angle_;
  Eigen::VectorXd cosine_;
  Eigen::VectorXd weight_;      // of mean()
  Eigen::MatrixXd compliance_;  // of weight p: symmetric
};

}  // namespace contact::detail
