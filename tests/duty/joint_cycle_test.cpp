// Duty cycles and wear maps against data/reference/duty/.
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/periodic_spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/pressure/factory.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/reference_table.hpp"

namespace contact::test::joint_cycle_test {
namespace {

using Eigen::Vector3d;

using Columns = std::vector<std::string>;
constexpr double mm = 1e-3;

std::vector<Vector3d> vectors(const ReferenceTable& table,
                              const Columns& columns, double unit = 1) {
  std::vector<Vector3d> all;
  for (const ReferenceTable::Row row : table) {
    Vector3d& v = all.emplace_back(Vector3d::Zero());
    for (std::size_t k = 0; k < columns.size(); ++k) {
      v[static_cast<int>(k)] = unit * row.value(columns[k]);
    }
  }
  return all;
}

const Columns force_columns = {"R_x_N", "R_y_N", "R_z_N"};
const Columns rate_columns = {"w_x_rad_per_s", "w_y_rad_per_s",
                              "w_z_rad_per_s"};

// A cycle of the reference data: "hip" or "pin".
struct Reference {
  explicit Reference(const std::string& name)
      : in("duty/cycle_" + name + "_in.csv"),
        states("duty/cycle_" + name + "_states.csv"),
        map("duty/cycle_" + name + "_map.csv"),
        spec(read_joint(std::filesystem::path(CONTACT_DATA_DIR) / "reference" /
                        "duty" / ("cycle_" + name + ".toml"))),
        joint(spec.contact()) {
    const ReferenceTable table("duty/cycle_" + name + "_summary.csv");
    for (const ReferenceTable::Row row : table) {
      summary[row.text("quantity")] = row.value("value");
    }
    for (const ReferenceTable::Row row : in) {
      times.push_back(row.value("time_s"));
    }
  }

  DutyCycle::Rows rows(std::vector<Vector3d> forces,
                       std::vector<Vector3d> motion) const {
    return {times, std::move(forces), std::move(motion),
            summary.at("period_s")};
  }
  DutyCycle cycle(DutyCycle::ForceFrame frame = {}) const {
    const bool pin = spec.geometry.kind() == JointKind::pin;
    const Columns angles =
        pin ? Columns{"angle_deg"}
            : Columns{"flexion_deg", "adduction_deg", "internal_rotation_deg"};
    return {rows(vectors(in, force_columns), vectors(in, angles, degree)),
            frame, DutyCycle::TurnSequence(pin ? "z" : "zxy")};
  }
  JointCycle run(const DutyCycle& duty) const { return {duty, joint}; }

