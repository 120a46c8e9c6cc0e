#include "libcontact/base/linear/turn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace contact::test::turn_test {
namespace {

using detail::turn_between;
using Eigen::Vector3d;

// Down to the last angle before the opposite direction, where the cosine of
// half the turn cancels.
TEST(Turn, BetweenDirectionsIsUnitAndArrives) {
  const Vector3d from = Vector3d(1, 2, -2) / 3;
  const Vector3d across = from.unitOrthogonal();
  for (double left = 1; left > 1e-12; left /= 3) {
    for (const double angle : {left, std::numbers::pi - left}) {
      const Vector3d to =
          2 * (std::cos(angle) * from + std::sin(angle) * across);
      const Eigen::Quaterniond turn = turn_between(3 * from, to);
      EXPECT_NEAR(turn.norm(), 1, 1e-14) << angle;
      // Nearer than 1e-7 the opposite direction is taken.
      EXPECT_LT((turn * from - to.normalized()).norm(), 2e-7) << angle;
      if (std::numbers::pi - angle < 2e-7) continue;
      // Rounding of directions over what is left.
      EXPECT_LT((turn * from - to.normalized()).norm(),
                1e-14 + 1e-15 / (std::numbers::pi - angle))
          << angle;
    }
  }
  EXPECT_TRUE(
      turn_between(from, from).isApprox(Eigen::Quaterniond::Identity(), 1e-15));
}

}  // namespace
}  // namespace contact::test::turn_test
