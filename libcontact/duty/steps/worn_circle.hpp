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

/// A pin in a hole at points of the circle, under a load of any direction and
/// for shapes that wear has made: where the two touch, they do so with a
/// pressure above 0, and elsewhere with a gap. Any clearance, and any shape.
///
///     gap(t) = eps + h(t) + u(t) - D_x cos t - D_y sin t >= 0,   u_n = C_n p_n
///
/// With springs, which yield by `spring` times the pressure, it is an implicit
/// step of wear: h grows by that much (docs/explanation/wear.md).
///
/// Accuracy with 360 points (duty/worn_circle_test.cpp): S to 3e-4, the
/// half-angle to 0.25 deg of exact contacts without wear, in any direction.
class WornCircle {
 public:
  static constexpr int default_points = 360;
  explicit WornCircle(const LayeredPair& pair, int points = default_points);

  Eigen::Index size() const { return angle_.size(); }
  /// From 0 on, below 360 deg.
  const Eigen::VectorXd& angle() const { return angle_; }
  /// cos t, sin t
  const Eigen::MatrixX2d& lever() const { return lever_; }
  double radius() const { return radius_; }
  /// C_0, m/Pa.
  double mean_compliance() const { return mean_compliance_; }

  struct Contact {
    Eigen::VectorXd pressure;  ///< Pa
    Eigen::Vector2d shift = {0,
                             0};  ///< D, m; in an infinite body up to C_1 p_1
    /// Half the arc between the two ends, rad: pi if it is closed all round.
    double half_angle = 0;
    Status status = Status::not_converged;
  };
  /// @param load  P, N/m, towards the contact
  /// @param gap   eps + h at the points, m
  /// @param last  a contact that is near, from whose points it starts
  Contact press(const Eigen::Vector2d& load, const Eigen::VectorXd& gap,
                const CircleSprings& springs = {},
                const Contact* last = nullptr) const;

  /// A step of wear: gap grows by local p + mean of p, both implicitly, with
  /// an error of the third order (SDIRK of Alexander, two stages).
  /// @return the contact after it, with the status of both stages
  Contact wear(const Eigen::Vector2d& load, Eigen::VectorXd& gap,
               const CircleSprings& growth,
               const Contact* last = nullptr) const;

 private:
  using Points = std::vector<Eigen::Index>;
  Eigen::Index nearest(const Eigen::Vector2d& load) const;
  Points first_points(const Eigen::Vector2d& load, const Eigen::VectorXd& gap,
                      const Contact* last) const;
  void balance(const Eigen::Vector2d& load, const Eigen::VectorXd& gap,
               const CircleSprings& springs, const Points& touching,
               Contact& contact) const;
  double half_arc(const Eigen::Vector2d& load, const Eigen::VectorXd& pressure,
                  const Eigen::VectorXd& open) const;

  double radius_;
  double mean_compliance_;
  Eigen::VectorXd angle_;
  Eigen::MatrixX2d lever_;
  Eigen::MatrixXd compliance_;  // displacements of pressures
};

}  // namespace contact::detail
