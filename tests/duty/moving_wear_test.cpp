// Wear under loads that move in the hole: against wear step by step
// (scripts/moving_wear.py), and exact results.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "duty/worn_pin_clearance.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/duty/steps/worn_circle.hpp"
#include "libcontact/duty/steps/worn_sphere.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/joint/spec.hpp"
#include "libcontact/pressure/exact.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::moving_wear_test {
namespace {

using detail::WornCircle;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double length = 0.05;
constexpr double weak = 1e-6;  // friction

JointContact contact_of(double radius, double clearance,
                        const Material& material) {
  const ElasticPair pair(material, material);
  return {JointGeometry::pin(radius, clearance, length), pair,
          FrictionLaw(weak), std::make_shared<ExactLaw>(JointKind::pin, pair),
          std::make_shared<ExactPressure>(JointKind::pin, pair)};
}

// The body, which has the hole, swings or turns under a load that the carrier
// holds.
DutyCycle swing(double force, double amplitude, bool with_load = false) {
  constexpr int rows = 40;
  std::vector<double> times;
  std::vector<Vector3d> angles;
  for (int i = 0; i < rows; ++i) {
    times.push_back(double(i) / rows);
    angles.emplace_back(amplitude * std::sin(2 * pi * i / rows), 0, 0);
  }
  return {{times, std::vector<Vector3d>(rows, {0, -force, 0}), angles, 1},
          {JointBody::body, with_load ? JointBody::body : JointBody::carrier},
          DutyCycle::TurnSequence("z")};
}
DutyCycle turning(double force) {
  const std::vector<double> times = {0, 0.25, 0.5, 0.75};
  return {{times, std::vector<Vector3d>(4, {0, -force, 0}),
           std::vector<Vector3d>(4, {0, 0, 2 * pi}), 1},
          {}};
}

WornCircle::Contact pressed(const WornCircle& circle, double load,
                            double direction, double clearance,
                            const std::vector<double>& depths) {
  const Eigen::VectorXd gap =
      Eigen::Map<const Eigen::VectorXd>(depths.data(), circle.size()).array() +
      clearance;
  return circle.press(load * Vector2d(std::cos(direction), std::sin(direction)),
                      gap);
}

TEST(MovingWear, OfASwingMatchesWearStepByStep) {
  const ReferenceTable table("duty/moving_wear.csv");
  // Places that take turns leave ripples in the worn shape, which pressures
  // feel; the volume and the depth do not.
  AccuracyReport half_angle("half-angle, of 1 deg", 0.8);
  AccuracyReport peak("peak", 0.04);
  AccuracyReport ratio("S", 4e-3);
  AccuracyReport depth("depth", 2e-3);
  AccuracyReport area("worn area", 1e-3);
  for (const ReferenceTable::Row row : table) {
    const double radius = row.value("rho");
    const double clearance = row.value("clearance");
    const Material material{row.value("E"), row.value("nu")};
    const double load = row.value("load");
    const double worn_out = row.value("sigma") * load / (radius * clearance);
    // A second a row: two of each load and swing.
    const bool is_taken =
        std::abs(worn_out - 0.3) < 0.01 || std::abs(worn_out - 3) < 0.1;
    if (row.value("amplitude_deg") == 0 || !is_taken) continue;
    const double amplitude = row.value("amplitude_deg") * degree;
    const JointContact contact = contact_of(radius, clearance, material);
    constexpr double cycles = 1e6;
    const double k = row.value("sigma") / (cycles * radius * 4 * amplitude);
    const DutyCycle cycle = swing(load * length, amplitude);
    const WearIn worn = wear_in(cycle, contact, {.seat = k}, cycles);
    const WornCircle circle({radius, material, material});
    ASSERT_EQ(worn.worn.depths.size(), std::size_t(circle.size()));
    for (const bool off : {false, true}) {
      // -Y of the body at rest.
      const double at = -pi / 2 + (off ? amplitude / 2 : 0);
      const auto now = pressed(circle, load, at, clearance, worn.worn.depths);
      const std::string end = off ? "_off" : "";
      const std::string label = row.label() + end;
      half_angle.add_error(std::abs(now.half_angle / degree -
                                    row.value("theta0" + end + "_deg")),
                           label);
      peak.add(now.pressure.maxCoeff(), row.value("p_max" + end), label);
      ratio.add(2 * pi * radius * now.pressure.mean() / load,
                row.value("S" + end), label);
    }
    depth.add(worn.states.back().penetration, row.value("depth"), row.label());
    area.add(worn.states.back().volume / length, row.value("area"),
             row.label());
  }
}

// Under a stationary load the steps follow the rigid limit, k P s/(rho eps) =
// theta0/cos theta0 - sin theta0, if elasticity is small: without wear the
// half-angle would be 5 deg. The depth follows eps (1/cos - 1).
TEST(MovingWear, AtRestItIsTheRigidLimit) {
  const double radius = 0.02;
  const double clearance = 4e-5;
  const double load = 8e5;
  const double swung = 20 * degree;
  const JointContact contact = contact_of(radius, clearance, {5e12, 0.3});
  const DutyCycle cycle = swing(load * length, swung, true);
  const WornSeat nothing;
  for (const double theta0_deg : {35.0, 50.0, 65.0, 75.0}) {
    const double theta0 = theta0_deg * degree;
    const double sigma = radius * clearance / load *
                         (theta0 / std::cos(theta0) - std::sin(theta0));
    const WearIn worn =
        wear_in(cycle, contact, {.seat = sigma / (1e6 * radius * 4 * swung)},
                1e6, &nothing);
    const double depth = worn.states.back().penetration;
    EXPECT_NEAR(std::acos(clearance / (clearance + depth)) / degree, theta0_deg,
                0.1);
    EXPECT_NEAR(worn.states.back().half_angle / degree, theta0_deg, 0.5);
  }
}

// The hole rotates under the load and wears uniformly: it stays round, and its
// clearance grows exactly as for a pin that wears alone.
TEST(MovingWear, OfAHoleThatTurnsRoundIsExact) {
  const double radius = 0.02;
  const double force = 4e4;
  const JointContact contact = contact_of(radius, 4e-5, {1e11, 0.3});
  for (const double sigma : {1e-13, 1e-12, 1e-11}) {
    const double k = sigma / (1e6 * 2 * pi * radius);
    const WearIn worn = wear_in(turning(force), contact, {.seat = k}, 1e6);
    const LoadedPath path{force, sigma};
    const double clearance = clearance_of_worn_pin(contact, {&path, 1}, 1);
    const WearIn::State& last = worn.states.back();
    const double half_angle =
        contact.with_clearance(clearance).half_angle(force).half_angle;
    EXPECT_NEAR(last.clearance, clearance, 3e-3 * clearance);
    EXPECT_NEAR(last.half_angle / degree, half_angle / degree, 0.5);
  }
}

LayeredPair pair_of(const ReferenceTable::Row& row) {
  return {row.value("rho"),
          {{}, Backing::rigid()},
          {{{row.value("t"), {row.value("E"), row.value("nu")}}},
           Backing::rigid()}};
}

// A thin liner on something rigid, which is nearly a bed of springs.
JointContact lined_ball(const ReferenceTable::Row& row) {
  const JointSpec spec{
      .geometry = JointGeometry::ball(row.value("rho"), row.value("clearance")),
      .inner = {{}, Backing::rigid()},
      .outer = {{{row.value("t"), {row.value("E"), row.value("nu")}}},
                Backing::rigid()},
      .friction = FrictionLaw(weak)};
  return spec.contact();
}

// The gap at the cells of a worn seat.
Eigen::MatrixXd gap_of(const WornSeat& worn, const detail::WornSphere& sphere,
                       double clearance) {
  return Eigen::Map<const Eigen::MatrixXd>(
             worn.depths.data(), sphere.latitudes(), sphere.longitudes())
             .array() +
         clearance;
}

TEST(MovingWear, OfABallMatchesWearStepByStep) {
  const ReferenceTable table("duty/moving_ball_wear.csv");
  // Limits for cells of 4 deg; 0.42 deg and 2.5 % were seen.
  AccuracyReport half_angle("half-angle, of 1 deg", 0.5);
  AccuracyReport peak("peak", 0.03);
  AccuracyReport ratio("S", 5e-3);
  AccuracyReport depth("depth", 0.01);
  AccuracyReport volume("worn volume", 2e-3);
  for (const ReferenceTable::Row row : table) {
    const double path = row.value("path");
    if (path != 3e-13 && path != 3e-12) continue;  // two seconds a row
    const JointContact contact = lined_ball(row);
    const double radius = row.value("rho");
    const double load = row.value("load");
    const double amplitude = row.value("amplitude_deg") * degree;
    const bool moves = amplitude > 0;
    constexpr double cycles = 1e6;
    const double swung = moves ? amplitude : 10 * degree;
    const double k = path / (cycles * radius * 4 * swung);
    const WornSeat nothing;
    const WearIn worn =
        wear_in(swing(load, swung, !moves), contact, {.seat = k}, cycles,
                moves ? nullptr : &nothing);
    const detail::WornSphere sphere(pair_of(row), worn.worn.pole,
                                    worn.worn.reach);
    ASSERT_EQ(worn.worn.depths.size(),
              std::size_t(sphere.latitudes() * sphere.longitudes()));
    const Eigen::MatrixXd gap =
        gap_of(worn.worn, sphere, row.value("clearance"));
    for (const bool off : {false, true}) {
      const double at = off ? amplitude / 2 : 0;
      const auto now =
          sphere.press(load * Vector3d(std::sin(at), -std::cos(at), 0), gap);
      EXPECT_EQ(now.status, Status::ok);
      const std::string end = off ? "_off" : "";
      const std::string label = row.label() + end;
      double sum = 0;
      for (int i = 0; i < sphere.latitudes(); ++i) {
        for (int j = 0; j < sphere.longitudes(); ++j) {
          sum += now.pressure(i, j) * sphere.area(i) *
                 sphere.point(i, j).head<2>().norm();
        }
      }
      half_angle.add_error(std::abs(now.half_angle / degree -
                                    row.value("theta0" + end + "_deg")),
                           label);
      peak.add(now.pressure.maxCoeff(), row.value("p_max" + end), label);
      ratio.add(sum / load, row.value("S" + end), label);
    }
    depth.add(worn.states.back().penetration, row.value("depth"), row.label());
    volume.add(worn.states.back().volume, row.value("volume"), row.label());
  }
}

DutyCycle hip_cycle() {
  const ReferenceTable table("duty/cycle_hip_in.csv");
  DutyCycle::Rows rows;
  for (const ReferenceTable::Row row : table) {
    rows.times.push_back(row.value("time_s"));
    rows.forces.emplace_back(row.value("R_x_N"), row.value("R_y_N"),
                             row.value("R_z_N"));
    rows.motion.push_back(Vector3d(row.value("flexion_deg"),
                                   row.value("adduction_deg"),
                                   row.value("internal_rotation_deg")) *
                          degree);
  }
  rows.period = 1;
  return {rows, {}, DutyCycle::TurnSequence("zxy")};
}

// The half-angle is the same on all grids and with all blocks; the rigid limit
// has 76.78 deg and 7.43 MPa.
TEST(MovingWear, OfAHipHasTheLimitOfFinerSteps) {
  const std::filesystem::path data = CONTACT_DATA_DIR;
  const JointContact contact =
      read_joint(data / "reference/duty/cycle_hip.toml").contact();
  const WearIn::State worn =
      wear_in(hip_cycle(), contact, {.seat = 1e-15}, 5e6).states.back();
  const ReferenceTable table("duty/hip_wear.csv");
  const ReferenceTable::Row limit = *table.begin();
  ASSERT_EQ(limit.value("step_deg"), 0);
  EXPECT_NEAR(worn.half_angle / degree, limit.value("theta0_deg"), 0.1);
  EXPECT_NEAR(worn.penetration * 1e3 / limit.value("depth_mm"), 1, 3e-3);
  EXPECT_NEAR(worn.volume * 1e9 / limit.value("volume_mm3"), 1, 3e-3);
}

// Against scripts/hip_wear.py, another contact and another way through the
// cycle. Its rows of spacing 0 are good to 0.2 deg; a contact that is worn
// little is shown too narrow, see below.
TEST(MovingWear, OfAHipMatchesWearStepByStep) {
  const std::filesystem::path data = CONTACT_DATA_DIR;
  const JointContact contact =
      read_joint(data / "reference/duty/cycle_hip.toml").contact();
  const LayeredPair pair{contact.geometry().radius(), contact.pair().inner(),
                         contact.pair().outer()};
  const ReferenceTable table("duty/hip_wear_steps.csv");
  AccuracyReport half_angle("half-angle, of 1 deg", 0.3);
  AccuracyReport at_first("half-angle at first, of 1 deg", 0.4);
  AccuracyReport peak("peak", 0.01);
  AccuracyReport depth("depth", 5e-3);
  AccuracyReport volume("worn volume", 5e-3);
  for (const ReferenceTable::Row row : table) {
    const double cycles = row.value("cycles");
    if (row.value("spacing_deg") != 0 || cycles == 0) continue;
    const WearIn worn = wear_in(hip_cycle(), contact, {.seat = 1e-15}, cycles);
    const detail::WornSphere sphere(pair, worn.worn.pole, worn.worn.reach);
    ASSERT_EQ(worn.worn.depths.size(),
              std::size_t(sphere.latitudes() * sphere.longitudes()));
    const Eigen::MatrixXd gap =
        gap_of(worn.worn, sphere, contact.geometry().radial_clearance());
    const auto now = sphere.press(
        {row.value("load_x_N"), row.value("load_y_N"), row.value("load_z_N")},
        gap);
    EXPECT_EQ(now.status, Status::ok);
    (cycles < 1e6 ? at_first : half_angle)
        .add_error(std::abs(now.half_angle / degree - row.value("theta0_deg")),
                   row.label());
    peak.add(now.pressure.maxCoeff(), row.value("p_peak_Pa"), row.label());
    depth.add(worn.states.back().penetration * 1e3, row.value("depth_mm"),
              row.label());
    volume.add(worn.states.back().volume * 1e9, row.value("volume_mm3"),
               row.label());
  }
}

// Without wear the half-angle is known: what cells of 4 deg show of it depends
// on where the load is among them.
TEST(MovingWear, CellsShowAFreshBall) {
  const std::filesystem::path data = CONTACT_DATA_DIR;
  const JointContact contact =
      read_joint(data / "reference/duty/cycle_hip.toml").contact();
  const JointGeometry& geometry = contact.geometry();
  const ElasticPair& pair = contact.pair();
  const JointContact exact{
      geometry, pair, FrictionLaw(weak),
      std::make_shared<ExactLaw>(JointKind::ball, pair),
      std::make_shared<ExactPressure>(JointKind::ball, pair)};
  const detail::WornSphere sphere(
      {geometry.radius(), pair.inner(), pair.outer()}, Vector3d::UnitX(),
      pi / 2);
  const Eigen::MatrixXd gap = Eigen::MatrixXd::Constant(
      sphere.latitudes(), sphere.longitudes(), geometry.radial_clearance());
  AccuracyReport half_angle("half-angle, of 1 deg", 0.8);
  for (const double load : {300.0, 1500.0, 3000.0}) {
    for (const double off_deg : {0.0, 1.0, 2.0, 4.0, 8.0}) {
      const double off = off_deg * degree;
      const auto now =
          sphere.press(load * Vector3d(std::cos(off), std::sin(off), 0), gap);
      half_angle.add_error(
          std::abs(now.half_angle - exact.half_angle(load).half_angle) / degree,
          std::to_string(load) + " N, off by " + std::to_string(off_deg));
    }
  }
}

}  // namespace
}  // namespace contact::test::moving_wear_test
