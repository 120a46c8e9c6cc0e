// The joint solver on 10,000 random inputs; tests/bench/joint_sweep.cpp runs
// the same code on a million.
#include "support/joint_sweep.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

TEST(JointSweep, RandomInputsAndPaths) {
  const contact::test::JointSweep sweep = contact::test::joint_sweep(10000, 11);
  EXPECT_EQ(sweep.inputs, 10000U);
  EXPECT_EQ(sweep.not_ok, 0U);
  EXPECT_LE(sweep.residual, 1e-12) << sweep.worst_residual;
  EXPECT_LE(sweep.reaction, 1e-12);
  EXPECT_EQ(sweep.power, 0);
  // g and b by atan2: one rounding each.
  EXPECT_LE(sweep.angle_excess, 5e-16);
  EXPECT_EQ(sweep.scanned, 10000U);
  // Several roots need contacts beyond the hemisphere (docs/joint.md).
  EXPECT_GT(sweep.several_roots_limit, std::numbers::pi / 2);
  EXPECT_EQ(sweep.paths, 100U);
  // Inputs 1e-12 apart change the result by some 1e-12.
  EXPECT_LE(sweep.jump, 1e-11);
  EXPECT_EQ(sweep.folds, 0U);
  EXPECT_EQ(sweep.cold.count(), 10000U);
  EXPECT_EQ(sweep.warm.count(), 10000U);
  // Where the fixed point does not serve occurs.
  EXPECT_GT(sweep.fixed_point_fails, 100U);
  EXPECT_GT(sweep.fixed_point_slow, 50U);
}

}  // namespace