  ReferenceTable in;
  ReferenceTable states;
  ReferenceTable map;
  JointSpec spec;
  Joint joint;
  std::map<std::string, double> summary;
  std::vector<double> times;
};

class Cycles : public testing::TestWithParam<const char*> {
 protected:
  const Reference reference_{GetParam()};
  const DutyCycle duty_ = reference_.cycle();
  const JointCycle cycle_ = reference_.run(duty_);
};

TEST_P(Cycles, States) {
  AccuracyReport numbers("R_n, theta0, heat, peaks, totals", 1e-11);
  AccuracyReport directions("Dw, n, M_t over their lengths", 1e-11);
  const ReferenceTable& states = reference_.states;
  ASSERT_EQ(cycle_.rows().size(), states.size());
  auto instant = cycle_.rows().begin();
  for (const ReferenceTable::Row row : states) {
    const JointCycle::Instant& i = *instant++;
    const SlidingContact sliding = cycle_.sliding(i);
    const std::string label = row.label();
    const auto vector = [&](const char* x, const char* y, const char* z) {
      return Vector3d(row.value(x), row.value(y), row.value(z));
    };
    const auto add = [&](const Vector3d& computed, const Vector3d& expected) {
      directions.add_error((computed - expected).norm() / expected.norm(),
                           label);
    };
    add(i.state.angular_velocity,
        vector("w_x_rad_per_s", "w_y_rad_per_s", "w_z_rad_per_s"));
    add(i.solution.normal, vector("n_x", "n_y", "n_z"));
    add(i.solution.friction_moment, vector("M_x_N_m", "M_y_N_m", "M_z_N_m"));
    numbers.add(i.solution.normal_force, row.value("R_n_N"), label);
    numbers.add(i.solution.half_angle / degree, row.value("theta0_deg"), label);
    numbers.add(sliding.heat(), row.value("heat_W"), label);
    numbers.add(i.solution.peak_pressure, row.value("p_peak_Pa"), label);
    numbers.add(sliding.largest_pv().value, row.value("pv_max_W_per_m2"),
                label);
    numbers.add(sliding.largest_heat_flux().value,
                row.value("heat_max_W_per_m2"), label);
    numbers.add(sliding.pv_total(), row.value("pv_total_W"), label);
  }
}

TEST_P(Cycles, Summary) {
  const auto& summary = reference_.summary;
  const double rho = reference_.spec.geometry.radius();
  const auto moment = [](const JointCycle::Instant& i) {
    return i.solution.friction_moment.norm();
  };
  // Tolerance of the data. |M_t| turns quickly where a ball is slow: 2e-7 with
  // four nodes to an interval in place of eight.
  AccuracyReport integrals("integrals", 1e-9);
  const double period = summary.at("period_s");
  integrals.add(cycle_.integral([](const JointCycle::Instant& i) {
    return -i.solution.power;
  }),
                summary.at("energy_J"), "energy");
  integrals.add(cycle_.integral([&](const JointCycle::Instant& i) {
    return rho * i.state.angular_velocity.norm() *
           cycle_.sliding(i).slip_coefficient();
  }),
                summary.at("sliding_distance_m"), "sliding distance");
  integrals.add(cycle_.integral([&](const JointCycle::Instant& i) {
    return cycle_.sliding(i).pv_total();
  }),
                summary.at("pv_integral_J"), "p v");
  integrals.add(cycle_.integral(moment) / period, summary.at("mean_moment_N_m"),
                "mean moment");

  AccuracyReport largest("largest", 1e-8);
  const auto check = [&](const JointCycle::Quantity& quantity, const char* name,
                         const char* time) {
    const JointCycle::Instant i = cycle_.largest(quantity);
    largest.add(quantity(i), summary.at(name), name);
    if (time != nullptr) {
      EXPECT_NEAR(i.time, summary.at(time), 1e-5) << name;
    }
  };
  check(moment, "max_moment_N_m", "time_of_max_moment_s");
  check([](const JointCycle::Instant& i) { return i.solution.peak_pressure; },
        "p_peak_max_Pa", "time_of_p_peak_max_s");
  check(
      [&](const JointCycle::Instant& i) {
        return cycle_.sliding(i).largest_pv().value;
      },
      "pv_max_W_per_m2", "time_of_pv_max_s");
}

TEST_P(Cycles, WearMap) {
  const ReferenceTable& map = reference_.map;
  const bool pin = reference_.spec.geometry.kind() == JointKind::pin;
  // Tolerance of the data. The contact's edge passes a point with a kink: 2e-5
  // of a hip with four nodes to an interval in place of eight.
  AccuracyReport depth("p v over the time, of its largest", 1e-5);
  AccuracyReport shear("cross-shear, away from the edges of wear", 1e-4);
  const auto& summary = reference_.summary;
  for (const JointBody body : {JointBody::carrier, JointBody::body}) {
    const std::string name = body == JointBody::body ? "body" : "carrier";
    const bool inner = body == reference_.spec.geometry.inner_body();
    const double k =
        summary.at(inner ? "k_inner_mm3_per_N_m" : "k_seat_mm3_per_N_m");
    const WearMap wear(cycle_, body);
    const double largest =
        summary.at("max_depth_" + name + "_mm") / (k * mm * mm);
    for (const ReferenceTable::Row row : map) {
      if (row.text("body") != name) continue;
      const double beta = pin ? row.value("beta_deg") * degree : 0;
      const Vector3d point =
          pin ? Vector3d(std::cos(beta), std::sin(beta), 0)
              : Vector3d(row.value("x"), row.value("y"), row.value("z"));
      const WearMap::Wear w = wear.at(point);
      depth.add_error(std::abs(w.pv - row.value("pv_integral_Pa_m")) / largest,
                      row.label());
      if (!pin && w.pv > 0.1 * largest) {
        shear.add_error(std::abs(w.cross_shear - row.value("cross_shear")),
                        row.label());
      }
    }
    const int count = 2000;
    const std::vector<Vector3d> grid = wear.grid(count);
    std::vector<WearMap::Wear> worn;
    for (const Vector3d& point : grid) worn.push_back(wear.at(point));
    EXPECT_LT(std::abs(wear.volume_defect(worn)), 2. / count) << name;
    const WearMap::Deepest deepest = wear.deepest(grid, worn);
    depth.add(deepest.wear.pv, largest, name + ", the largest");
    if (pin) {
      EXPECT_NEAR(std::atan2(deepest.point.y(), deepest.point.x()) / degree,
                  summary.at("max_depth_" + name + "_beta_deg"), 0.3);
    } else {
      // Flat there.
      const Vector3d place(summary.at("max_depth_" + name + "_x"),
                           summary.at("max_depth_" + name + "_y"),
                           summary.at("max_depth_" + name + "_z"));
      EXPECT_LT((deepest.point - place).norm(), 1e-3) << name;
    }
  }
  if (pin) shear.may_be_empty();
}

// Components of the moment have their largest values between the rows: never
// below a fine grid, and equal to it within its steps.
TEST_P(Cycles, LargestMomentsByAxis) {
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {-1, 1}) {
      const auto moment = [&](const JointCycle::Instant& i) {
        return sign * i.solution.friction_moment[k];
      };
      const double largest = moment(cycle_.largest(moment));
      double rows = moment(cycle_.rows()[0]);
      double grid = rows;
      for (const JointCycle::Instant& row : cycle_.rows()) {
        rows = std::max(rows, moment(row));
      }
      const double period = duty_.period();
      for (int i = 0; i < 20000; ++i) {
        grid = std::max(grid, moment(cycle_.at(i * period / 20000)));
      }
      const double size = std::abs(grid) + 1e-12;
      EXPECT_GE(largest, rows) << k;
      // Beside a reversal of the pin the largest is between two of the grid,
      // which miss 6e-6.
      EXPECT_NEAR(largest / size, grid / size, 1e-5) << k << ' ' << sign;
      EXPECT_GE(largest, grid - 1e-8 * size) << k << ' ' << sign;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Cycles, testing::Values("hip", "pin"));

// Angles and the rates that they have are one motion.
TEST(DutyCycle, RatesAreTheTurnsDerivative) {
  for (const char* sequence : {"zxy", "xyz", "zyz"}) {
    const DutyCycle::TurnSequence turns(sequence);
    const Vector3d angles(0.4, -0.3, 0.2);
    const Vector3d rate(1, 2, -3);
    const double h = 1e-4;
    const Eigen::Matrix3d change =
        (turns.turn(angles + h * rate).toRotationMatrix() -
         turns.turn(angles - h * rate).toRotationMatrix()) /
        (2 * h) * turns.turn(angles).toRotationMatrix().transpose();
    const Vector3d expected(change(2, 1), change(0, 2), change(1, 0));
    // h^2/6 of a third derivative of some 50.
    EXPECT_LT((turns.angular_velocity(angles, rate) - expected).norm(), 1e-6)
        << sequence;
  }
}

// Uses Dw of the states as input: the energy agrees within the error of the
// spline through rates, and the turn closes.
TEST(DutyCycle, OfRates) {
  const Reference hip("hip");
  const DutyCycle duty(hip.rows(vectors(hip.in, force_columns),
                                vectors(hip.states, rate_columns)),
                       {});
  // A spline of rates is not the derivative of a spline of angles: 1e-6 was
  // seen.
  EXPECT_LT(duty.closure(), 1e-5);
  EXPECT_NEAR(hip.run(duty).integral([](const JointCycle::Instant& i) {
    return -i.solution.power;
  }) / hip.summary.at("energy_J"),
              1, 1e-5);
  const DutyCycle angles = hip.cycle();
  const Eigen::Quaterniond first = angles.at(0).turn;
  for (const double time : {0.1234, 0.5, 0.987}) {
    EXPECT_LT(
        (duty.at(time).turn * first).angularDistance(angles.at(time).turn),
        1e-5);
  }
}

// A sine in 20 rows gives no note; jumping loads, turns that do not close, and
// a force along a pin give one. Angles that jump back after a turn are
// rejected.
TEST(DutyCycle, SaysWhatTheRowsDoNotHold) {
  DutyCycle::Rows rows{{}, {}, {}, 1.0};
  for (int i = 0; i < 20; ++i) {
    const double turn = 2 * std::numbers::pi * i / 20;
    rows.times.push_back(i / 20.0);
    rows.forces.emplace_back(100 * std::sin(turn), 500, 0);
    rows.motion.emplace_back(0.3 * std::sin(turn), 0, 0);
  }
  const DutyCycle::TurnSequence z("z");
  EXPECT_TRUE(DutyCycle(rows, {}, z).notes(true).empty());
  EXPECT_TRUE(DutyCycle(rows, {}, z).notes(false).empty());
  DutyCycle::Rows jumps = rows;
  for (int i = 0; i < 20; ++i) jumps.forces[i].x() = i < 10 ? 100 : 1e4;
  const auto said = DutyCycle(jumps, {}, z).notes(true);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(said[0].starts_with(
      "between the rows the force exceeds their range by 10.8 %"));
  // A load in one row alone: below the others only.
  for (int i = 0; i < 20; ++i) jumps.forces[i].x() = i == 3 ? 100 : 0;
  const auto below = DutyCycle(jumps, {}, z).notes(true);
  ASSERT_EQ(below.size(), 1u);
  EXPECT_TRUE(below[0].starts_with(
      "between the rows the force exceeds their range by 13.7 %"));
  DutyCycle::Rows axial = rows;
  axial.forces[3].z() = 7;
  EXPECT_EQ(DutyCycle(axial, {}, z).notes(false).size(), 0u);
  ASSERT_EQ(DutyCycle(axial, {}, z).notes(true).size(), 1u);
  EXPECT_NE(DutyCycle(axial, {}, z).notes(true)[0].find("up to 7 N"),
            std::string::npos);
  DutyCycle::Rows open = rows;
  for (Vector3d& rate : open.motion) rate += Vector3d(0, 0, 1);
  ASSERT_EQ(DutyCycle(open, {}).notes(false).size(), 1u);
  EXPECT_NE(DutyCycle(open, {}).notes(false)[0].find("than whole turns"),
            std::string::npos);
  DutyCycle::Rows turns = rows;
  for (int i = 0; i < 20; ++i) turns.motion[i].x() = 18 * i * degree;
  EXPECT_ERROR(DutyCycle(turns, {}, z),
               "change of angles of 342 deg from 0.95 s to 0 s must be at most "
               "180 deg: angles go on without a jump after a turn, and whole "
               "turns in a period need angular velocities");
}

// The same forces as the carrier's instruments would have them.
TEST(DutyCycle, FrameOfForces) {
  const Reference hip("hip");
  const DutyCycle plain = hip.cycle();
  std::vector<Vector3d> turned;
  for (const double time : hip.times) {
    const DutyCycle::State s = plain.at(time);
    turned.push_back(-(s.turn.conjugate() * s.reaction));
  }
  const DutyCycle duty(hip.rows(turned, vectors(hip.in,
                                                {"flexion_deg", "adduction_deg",
                                                 "internal_rotation_deg"},
                                                degree)),
                       {JointBody::carrier, JointBody::body},
                       DutyCycle::TurnSequence("zxy"));
  for (const double time : hip.times) {
    EXPECT_LT((duty.at(time).reaction - plain.at(time).reaction).norm(),
              1e-12 * plain.at(time).reaction.norm());
  }
}

// Twice as slow: half the power, the same wear.
TEST(DutyCycle, OfTwiceThePeriod) {
  Reference hip("hip");
  const DutyCycle fast = hip.cycle();
  const JointCycle one = hip.run(fast);
  for (double& time : hip.times) time *= 2;
  hip.summary["period_s"] *= 2;
  const DutyCycle slow = hip.cycle();
  const JointCycle two = hip.run(slow);
  const auto pv = [](const JointCycle& cycle) {
    return cycle.integral([&](const JointCycle::Instant& i) {
      return cycle.sliding(i).pv_total();
    });
  };
  EXPECT_NEAR(pv(two) / pv(one), 1, 1e-13);
  EXPECT_NEAR(two.rows()[7].solution.power / one.rows()[7].solution.power, 0.5,
              1e-13);
}

// A ball of 20 mm that swings about X under a constant force along Z: M_t is
// constant, and the energy is |M_t| times the integral of |Dw|. For a spline
// through few rows a sum of many thousand steps is accurate to 1e-9.
double swing_error(int rows, double across) {
  const ElasticPair pair({207e9, 0.3}, {111e9, 0.3});
  const Joint joint(
      JointContact(JointGeometry::ball(0.02, 4e-5), pair, FrictionLaw(0.1),
                   make_half_angle_law("tanh", JointKind::ball, pair),
                   make_pressure_law("cosine", JointKind::ball, pair)));
  std::vector<double> times;
  std::vector<Vector3d> turning;
  for (int i = 0; i < rows; ++i) {
    const double phase = 2 * std::numbers::pi * i / rows + 0.03;
    times.push_back(double(i) / rows);
    turning.emplace_back(2 * std::sin(phase), across * std::cos(phase), 0);
  }
  const PeriodicSpline rate(times, 1, turning);
  const DutyCycle duty(
      {times, std::vector<Vector3d>(rows, {0, 0, 2000}), turning, 1}, {});
  const JointCycle cycle(duty, joint);
  const double moment = cycle.rows()[1].solution.friction_moment.norm();
  constexpr int steps = 1 << 18;
  double distance = 0;
  for (int i = 0; i < steps; ++i) {
    distance += rate.value((i + 0.5) / steps).norm() / steps;
  }
  const double energy = cycle.integral(
      [](const JointCycle::Instant& i) { return -i.solution.power; });
  EXPECT_EQ(cycle.sums().energy, energy);
  return energy / (moment * distance) - 1;
}

TEST(JointCycle, ReversalsOfABall) {
  for (const int rows : {20, 50, 100}) {
    EXPECT_NEAR(swing_error(rows, 0), 0, 1e-9) << rows;
    // Nearly a reversal, from far within an interval to two of them.
    for (const double across : {1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.5}) {
      EXPECT_NEAR(swing_error(rows, across), 0, 1e-9) << rows << ' ' << across;
    }
  }
}

// No instant of 17,000 rows is kept, of 2100 the rows alone, of 100 all.
TEST(JointCycle, LongCyclesHaveTheSameNumbers) {
  for (const int rows : {100, 2100, 17'000}) {
    EXPECT_NEAR(swing_error(rows, 0), 0, 1e-9) << rows;
  }
}

// Every integral that is made with the cycle, and instants by place and time.
TEST_P(Cycles, SumsAreIntegrals) {
  using Instant = JointCycle::Instant;
  const JointCycle::Sums& sums = cycle_.sums();
  const double rho = reference_.spec.geometry.radius();
  const auto speed = [&](const Instant& i) {
    return rho * i.state.angular_velocity.norm();
  };
  const std::pair<double, JointCycle::Quantity> all[] = {
      {sums.energy, [](const Instant& i) { return -i.solution.power; }},
      {sums.sliding_path, speed},
      {sums.effective_distance,
       [&](const Instant& i) {
         return speed(i) * cycle_.sliding(i).slip_coefficient();
       }},
      {sums.pv, [&](const Instant& i) { return cycle_.sliding(i).pv_total(); }},
      {sums.moment,
       [](const Instant& i) { return i.solution.friction_moment.norm(); }}};
  for (const auto& [sum, quantity] : all) {
    EXPECT_GT(sum, 0);
    EXPECT_EQ(sum, cycle_.integral(quantity));
  }
  for (std::size_t i = 0; i < cycle_.rows().size(); ++i) {
    const Instant row = cycle_.rows()[i];
    EXPECT_EQ(row.weight, 0);
    EXPECT_EQ(row.time, duty_.times()[i]);
    EXPECT_EQ(row.solution.power, cycle_.at(row.time).solution.power);
  }
}

// With rows enough, the closed form too: |Dw| = 2 |sin|, on the mean 4/pi.
TEST(JointCycle, ReversalsAreThoseOfTheMotion) {
  // The spline through 400 rows.
  const auto rate_at = [](double t) {
    return Vector3d(2 * std::sin(2 * std::numbers::pi * t + 0.03), 0, 0);
  };
  std::vector<double> times;
  std::vector<Vector3d> rows;
  for (int i = 0; i < 400; ++i) {
    times.push_back(i / 400.);
    rows.push_back(rate_at(i / 400.));
  }
  const DutyCycle duty(
      {times, std::vector<Vector3d>(400, {0, 0, 2000}), rows, 1}, {});
  double sum = 0;
  double period = 0;
  for (const auto& [time, weight] : duty.gauss_points(false)) {
    sum += weight * duty.at(time).angular_velocity.norm();
    period += weight;
  }
  EXPECT_NEAR(period, 1, 1e-13);  // a sum of 3000
  EXPECT_NEAR(sum / (4 / std::numbers::pi), 1, 1e-9);
}

TEST(PeriodicSpline, IsSmoothAndPeriodic) {
  std::vector<double> times;
  std::vector<Vector3d> values;
  for (const double share : {0., 0.11, 0.2, 0.34, 0.4, 0.55, 0.62, 0.8, 0.9}) {
    times.push_back(3 + 2 * share);
    values.emplace_back(std::sin(2 * std::numbers::pi * share), 1, share);
  }
  const PeriodicSpline spline(times, 2, values);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_LT((spline.value(times[i]) - values[i]).norm(), 1e-15);
    EXPECT_LT((spline.value(times[i] - 4) - values[i]).norm(), 1e-14);
    const double h = 1e-6;
    EXPECT_LT((spline.slope(times[i] + h) - spline.slope(times[i] - h)).norm(),
              1e-3);
    EXPECT_LT((spline.value(times[i] + h) - spline.value(times[i] - h) -
               2 * h * spline.slope(times[i]))
                  .norm(),
              1e-11);
  }
  EXPECT_NEAR(spline.slope(3.3).y(), 0, 1e-14);
}

// The load stands across the axis of a ring, of half-angle asin(14/33). Where
// the carrier has the ball, the body's ring turns under it by 20 deg.
TEST(JointCycle, RimsTurnWithTheirBody) {
  DutyCycle::Rows rows{{}, {}, {}, 1.0};
  for (int i = 0; i < 20; ++i) {
    rows.times.push_back(i / 20.0);
    rows.forces.emplace_back(1e5, 0, 0);
    rows.motion.emplace_back(
        20 * degree * std::sin(2 * std::numbers::pi * i / 20), 0, 0);
  }
  for (const JointBody ball : {JointBody::carrier, JointBody::body}) {
    const JointSpec spec{
        .geometry = JointGeometry::ball(0.033, 1e-5, ball)
                        .with_seat(SeatZone::ring(0.028, 0.033)),
        .inner = Material{2e11, 0.3},
        .outer = Material{1e11, 0.3},
        .friction = FrictionLaw(1e-9)};
    const JointCycle cycle(DutyCycle(rows, {}, DutyCycle::TurnSequence("y")),
                           Joint(spec.without_seat()));
    const LargestContact largest = cycle.largest_contact();
    const double turn = ball == JointBody::carrier ? 20 * degree : 0;
    // Row 5 is the sine's largest.
    EXPECT_NEAR(largest.rim_overlap,
                largest.half_angle + turn - std::asin(0.014 / 0.033), 1e-6);
  }
}

}  // namespace
}  // namespace contact::test::joint_cycle_test
