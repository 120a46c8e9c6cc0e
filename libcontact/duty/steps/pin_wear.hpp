#pragma once

#include <Eigen/Core>

#include "libcontact/duty/steps/worn_circle.hpp"
#include "libcontact/pair/layers.hpp"

namespace contact::detail {

/// A pin and its hole, with interference at first or not, under loads that may
/// move in the hole: docs/explanation/wear.md. A point of the hole wears by its
/// own pressure; the pin, which turns, stays round and wears by the mean
/// pressure.
///
/// While the contact is closed all round it is exact: interference falls
/// exponentially. Then it steps (WornCircle). Accuracy
/// (duty/pin_wear_test.cpp): S, pressure at the centre and depth of one load as
/// wear.csv's own, 4e-5 to 4e-3; S of a pin that wears alone to 3e-5.
class PinWear {
 public:
  /// @param clearance  eps before wear, m
  /// @param worn       depths at the circle's points that are gone already, m
  PinWear(const LayeredPair& pair, double clearance,
          const Eigen::VectorXd& worn = {});

  /// Sliding distance times the wear coefficients k, m/Pa: a depth is its
  /// product with a pressure.
  struct Path {
    double hole;
    double pin;
    double both() const { return hole + pin; }
  };
  /// @param load  P, N/m, towards the contact, in the axes of the hole
  /// @return ok, or not_converged if some contact on the way was not found
  Status slide(const Eigen::Vector2d& load, Path path);
  /// The same in one implicit step of first order, short beside next_step():
  /// one of the many places that a load passes.
  Status pass(const Eigen::Vector2d& load, Path path);

  /// The path that half the steps of slide() would take next: a load that
  /// changes may be cut into such pieces.
  double next_step() const;
  /// Whether it was closed all round at all times.
  bool is_closed() const { return !has_lifted_; }

  /// @param last  one that is near, from which it starts; null: the last step's
  WornCircle::Contact contact(const Eigen::Vector2d& load,
                              const WornCircle::Contact* last = nullptr) const;
  const WornCircle& circle() const { return circle_; }
  /// Mean over the circle, m, of the clearance that is left.
  double clearance() const { return gap_.mean(); }
  /// Worn off the hole at the circle's points, m.
  const Eigen::VectorXd& worn() const { return worn_; }
  /// The deepest of it.
  double depth() const { return worn_.maxCoeff(); }
  /// Worn off the hole, m^3 per m of its length.
  double worn_area() const;

 private:
  double path_to_lift_off(double load) const;
  void close(const Eigen::Vector2d& load, Path& path);
  template <class Step>
  Status step(const CircleSprings& growth, const Step& contact);
  const WornCircle::Contact* last() const;

  WornCircle circle_;
  Eigen::VectorXd gap_;
  Eigen::VectorXd worn_;  // depth of the hole's wear
  bool has_lifted_;
  double since_ = 0;  // path since it lifted off
  WornCircle::Contact last_;
};

}  // namespace contact::detail
