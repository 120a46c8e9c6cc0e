#pragma once

/// How many operations the resolution takes, and its increment by friction.
namespace multibody {

/// Multiplications, additions, divisions, sines and cosines, of which L bodies
/// take per_body L + fixed.
struct Operations {
  int per_body = 0;
  int fixed = 0;

  constexpr int of(int bodies) const { return per_body * bodies + fixed; }
  bool operator==(const Operations&) const = default;
};

/// Those of TwoStep, exactly: operation_count_test.cpp counts them with a
/// scalar of its own. Rotations from quaternions and angles are in the
/// evaluation.
inline constexpr Operations evaluation_of_balls{342, 196};
inline constexpr Operations evaluation_of_axes{309, 196};
/// Friction moments changed, nothing else: an iteration of the outer loop.
inline constexpr Operations iteration_of_balls{116, 69};
inline constexpr Operations iteration_of_axes{32, 69};

}  // namespace multibody
