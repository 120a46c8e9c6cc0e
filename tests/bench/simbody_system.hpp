#pragma once

#include <memory>
#include <vector>

#include "multibody_support/instant.hpp"

namespace multibody::bench {

/// An instant (gravity only, bodies on ball joints and axes) in Simbody:
/// bodies on Free, Ball and Pin mobilizers.
class SimbodySystem {
 public:
  explicit SimbodySystem(const Instant& instant);
  ~SimbodySystem();

  /// Advances by `time` s with Simbody's Runge-Kutta-Merson integrator.
  /// @param accuracy  its relative accuracy
  void advance(double time, double accuracy);
  /// Positions of the centres of mass, carrier and bodies, inertial axes.
  std::vector<Eigen::Vector3d> positions() const;

  /// Takes a state; computes all accelerations.
  void evaluate();
  /// Reactions in all mobilizers; call after evaluate().
  void find_reactions();
  /// Accelerations of the carrier by evaluate(), carrier axes.
  Eigen::Vector3d carrier_acceleration() const;
  Eigen::Vector3d carrier_angular_acceleration() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace multibody::bench
