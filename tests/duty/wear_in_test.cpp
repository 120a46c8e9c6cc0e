#include "libcontact/duty/wear_in.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/friction/any_pressure.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/pressure/worn.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/reference_table.hpp"

namespace {

using contact::DutyCycle;
using contact::JointCycle;
using contact::JointGeometry;
using contact::JointKind;
using contact::PeriodicSpline;
using contact::WornState;
using Eigen::Vector3d;

constexpr double radius = 0.02;
constexpr double clearance = 4e-5;
constexpr double length = 0.05;
constexpr double force = 1000;
constexpr double speed = 2;  // rad/s

DutyCycle steady() {
  const std::vector<double> times = {0, 1, 2, 3};
  const std::vector<Vector3d> forces(4, Vector3d(0, -force, 0));
  const std::vector<Vector3d> rates(4, Vector3d(0, 0, speed));
  return {
      PeriodicSpline(times, 4, forces), {}, PeriodicSpline(times, 4, rates)};
}

contact::JointContact pin(double modulus, double friction, double limit = 1) {
  const contact::ElasticPair pair({modulus, 0.3}, {modulus, 0.3});
  return {JointGeometry::pin(radius, clearance, length), pair,
          contact::FrictionLaw(friction),
          contact::make_half_angle_law("tanh", JointKind::pin, pair,
                                       {.limit_half_angle = limit}),
          contact::make_pressure_law("cosine", JointKind::pin, pair)};
}

// A pin that wears alone has an exact solution,
// k P s/(rho eps) = theta0/cos theta0 - sin theta0. Within a block S is that of
// its beginning: it grows by 27 % at all, in a block by 1 % at most.
TEST(WearIn, PinWithoutElasticity) {
  const double k = 1e-14;  // m^2/N
  const double cycle = radius * speed * 4;
  for (const double cycles : {1e3, 3e4, 1e6}) {
    const WornState worn = wear_in(steady(), pin(1e15, 1e-6), k, cycles).back();
    EXPECT_EQ(worn.cycles, cycles);
    EXPECT_TRUE(worn.worn_in);
    const double t = worn.half_angle;
    EXPECT_NEAR(k * force / length * cycle * cycles / (radius * clearance) /
                    (t / std::cos(t) - std::sin(t)),
                1, 0.01)
        << cycles;
    EXPECT_NEAR(
        worn.volume / (2 * radius * clearance * length * (std::tan(t) - t)), 1,
        1e-3);
    EXPECT_NEAR(worn.penetration / (clearance * (1 / std::cos(t) - 1)), 1,
                1e-3);
  }
}

// The first state is the joint's own cycle; volume starts as k times the
// integral of p v, and blocks end at N.
TEST(WearIn, BeginsWithTheUnwornJoint) {
  const contact::JointContact contact = pin(1e11, 0.1);
  const DutyCycle cycle = steady();
  const contact::Joint joint(contact);
  const JointCycle fresh(cycle, joint);
  const double pv = fresh.integral([&](const contact::CycleInstant& i) {
    return fresh.sliding(i).pv_total();
  });
  const double k = 1e-15;
  const auto worn = wear_in(cycle, contact, k, 1e6);
  ASSERT_GT(worn.size(), 3u);
  EXPECT_EQ(worn.front().volume, 0);
  EXPECT_FALSE(worn.front().worn_in);
  EXPECT_DOUBLE_EQ(worn.front().half_angle,
                   fresh.rows()[0].solution.half_angle);
  EXPECT_NEAR(worn[1].volume / (k * pv * worn[1].cycles), 1, 1e-12);
  for (std::size_t i = 1; i < worn.size(); ++i) {
    EXPECT_GT(worn[i].half_angle, worn[i - 1].half_angle);
    EXPECT_GT(worn[i].wear_number, worn[i - 1].wear_number);
  }
  // Without wear nothing changes.
  const auto none = wear_in(cycle, contact, 0, 1e9);
  ASSERT_EQ(none.size(), 2u);
  EXPECT_EQ(none[1].cycles, 1e9);
  EXPECT_EQ(none[1].half_angle, none[0].half_angle);
}

// Computed apart from the library, 1e-11.
TEST(WearIn, SlidingCoefficientOfAWornInBall) {
  const contact::test::ReferenceTable table("duty/wear_in.csv");
  contact::test::AccuracyReport report("sigma_Y, a = 0", 1e-11);
  for (const contact::test::ReferenceTable::Row row : table) {
    if (row.text("joint") != "ball") continue;
    report.add(contact::worn_in_sliding_coefficient(
                   row.value("theta0_worn_deg") * contact::degree),
               row.value("moment_coefficient_a0"), row.label());
  }
  EXPECT_EQ(report.size(), 29u);
  report.check();
}

// What WornPressure says of such a ball, docs/pressure_laws.md; the limits.
TEST(WearIn, SlidingCoefficientBesideThePressureWorn) {
  constexpr double pi = std::numbers::pi;
  const contact::WornPressure law(JointKind::ball);
  double largest = 0;
  for (double theta0_deg = 1; theta0_deg < 90; theta0_deg += 1) {
    const double theta0 = theta0_deg * contact::degree;
    const double excess =
        contact::friction_integrals(law, theta0, contact::SlipAxis{0, 1})
                .coefficient.sliding /
            contact::worn_in_sliding_coefficient(theta0) -
        1;
    EXPECT_GT(excess, 0);
    largest = std::max(largest, excess);
    // Spinning alone wears in to cot theta.
    const double s = std::sin(theta0);
    const double spinning =
        contact::friction_integrals(law, theta0, contact::SlipAxis{1, 0})
            .coefficient.spinning /
        (s * s / (theta0 + s * std::cos(theta0)));
    EXPECT_GT(spinning, 4. / 3);
    EXPECT_LT(spinning, pi / 2);
  }
  EXPECT_NEAR(largest, 0.0041, 5e-5);
  EXPECT_NEAR(contact::worn_in_sliding_coefficient(pi / 2), 4 / pi, 1e-15);
  EXPECT_EQ(contact::worn_in_sliding_coefficient(0), 1);
  EXPECT_NEAR(contact::worn_in_sliding_coefficient(1e-9), 1, 1e-15);
  for (const double bad : {-0.1, 1.6, std::nan("")}) {
    EXPECT_TRUE(std::isnan(contact::worn_in_sliding_coefficient(bad)));
  }
}

TEST(WearIn, Messages) {
  const auto message = [](double k, double cycles, double modulus) {
    return contact::test::error_message(
        [&] { wear_in(steady(), pin(modulus, 0.1, 1.7), k, cycles); });
  };
  EXPECT_EQ(message(-1, 1, 1e11),
            "wear: coefficient = -1 must be 0 m^2/N or above and finite");
  EXPECT_EQ(message(1, -1, 1e11),
            "wear: cycles = -1 must be 0 or above and finite");
  EXPECT_TRUE(message(1e-15, 1, 1e5).ends_with("must be at most 90 deg"))
      << message(1e-15, 1, 1e5);
}

}  // namespace
