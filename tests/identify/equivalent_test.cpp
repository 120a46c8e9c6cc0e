// Numbers for the formulas of other programs, against closed forms and against
// all candidates.
#include "libcontact/identify/equivalent.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "support/error_message.hpp"

namespace contact::test::equivalent_test {
namespace {

using namespace contact;
using contact::test::error_message;
using Eigen::Vector3d;

const Material steel = {210e9, 0.3};

Joint ball(FrictionLaw friction) {
  return Joint({.geometry = JointGeometry::ball(0.02, 20e-6),
                .inner = steel,
                .outer = steel,
                .friction = friction});
}

Joint::Slip state(double load, double b) {
  return {.reaction = {load * std::sin(b), 0, load * std::cos(b)},
          .angular_velocity = {0, 0, 1}};
}

std::vector<Joint::Slip> sweep(double low, double high,
                               const std::vector<double>& directions) {
  std::vector<Joint::Slip> states;
  for (int i = 0; i <= 12; ++i) {
    const double load = low * std::pow(high / low, i / 12.0);
    for (const double b : directions) states.push_back(state(load, b));
  }
  return states;
}

double resisting(const Joint& joint, const Joint::Slip& state) {
  return -joint.solve(state).friction_moment.dot(
      state.angular_velocity.normalized());
}

// Largest error of a formula over states.
template <class Formula>
double worst(const Joint& joint, const std::vector<Joint::Slip>& states,
             const Formula& formula) {
  double largest = 0;
  for (const Joint::Slip& s : states) {
    largest = std::max(
        largest,
        std::abs(formula(s.reaction.norm()) / resisting(joint, s) - 1));
  }
  return largest;
}

constexpr double right = std::numbers::pi / 2;

// A point contact: M = rho R f/sqrt(1 + f^2) for any load.
TEST(Equivalent, PointContactHasOneRadius) {
  const Joint joint = ball(FrictionLaw(0.2));
  const auto e = equivalent_friction(joint, sweep(1e-6, 1e-5, {right}));
  const double arm = 0.02 * 0.2 / std::sqrt(1 + 0.2 * 0.2);
  EXPECT_NEAR(e.arm.value, arm, 1e-4 * arm);
  EXPECT_LT(e.arm.largest_error, 1e-4);
  EXPECT_LT(e.arm_with_preload.largest_error, 1e-4);
}

TEST(Equivalent, ErrorsAreThoseOfTheFormulas) {
  const Joint joint = ball(FrictionLaw(0.15, 2e5));
  const auto states = sweep(100, 5000, {0.3, 0.9, right});
  const auto e = equivalent_friction(joint, states);
  const auto error = [&](double preload, double arm) {
    return worst(joint, states,
                 [&](double load) { return preload + arm * load; });
  };
  EXPECT_NEAR(error(0, e.arm.value), e.arm.largest_error, 1e-14);
  EXPECT_NEAR(error(e.moment.value, 0), e.moment.largest_error, 1e-14);
  EXPECT_NEAR(error(e.preload, e.arm_with_preload.value),
              e.arm_with_preload.largest_error, 1e-14);
}

// Each error of one parameter is had twice, with both signs.
TEST(Equivalent, NoOtherNumberIsLessWrong) {
  const Joint joint = ball(FrictionLaw(0.15, 2e5));
  const auto states = sweep(100, 5000, {0.3, 0.9, right});
  const auto e = equivalent_friction(joint, states);
  for (const double factor : {0.999, 1.001}) {
    EXPECT_GT(worst(joint, states,
                    [&](double r) { return factor * e.arm.value * r; }),
              e.arm.largest_error);
    EXPECT_GT(
        worst(joint, states, [&](double) { return factor * e.moment.value; }),
        e.moment.largest_error);
  }
}

// The largest and the least way are missed alike.
TEST(Equivalent, StictionLiesBetweenThatOfTheStates) {
  const Joint joint({.geometry = JointGeometry::ball(0.02, 20e-6),
                     .inner = steel,
                     .outer = steel,
                     .friction = FrictionLaw(0.15),
                     .half_angle_law = "exact"});
  const auto way = [&](const Joint::Slip& s) {
    const JointSolution at = joint.solve(s);
    return 0.15 * joint.contact().shift(at.normal_force, at.half_angle);
  };
  const auto e = equivalent_stiction(joint, sweep(100, 5000, {right}));
  const double low = way(state(100, right));
  const double high = way(state(5000, right));
  EXPECT_GT(high, 1.1 * low);
  EXPECT_NEAR(e.value / low - 1, e.largest_error, 1e-13);
  EXPECT_NEAR(1 - e.value / high, e.largest_error, 1e-13);
  EXPECT_TRUE(std::isnan(
      equivalent_stiction(ball(FrictionLaw(0)), {{state(100, right)}}).value));
  EXPECT_EQ(error_message([&] { equivalent_stiction(joint, {}); }),
            "equivalent stiction requires at least one state");
}

// The best M0 + c R has three errors of alternating sign, by Chebyshev's
// theorem: all triples are tried.
TEST(Equivalent, PreloadIsThatOfAllTriples) {
  const Joint joint = ball(FrictionLaw(0.15, 2e5));
  const auto states = sweep(100, 5000, {right});
  const auto e = equivalent_friction(joint, states);
  std::vector<Vector3d> rows;  // M0/M + c R/M -+ E = 1
  for (const auto& s : states) {
    const double moment = resisting(joint, s);
    rows.emplace_back(1 / moment, s.reaction.norm() / moment, 1);
  }
  // The largest of the least errors of three states is the least error of all.
  double needed = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        Eigen::Matrix3d m;
        m << rows[i].transpose(), rows[j].transpose(), rows[k].transpose();
        // Signs of E at the three that the two columns cannot see.
        const Vector3d blind = m.col(0).cross(m.col(1));
        const double least = std::abs(blind.sum()) / blind.lpNorm<1>();
        needed = std::max(needed, least);
      }
    }
  }
  EXPECT_GT(e.preload, 0);
  EXPECT_NEAR(e.arm_with_preload.largest_error, needed, 1e-9);
  EXPECT_LT(e.arm_with_preload.largest_error, 0.6 * e.arm.largest_error);
}

