#include "libcontact/duty/wear_in.hpp"
#include "libcontact/duty/worn_sliding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/pressure/worn.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::wear_in_test {
namespace {

using Eigen::Vector3d;

constexpr double radius = 0.02;
constexpr double clearance = 4e-5;
constexpr double length = 0.05;
constexpr double force = 1000;
constexpr double speed = 2;  // rad/s

// A seat that turns, and the load with it.
DutyCycle steady() {
  const std::vector<double> times = {0, 1, 2, 3};
  const std::vector<Vector3d> forces(4, Vector3d(0, -force, 0));
  const std::vector<Vector3d> rates(4, Vector3d(0, 0, speed));
  return {{times, forces, rates, 4}, {JointBody::body, JointBody::body}};
}

JointContact pin(double modulus, double friction, double limit = 1) {
  const ElasticPair pair({modulus, 0.3}, {modulus, 0.3});
  return {JointGeometry::pin(radius, clearance, length), pair,
          FrictionLaw(friction),
          make_half_angle_law("tanh", JointKind::pin, pair,
                              {.limit_half_angle = limit}),
          make_pressure_law("cosine", JointKind::pin, pair)};
}

// A pin that wears alone has an exact solution, k P s/(rho eps) = theta0/cos
// theta0 - sin theta0. Within a block S keeps its initial value: it grows by 27
// % at all, in a block by 1 % at most.
TEST(WearIn, PinWithoutElasticity) {
  const double k = 1e-14;  // m^2/N
  const double cycle = radius * speed * 4;
  for (const double cycles : {1e3, 3e4, 1e6}) {
    const WearIn::State worn =
        wear_in(steady(), pin(1e15, 1e-6), {k}, cycles).states.back();
    EXPECT_EQ(worn.cycles, cycles);
    EXPECT_GT(worn.worn_share, 0.999);
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
  const JointContact contact = pin(1e11, 0.1);
  const DutyCycle cycle = steady();
  const Joint joint(contact);
  const JointCycle fresh(cycle, joint);
  const double pv = fresh.integral([&](const JointCycle::Instant& i) {
    return fresh.sliding(i).pv_total();
  });
  const double k = 1e-15;
  const auto worn = wear_in(cycle, contact, {k}, 1e6).states;
  ASSERT_GT(worn.size(), 3u);
  EXPECT_EQ(worn.front().volume, 0);
  EXPECT_EQ(worn.front().worn_share, 0);
  EXPECT_DOUBLE_EQ(worn.front().half_angle,
                   fresh.rows()[0].solution.half_angle);
  EXPECT_NEAR(worn[1].volume / (k * pv * worn[1].cycles), 1, 1e-12);
  for (std::size_t i = 1; i < worn.size(); ++i) {
    EXPECT_GT(worn[i].half_angle, worn[i - 1].half_angle);
    EXPECT_GT(worn[i].wear_number, worn[i - 1].wear_number);
  }
  // Without wear nothing changes.
  const auto none = wear_in(cycle, contact, {0}, 1e9).states;
  ASSERT_EQ(none.size(), 2u);
  EXPECT_EQ(none[1].cycles, 1e9);
  EXPECT_EQ(none[1].half_angle, none[0].half_angle);
}

// Computed apart from the library, 1e-11.
TEST(WearIn, SlidingCoefficientOfAWornInBall) {
  const ReferenceTable table("duty/wear_in.csv");
  AccuracyReport report("sigma_Y, a = 0", 1e-11);
  for (const ReferenceTable::Row row : table) {
    if (row.text("joint") != "ball") continue;
    report.add(
        worn_in_sliding_coefficient(row.value("theta0_worn_deg") * degree),
        row.value("moment_coefficient_a0"), row.label());
  }
  EXPECT_EQ(report.size(), 29u);
}

// Values of WornPressure for such a ball, docs/internals/pressure_laws.md; the
// limits.
TEST(WearIn, SlidingCoefficientBesideThePressureWorn) {
  const WornPressure law(JointKind::ball);
  double largest = 0;
  for (double theta0_deg = 1; theta0_deg < 90; theta0_deg += 1) {
    const double theta0 = theta0_deg * degree;
    const double excess =
        friction_integrals(law, theta0, SlipAxis{0, 1}).coefficient.sliding /
            worn_in_sliding_coefficient(theta0) -
        1;
    EXPECT_GT(excess, 0);
    largest = std::max(largest, excess);
    // Spinning alone wears in to cot theta.
    const double s = std::sin(theta0);
    const double spinning =
        friction_integrals(law, theta0, SlipAxis{1, 0}).coefficient.spinning /
        (s * s / (theta0 + s * std::cos(theta0)));
    EXPECT_GT(spinning, 4. / 3);
    EXPECT_LT(spinning, pi / 2);
  }
  EXPECT_NEAR(largest, 0.0041, 5e-5);
  EXPECT_NEAR(worn_in_sliding_coefficient(pi / 2), 4 / pi, 1e-15);
  EXPECT_EQ(worn_in_sliding_coefficient(0), 1);
  EXPECT_NEAR(worn_in_sliding_coefficient(1e-9), 1, 1e-15);
  for (const double bad : {-0.1, 1.6, std::nan("")}) {
    EXPECT_TRUE(std::isnan(worn_in_sliding_coefficient(bad)));
  }
}

// A swing of 10 deg to each side under a stationary load in the seat.
DutyCycle swing(double load, JointBody axes) {
  constexpr int rows = 40;
  std::vector<double> times;
  std::vector<Vector3d> angles;
  for (int i = 0; i < rows; ++i) {
    times.push_back(double(i) / rows);
    const double phase = 2 * std::numbers::pi * i / rows;
    angles.emplace_back(10 * degree * std::sin(phase), 0, 0);
  }
  const std::vector<Vector3d> forces(rows, Vector3d(0, -load, 0));
  return {{times, forces, angles, 1},
          {JointBody::body, axes},
          DutyCycle::TurnSequence("z")};
}

constexpr double weak = 1e-3;  // friction

JointContact pin_joint() {
  return read_joint(std::filesystem::path(CONTACT_DATA_DIR) / "joints" /
                    "pin_joint.toml")
      .contact()
      .with_friction(FrictionLaw(weak));
}

// A liner of 0.4 mm on something rigid.
JointContact lined(JointKind kind) {
  const auto geometry =
      kind == JointKind::ball
          ? JointGeometry::ball(radius, clearance, JointBody::carrier)
          : JointGeometry::pin(radius, clearance, length, JointBody::carrier);
  const JointSpec spec{.geometry = geometry,
                       .inner = {{}, Backing::rigid()},
                       .outer = {{{4e-4, {2e9, 0.3}}}, Backing::rigid()},
                       .friction = FrictionLaw(weak)};
  return spec.contact();
}

// Joints that wore step by step, made apart from the library: theta0 and peak
// of a pin in bronze with all its elasticity, of a pin and a ball on a thin
// liner, which is a bed of springs. Their own grid is good to 0.15 deg.
TEST(WearIn, AgainstStepByStep) {
  struct Row {
    const char* joint;
    double cycles, theta0_deg, peak_MPa;
  };
  constexpr Row rows[] = {
      {"bronze", 3e4, 34.2, 46.8}, {"bronze", 7e4, 37.7, 42.6},
      {"bronze", 1e5, 39.8, 40.1}, {"bronze", 2e5, 45.0, 34.7},
      {"bronze", 1e6, 62.9, 27.0}, {"lined", 1e5, 45.9, 57.4},
      {"lined", 2e5, 51.1, 49.5},  {"ball", 1e5, 49.4, 68.7},
      {"ball", 2e5, 53.7, 53.3},
  };
  constexpr double k = 1e-16;  // 1e-7 mm^3/(N m)
  AccuracyReport half_angle("theta0, of 1 deg", 1.1 + 0.15);
  AccuracyReport peak("peak", 0.06);
  for (const auto& [joint, cycles, theta0_deg, peak_MPa] : rows) {
    const std::string name = joint;
    const JointContact contact =
        name == "bronze"
            ? pin_joint()
            : lined(name == "ball" ? JointKind::ball : JointKind::pin);
    const double load = name == "ball" ? 3e4 : name == "lined" ? 6e4 : 4e4;
    const WearIn wear =
        wear_in(swing(load, JointBody::body), contact, {k}, cycles);
    const WearIn::State& worn = wear.states.back();
    const std::string label = name + ", " + std::to_string(cycles);
    half_angle.add_error(std::abs(worn.half_angle / degree - theta0_deg),
                         label);
    peak.add(worn.peak_pressure, peak_MPa * 1e6, label);
    EXPECT_TRUE(wear.notes.empty()) << wear.notes[0];
  }
  // WornPressure is not a ball's, cos theta/w: step by step 31.0 MPa.
  const WearIn::State ball =
      wear_in(swing(3e4, JointBody::body), lined(JointKind::ball), {k}, 3e6)
          .states.back();
  EXPECT_NEAR(ball.half_angle / degree, 78.2, 0.15);
  EXPECT_GT(ball.peak_pressure, 31.0e6);
  EXPECT_LT(ball.peak_pressure, 1.175 * 31.0e6);
}

// From block to block g grows by at most 10 %, the half-angle by 3 %, the peak
// falls by as much: no law takes over from another at once.
TEST(WearIn, RunsInWithoutAJump) {
  for (const JointKind kind : {JointKind::pin, JointKind::ball}) {
    const auto states =
        wear_in(swing(3e4, JointBody::body), lined(kind), {1e-16}, 1e6).states;
    ASSERT_GT(states.size(), 10u);
    EXPECT_GT(states.back().worn_share, 0.9);
    for (std::size_t i = 1; i < states.size(); ++i) {
      const auto fall = [&](double WearIn::State::*of) {
        return 1 - states[i].*of / (states[i - 1].*of);
      };
      EXPECT_GT(fall(&WearIn::State::peak_pressure), 0) << i;
      EXPECT_LT(fall(&WearIn::State::peak_pressure), 0.06) << i;
      EXPECT_LT(std::abs(fall(&WearIn::State::pv)), 0.06) << i;
      EXPECT_LT(std::abs(fall(&WearIn::State::energy)), 0.02) << i;
    }
  }
}

// The seat swings under the load by 10 deg to each side: p v passes all places
// alike.
TEST(WearIn, SpreadOfTheContact) {
  const double even = 10 * degree / std::sqrt(3.0);
  const auto spread = [](const DutyCycle& cycle, const JointContact& contact) {
    const Joint joint(contact);
    return JointCycle(cycle, joint).contact_spread();
  };
  const DutyCycle moving = swing(force, JointBody::carrier);
  // Friction turns the contact by 1e-6 to either side; the spline of the angle
  // is good to 1e-6.
  EXPECT_NEAR(spread(moving, pin(1e11, 1e-6)) / even, 1, 1e-5);
  EXPECT_NEAR(
      spread(swing(force, JointBody::body), pin(1e11, 0.1)) / std::atan(0.1), 1,
      1e-9);
  EXPECT_EQ(spread(swing(0, JointBody::body), pin(1e11, 0.1)), 0);
  // A seat that turns below the load: all places of a circle.
  const std::vector<double> times = {0, 0.5, 1, 1.5};
  const DutyCycle turning(
      {times, std::vector<Vector3d>(4, {0, -force, 0}),
       std::vector<Vector3d>(4, {0, 0, std::numbers::pi}), 2},
      {});
  EXPECT_NEAR(
      spread(turning, pin(1e11, 1e-6)) / (std::numbers::pi / std::sqrt(3.0)), 1,
      1e-3);
}

// Half-angles around 45, 12 and 4 deg; the spread is 5.8 deg.
TEST(WearIn, LoadsThatMove) {
  const auto worn = [](double load) {
    return wear_in(swing(load, JointBody::carrier), pin(1e11, 1e-6), {1e-16},
                   100);
  };
  for (const double load : {1.5e5, 5e3, 200.0}) {
    const WearIn wear = worn(load);
    ASSERT_EQ(wear.notes.size(), 1u) << load;
    EXPECT_EQ(wear.notes[0],
              "the contact is worn step by step and solved by elasticity "
              "alone: the laws tanh and cosine are used for the unworn joint "
              "only");
    EXPECT_EQ(wear.worn.depths.size(), 360u);
    EXPECT_EQ(wear.worn.cycles, 100);
  }
  EXPECT_TRUE(
      wear_in(swing(5e3, JointBody::body), pin(1e11, 1e-6), {1e-16}, 100)
          .notes.empty());
}

// Steps assume a load at the centre, and a note reports it.
TEST(WearIn, LoadThroughTheBackIsThatOfTheUnwornJoint) {
  JointSpec roller{.geometry = JointGeometry::pin(0.01, 1e-5, 0.02),
                   .inner = Material{2.1e11, 0.3},
                   .outer = Material{1.1e11, 0.34},
                   .friction = FrictionLaw(0.1)};
  roller.loading = InnerLoading::back(20 * degree);
  roller.half_angle_law = roller.pressure_law = "exact";
  const auto notes = [&] {
    return wear_in(swing(5e3, JointBody::carrier), roller.contact(), {1e-16}, 1)
        .notes;
  };
  ASSERT_EQ(notes().size(), 1u);
  EXPECT_EQ(notes()[0],
            "the contact is worn step by step under a force at the centre: "
            "loading back:20 is used for the unworn joint only");
  roller.loading = InnerLoading::centre();
  EXPECT_TRUE(notes().empty());
}

TEST(WearIn, DepthBesideTheRadius) {
  const auto wear = [](double k, double cycles) {
    return wear_in(steady(), pin(1e11, 0.1), {k}, cycles);
  };
  // 1.6e-7 J/m of volume in a cycle: over the projected area 0.08 um.
  EXPECT_TRUE(wear(1e-13, 1e4).notes.empty());
  const WearIn deep = wear(1e-13, 3e5);
  ASSERT_EQ(deep.notes.size(), 1u);
  EXPECT_NE(deep.notes[0].find("is more than a tenth of the radius, 20 mm"),
            std::string::npos)
      << deep.notes[0];
  EXPECT_EQ(error_message([&] {
              wear(1e-13, 1e9);
            }).find("the depth of the wear after "),
            0u);
  // Beyond all numbers.
  for (const double k : {1e-9, 1e21, 1e300}) {
    const std::string message = error_message([&] { wear(k, 1e15); });
    EXPECT_TRUE(message.ends_with("must be at most 20 mm, the radius"))
        << message;
  }
}

TEST(WearIn, CoefficientsOfBearings) {
  for (const double k : {0., 1e-19, 1e-15, 1e-12}) {
    EXPECT_EQ(WearMap::coefficient_note(k), "") << k;
  }
  for (const double k : {1e-9, 1.1e-12, 0.9e-19}) {
    EXPECT_NE(WearMap::coefficient_note(k).find(
                  "is outside the range of bearings, 1e-10 to 0.001 mm^3"),
              std::string::npos)
        << WearMap::coefficient_note(k);
  }
  EXPECT_TRUE(WearMap::coefficient_note(1e-6).starts_with(
      "the wear coefficient 1000 mm^3/(N m), 1e-06 m^2/N, is"));
  EXPECT_EQ(wear_in(steady(), pin(1e11, 0.1), {1e-20}, 1).notes.size(), 1u);
}

// Wear beyond a tenth of the overlap in one cycle proceeds by whole cycles.
TEST(WearIn, BlocksHaveACycleAtLeast) {
  const WearIn wear = wear_in(steady(), pin(1e11, 0.1, 1.7), {1e-11}, 5.5);
  ASSERT_GT(wear.states.size(), 2u);
  for (std::size_t i = 1; i + 1 < wear.states.size(); ++i) {
    EXPECT_GE(wear.states[i].cycles - wear.states[i - 1].cycles, 1) << i;
  }
  EXPECT_EQ(wear.states[1].cycles, 1);
  EXPECT_EQ(wear.states.back().cycles, 5.5);
}

TEST(WearIn, Messages) {
  const auto message = [](double k, double cycles, double modulus) {
    return error_message(
        [&] { wear_in(steady(), pin(modulus, 0.1, 1.7), {k}, cycles); });
  };
  EXPECT_EQ(message(-1, 1, 1e11),
            "wear: coefficient = -1 must be 0 m^2/N or above and finite");
  EXPECT_EQ(message(1, -1, 1e11),
            "wear: cycles = -1 must be 0 or above and finite");
  EXPECT_TRUE(message(1e-15, 1, 1e5).ends_with("must be at most 90 deg"))
      << message(1e-15, 1, 1e5);
}

}  // namespace
}  // namespace contact::test::wear_in_test
