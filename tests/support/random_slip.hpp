#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <random>

#include "libcontact/joint/joint.hpp"

namespace contact::test {

/// One ball joint with a reaction and an angular velocity.
struct RandomSlip {
  Joint joint;
  Eigen::Vector3d reaction;
  Eigen::Vector3d rate;

  Joint::Slip slip() const {
    return {.reaction = reaction, .angular_velocity = rate};
  }
};

/// Random inputs over the whole range of a joint: f0 from 0 to 5, A rho^2/R
/// from 0 to 1e4 (also f0 = 0 with A > 0), b from 0 to 180 deg including both
/// ends, 90 deg and their neighbourhoods, reactions from 1e-12 to 1e12 N,
/// clearances from 1e-5 to 1e-2, half-angle laws tanh, arctan and blend with
/// limits from 30 to 115 deg, the ball on either side.
class RandomSlips {
 public:
  explicit RandomSlips(std::uint64_t seed) : random_(seed) {}

  RandomSlip next();

  /// Uniform in [0, 1), equal for every standard library.
  double uniform() {
    return std::min(static_cast<double>(random_()) * 0x1p-64, 1 - 0x1p-53);
  }
  /// Uniform on the unit sphere.
  Eigen::Vector3d direction();
  /// Uniform in the logarithm.
  double log_uniform(double low, double high);

 private:
  double angle();

  std::mt19937_64 random_;
};

}  // namespace contact::test