// About three axes at once a box resists by sqrt(3) times its side, so that its
// moments over load spread by so much more.
TEST(Equivalent, BoxOfThreeAxes) {
  const Joint joint = ball(FrictionLaw(0.2));
  const auto e = equivalent_friction(joint, sweep(1e-6, 1e-5, {right}));
  const double box = (std::numbers::sqrt3 - 1) / (std::numbers::sqrt3 + 1);
  EXPECT_NEAR(e.arm_per_axis.largest_error, box, 1e-4);
  EXPECT_NEAR(e.arm_per_axis.value, e.arm.value * (1 - box),
              1e-4 * e.arm.value);
}

JointSpec bush() {
  return {.geometry = JointGeometry::pin(0.02, 2e-5, 0.05),
          .inner = steel,
          .outer = {{{0.004, {110e9, 0.34}}, {0.02, steel}}, Backing::held()},
          .friction = FrictionLaw(0.1)};
}

TEST(Equivalent, PinHasNoBox) {
  const auto e = equivalent_friction(Joint(bush()), sweep(1e3, 2e4, {right}));
  EXPECT_EQ(e.arm_per_axis.value, e.arm.value);
  EXPECT_EQ(e.moment_per_axis.largest_error, e.moment.largest_error);
}

// The error of the bending arm, by hand; no other arm has less.
TEST(Equivalent, BendingArm) {
  const JointSpec pin = bush();
  const std::vector<double> forces = {2e3, 2e4};
  const double c = 0.0021;
  const LeastWrong arm = equivalent_bending_arm(pin, forces, 0.05, c);
  // A couple at the ends: 2 z/l times M, so that R_b is l at z = l; contacts
  // have a width, and near the middle bending adds nothing.
  EXPECT_GT(arm.value, 0.05 / 2);
  EXPECT_LT(arm.value, 0.05 * 2);
  const FinitePin finite(pin);
  const auto error = [&](double bending_arm) {
    double largest = 0;
    for (const double force : forces) {
      for (int i = 0; i <= 16; ++i) {
        const double z = 0.05 * i / 16;
        const double moment =
            std::abs(finite.solve_at({force, 0}, z, 1).moment.z());
        largest = std::max(
            largest, std::abs(c * force * (1 + z / bending_arm) / moment - 1));
      }
    }
    return largest;
  };
  EXPECT_NEAR(error(arm.value), arm.largest_error, 1e-7);
  for (const double factor : {0.99, 1.01}) {
    EXPECT_GE(error(factor * arm.value), arm.largest_error);
  }
}

TEST(Equivalent, Refusals) {
  const Joint joint = ball(FrictionLaw(0.2));
  EXPECT_EQ(error_message([&] { (void)equivalent_friction(joint, {}); }),
            "equivalent friction requires at least one state");
  const std::vector<Joint::Slip> unloaded = {state(0, right)};
  EXPECT_EQ(error_message([&] { (void)equivalent_friction(joint, unloaded); }),
            "equivalent friction: a reaction of 0 N requires a friction moment "
            "above 0");
}

}  // namespace
}  // namespace contact::test::equivalent_test
