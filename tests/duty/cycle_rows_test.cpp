// Rows of cycles as they are measured: their period, and a row too many.
#include "libcontact/duty/duty_cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "libcontact/base/error.hpp"

namespace contact::test::cycle_rows_test {
namespace {

using Eigen::Vector3d;

// A swing in `count` rows of a second each, and `more` of the next period.
DutyCycle::Rows swing(int count, int more = 0) {
  DutyCycle::Rows rows;
  for (int i = 0; i < count + more; ++i) {
    const double phase = 2 * std::numbers::pi * i / count;
    rows.times.push_back(7 + i);
    rows.forces.emplace_back(0, -900, 100 * std::cos(phase));
    rows.motion.emplace_back(std::sin(phase), 0, 0);
  }
  return rows;
}

TEST(CycleRows, GoOnByOneStep) {
  DutyCycle::Rows rows = swing(20);
  EXPECT_EQ(rows.make_one_period(), "");
  EXPECT_DOUBLE_EQ(rows.period.value(), 20);
  EXPECT_EQ(rows.times.size(), 20u);
}

// sin(2 pi) is not 0 in doubles: a return to rounding is one.
TEST(CycleRows, ReturnIsLeftOut) {
  for (const std::optional<double> period :
       {std::optional<double>(), std::optional(20.0)}) {
    DutyCycle::Rows rows = swing(20, 1);
    rows.period = period;
    EXPECT_EQ(rows.make_one_period(),
              "the last row repeats the first and is left out: the period is "
              "20 s; give a longer period if it is a separate row");
    EXPECT_DOUBLE_EQ(rows.period.value(), 20);
    EXPECT_EQ(rows.times.size(), 20u);
    EXPECT_EQ(rows.forces.size(), 20u);
    EXPECT_EQ(rows.motion.size(), 20u);
  }
}

// Numbers of some nine digits return, others are a row of their own, in
// whichever column.
TEST(CycleRows, RowsBesideTheFirstOneStay) {
  for (const auto& [share, stays] :
       {std::pair{1e-10, false}, {1e-8, true}, {1e-6, true}, {0.9e-3, true}}) {
    // Relative to the ranges 200 N and 2.
    DutyCycle::Rows force = swing(20, 1);
    force.forces.back().z() -= 200 * share;
    DutyCycle::Rows motion = swing(20, 1);
    motion.motion.back().x() += 2 * share;
    for (DutyCycle::Rows* rows : {&force, &motion}) {
      EXPECT_EQ(rows->make_one_period().empty(), stays) << share;
      EXPECT_EQ(rows->times.size(), stays ? 21u : 20u) << share;
    }
  }
}

// A stated longer period means the row.
TEST(CycleRows, ReturnWithinALongerPeriodStays) {
  DutyCycle::Rows rows = swing(20, 1);
  rows.period = 21;
  EXPECT_EQ(rows.make_one_period(), "");
  EXPECT_EQ(rows.times.size(), 21u);
}

// Uneven steps have a period if their last row returns.
TEST(CycleRows, UnevenSteps) {
  DutyCycle::Rows rows = swing(20, 1);
  rows.times[3] += 0.3;
  DutyCycle::Rows open = rows;
  EXPECT_NE(rows.make_one_period(), "");
  EXPECT_DOUBLE_EQ(rows.period.value(), 20);
  open.motion.back().y() = 1e-3;
  EXPECT_EQ(open.make_one_period(), "");
  EXPECT_FALSE(open.period);
  EXPECT_EQ(open.times.size(), 21u);
}

// Steps that differ by a thousandth count as even.
TEST(CycleRows, NearlyEvenSteps) {
  for (const auto& [difference, is_even] :
       {std::pair{0.9e-3, true}, {1.1e-3, false}, {0.1, false}}) {
    DutyCycle::Rows rows = swing(20, 1);
    rows.motion.back().y() = 1e-3;  // no row returns
    for (std::size_t i = 10; i < rows.times.size(); ++i) {
      rows.times[i] += difference;
    }
    rows.times.back() -= difference;
    // The last step is short, the tenth long.
    EXPECT_EQ(rows.make_one_period(), "");
    EXPECT_EQ(rows.period.has_value(), is_even) << difference;
  }
}

// Nothing moves and no force changes: no row says that a period is over.
TEST(CycleRows, AllAlikeRepeatNothing) {
  DutyCycle::Rows rows{{0, 1, 2, 3},
                       std::vector<Vector3d>(4, {0, -900, 0}),
                       std::vector<Vector3d>(4, {0, 0, 2}),
                       {}};
  EXPECT_EQ(rows.make_one_period(), "");
  EXPECT_DOUBLE_EQ(rows.period.value(), 4);
}

// PeriodicSpline refuses what is no cycle.
TEST(CycleRows, WithoutSenseStayAsTheyAre) {
  DutyCycle::Rows none;
  EXPECT_EQ(none.make_one_period(), "");
  EXPECT_FALSE(none.period);
  DutyCycle::Rows rows = swing(5, 1);
  rows.forces.pop_back();
  EXPECT_EQ(rows.make_one_period(), "");
  EXPECT_EQ(rows.times.size(), 6u);
}

// Angles beyond a turn, or far from row to row, may be degrees taken for
// radians; rates may have any size.
TEST(CycleRows, NotesOfAnglesThatMayBeDegrees) {
  const auto notes = [](double size, int count) {
    DutyCycle::Rows rows = swing(count);
    rows.period = count;
    for (Vector3d& angles : rows.motion) angles *= size;
    return DutyCycle(rows, {}, DutyCycle::TurnSequence("xyz")).notes(false);
  };
  EXPECT_TRUE(notes(1, 20).empty());
  EXPECT_TRUE(notes(6.28, 50).empty());
  EXPECT_EQ(
      notes(25, 100),
      std::vector<std::string>(
          {"the angles reach 25 rad and change by up to 1.57 rad from row to "
           "row: are these degrees read as radians, or too few rows?"}));
  EXPECT_EQ(notes(6.3, 100).size(), 1U);  // beyond a turn
  EXPECT_EQ(notes(3.0, 16).size(), 1U);   // 1.15 rad from row to row
  DutyCycle::Rows rates = swing(20);
  rates.period = 20;
  for (Vector3d& rate : rates.motion) rate *= 25;
  EXPECT_TRUE(DutyCycle(rates, {}).notes(false).empty());
}

// One row, or two equal rows, are a steady rotation: Q = exp(w t) for any
// period.
TEST(CycleRows, SteadyTurn) {
  const Vector3d rate(0.3, -4, 1);
  for (const int count : {1, 2}) {
    DutyCycle::Rows rows;
    for (int i = 0; i < count; ++i) {
      rows.times.push_back(2 + i);
      rows.forces.emplace_back(0, -900, 20);
      rows.motion.push_back(rate);
    }
    rows.period = 7.5;
    EXPECT_EQ(rows.make_one_period(), "");
    EXPECT_TRUE(rows.is_steady());
    const DutyCycle cycle(rows, {});
    EXPECT_EQ(cycle.period(), 7.5);
    // Eight rows to each of the five turns that are begun.
    EXPECT_EQ(cycle.times().size(), 40u);
    for (const double time : {2.0, 3.1, 9.4}) {
      const DutyCycle::State state = cycle.at(time);
      EXPECT_LT((state.angular_velocity - rate).norm(), 1e-13);
      EXPECT_LT((state.reaction - Vector3d(0, -900, 20)).norm(), 1e-12);
      const Eigen::Quaterniond turn(
          Eigen::AngleAxisd(rate.norm() * (time - 2), rate.normalized()));
      EXPECT_LT(state.turn.angularDistance(turn), 1e-13);
    }
  }
}

// Rows that differ, without a period or with one that they outlast are not.
TEST(CycleRows, FewRowsAreRefused) {
  DutyCycle::Rows two{
      {0, 1}, {{1, 0, 0}, {2, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}, 3};
  EXPECT_FALSE(two.is_steady());
  EXPECT_THROW(DutyCycle(two, {}), Error);
  two.forces[1] = two.forces[0];
  EXPECT_NO_THROW(DutyCycle(two, {}));
  two.period = 1;
  EXPECT_THROW(DutyCycle(two, {}), Error);
  two.period.reset();
  EXPECT_THROW(DutyCycle(two, {}), Error);
}

}  // namespace
}  // namespace contact::test::cycle_rows_test
