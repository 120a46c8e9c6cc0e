// Whole runs of hinge-separation against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <string>

#include "libcontact/base/units.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/output/summary.hpp"
#include "separation/record/run_case.hpp"

namespace {

using Eigen::Vector3d;
using separation::Case;
using separation::Outcome;
using separation::parse_case;
using separation::Rows;
using separation::run_case;

constexpr double degree = contact::degree;
const std::string pin_joint = CONTACT_DATA_DIR "/joints/pin_joint.toml";

double value(const Rows& rows, std::size_t row, const std::string& column) {
  return rows.at(row, rows.column(column));
}

// NAMEx_UNIT, NAMEy_UNIT and NAMEz_UNIT.
Vector3d vector(const Rows& rows, std::size_t row, const std::string& name,
                const std::string& unit) {
  return {value(rows, row, name + "x_" + unit),
          value(rows, row, name + "y_" + unit),
          value(rows, row, name + "z_" + unit)};
}

// A balanced wheel of 20 kg and 2 kg m^2 on a horizontal pin along y, on a
// carrier that is turned and held. Its reaction is its weight, so the friction
// moment on it is constant, against its turn.
Case wheel() {
  return parse_case(R"(
name = "wheel"
gravity_m_per_s2 = [0, 0, -10]
run = { end_time_s = 0.5, output_step_s = 0.01 }
[carrier]
name = "base"
mass_kg = 100
principal_inertia_kg_m2 = [1, 1, 1]
start = { rotation_deg = [0, 0, 90] }
drive = { acceleration_m_per_s2 = [0, 0, 0] }
[[body]]
name = "wheel"
mass_kg = 20
principal_inertia_kg_m2 = [2, 3, 3]
start = { angle_deg = 20, rate_deg_per_s = 200 }
[body.hinge]
kind = "axis"
axis = [1, 0, 0]
carrier_point_m = [1, 2, 3]
zero_rotation_deg = [10, 0, 0]
[[body.hinge.joint]]
file = ")" + pin_joint + "\"\n",
                    "c.toml");
}

TEST(HistoryVectors, ActOnTheBodyAndStandInInertialAxes) {
  const Outcome outcome = run_case(wheel(), {});
  ASSERT_EQ(outcome.failure, "");
  const Rows& rows = outcome.memory.rows;
  const double first = value(rows, 0, "wheel.friction_moment_N_m");
  ASSERT_GT(first, 0.3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_GT(value(rows, i, "wheel.rate_deg_per_s"), 0);
    // To rounding and the tolerance of the outer loop.
    const Vector3d force = vector(rows, i, "wheel.reaction_", "N");
    EXPECT_LE((force - Vector3d(0, 0, 200)).norm(), 200e-12) << force;
    const Vector3d moment = vector(rows, i, "wheel.friction_moment_", "N_m");
    EXPECT_LE((moment - Vector3d(0, -first, 0)).norm(), 1e-9 * first) << moment;
  }
}

// What friction takes out of the motion is positive.
TEST(FrictionWork, IsPositiveAndWhatTheMotionLoses) {
  const Case c = wheel();
  const Outcome outcome = run_case(c, {});
  const Rows& rows = outcome.memory.rows;
  const double moment = value(rows, 0, "wheel.friction_moment_N_m");
  const auto turned = [&](std::size_t row) {
    return (value(rows, row, "wheel.angle_deg") - 20) * degree;
  };
  double before = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double work = value(rows, i, "wheel.friction_work_J");
    EXPECT_GT(work, before);
    before = work;
    // To the tolerance of the steps, 1e-8 for angles.
    EXPECT_NEAR(work, moment * turned(i), 1e-8 * moment);
    EXPECT_NEAR(
        work,
        value(rows, 0, "energy.kinetic_J") - value(rows, i, "energy.kinetic_J"),
        1e-8 * moment);
    EXPECT_EQ(work, value(rows, i, "energy.dissipated_J"));
  }
  EXPECT_EQ(separation::summary(c, outcome)["bodies"][0]["work_of_friction_J"],
            before);
}

TEST(HistoryVectors, HaveTheLengthsOfTheOtherColumns) {
  for (const std::string name : {"soyuz", "platform"}) {
    Case c = separation::read_case(CONTACT_DATA_DIR "/cases/" + name + ".toml");
    c.clearance.clear();
    const Outcome outcome = run_case(c, {});
    const Rows& rows = outcome.memory.rows;
    double largest_lock = 0;
    for (const separation::Body& body : c.bodies) {
      const std::string column = separation::column_name(body.rigid.name);
      const auto expect_length = [&](std::size_t row, const std::string& what,
                                     const std::string& unit) {
        const double length = value(rows, row, column + what + "_" + unit);
        EXPECT_NEAR(vector(rows, row, column + what + "_", unit).norm(), length,
                    1e-13 * length);
        return length;
      };
      for (std::size_t i = 0; i < rows.size(); ++i) {
        expect_length(i, ".reaction", "N");
        expect_length(i, ".friction_moment", "N_m");
        largest_lock =
            std::max(largest_lock, expect_length(i, ".lock_reaction", "N"));
      }
    }
    EXPECT_GT(largest_lock, 0) << name;
  }
}

// A stone alone in space, and two of them: thrown, pushed and turning about a
// principal axis.
TEST(WithoutHinges, BodiesFlyOnParabolas) {
  const std::string file = R"(
name = "stones"
gravity_m_per_s2 = [0, 0, -10]
run = { end_time_s = 2 }
[carrier]
name = "stone"
mass_kg = 2
principal_inertia_kg_m2 = [1, 2, 3]
[carrier.start]
velocity_m_per_s = [1, 2, 3]
angular_velocity_rad_per_s = [0, 0, 0.3]
[[force]]
name = "push"
body = "stone"
kind = "applied"
axes = "inertial"
force_N = [0, 4, 0]
)";
  const std::string other = R"(
[[body]]
name = "other"
mass_kg = 5
principal_inertia_kg_m2 = [1, 1, 1]
start = { position_m = [9, 0, 0], velocity_m_per_s = [0, 1, 0] }
)";
  for (const std::string& more : {std::string(), other}) {
    const Case c = parse_case(file + more, "c.toml");
    const Outcome outcome = run_case(c, {});
    ASSERT_EQ(outcome.failure, "");
    const Rows& rows = outcome.memory.rows;
    const std::size_t last = rows.size() - 1;
    EXPECT_EQ(last, 200U);
    const auto place = [&](const std::string& body) {
      return vector(rows, last, body + ".", "m");
    };
    // Parabolas are exact but for rounding.
    EXPECT_LE((place("stone") - Vector3d(2, 8, -14)).norm(), 1e-12);
    EXPECT_NEAR(2 * std::acos(value(rows, last, "stone.qw")), 0.6, 1e-8);
    EXPECT_LE(outcome.memory.largest_drift, 1e-8 * 300);
    EXPECT_EQ(separation::summary(c, outcome)["bodies"].size(),
              more.empty() ? 0U : 1U);
    if (more.empty()) continue;
    EXPECT_LE((place("other") - Vector3d(9, 2, -20)).norm(), 1e-12);
  }
}

}  // namespace
