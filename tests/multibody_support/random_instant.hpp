#pragma once

#include <cstdint>
#include <random>

#include "multibody_support/instant.hpp"

/// Carriers with random bodies for tests and benchmarks: equal seeds give equal
/// numbers on every machine.
namespace multibody::test {

/// Uniform numbers, vectors and rotations.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  Eigen::Vector3d vector(double size);
  Eigen::Matrix3d rotation();
  /// A physically possible inertia, with moments around `size`.
  Eigen::Matrix3d inertia(double size);

 private:
  std::mt19937_64 engine_;
};

/// Joints of the bodies of a random instant.
enum class Mix { balls, axes, held, all };

/// Bodies of a few kilograms and decimetres on a carrier of twice that for each
/// body, with random motions and loads.
Instant random_instant(Mix mix, int bodies, std::uint64_t seed);

}  // namespace multibody::test
