#pragma once

/// Number of operations of the resolution, and of its increment by friction.
namespace multibody {

/// Multiplications, additions, divisions, sines and cosines: per_body L + fixed
/// for L bodies.
struct Operations {
  int per_body = 0;
  int fixed = 0;

  constexpr int of(int bodies) const { return per_body * bodies + fixed; }
  bool operator==(const Operations&) const = default;
};

/// Exact counts of TwoStep: operation_count_test.cpp counts them with its own
/// scalar type. They include rotations from quaternions and angles.
inline constexpr Operations evaluation_of_balls{342, 196};
inline constexpr Operations evaluation_of_axes{309, 196};
/// Only friction moments change: an iteration of the outer loop.
inline constexpr Operations iteration_of_balls{116, 69};
inline constexpr Operations iteration_of_axes{32, 69};

}  // namespace multibody
