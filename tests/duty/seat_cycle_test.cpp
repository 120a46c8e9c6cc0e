#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/quantities/tables.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"

// Balls in seats that end on a cycle: a load that swings in a cup towards its
// rim.
namespace contact::test::seat_cycle_test {
namespace {

using Eigen::Vector3d;

constexpr double load = 6e4;

JointSpec bearing(JointBody inner) {
  return {.geometry = JointGeometry::ball(0.025, 2.5e-5, inner)
                          .with_seat(SeatZone::cup(60 * degree)),
          .inner = Material{2.1e11, 0.3},
          .outer = Material{1.1e11, 0.34},
          .friction = FrictionLaw(0.05)};
}

// Without friction the force on the seat swings about X in its axes; the body
// turns only with a rate about X.
DutyCycle cycle(double side, double swing = 20 * degree) {
  DutyCycle::Rows rows;
  for (int i = 0; i < 24; ++i) {
    const double v = swing * std::sin(2 * pi * i / 24);
    rows.times.push_back(i / 24.0);
    rows.forces.push_back(side * load * Vector3d(0, std::sin(v), std::cos(v)));
    rows.motion.push_back({0.01 * std::cos(2 * pi * i / 24), 0, 0});
  }
  rows.period = 1;
  return {rows, {}, DutyCycle::TurnSequence("xyz")};
}

double number(const JointCycle& cycle, std::string_view key) {
  return value_of(*find_quantity(worst_quantities(), key), cycle);
}

TEST(CycleInSeat, AnswersAsTheJointAtEachTime) {
  for (const JointBody inner : {JointBody::carrier, JointBody::body}) {
    const double side = inner == JointBody::carrier ? 1 : -1;
    const JointSpec spec = bearing(inner);
    const DutyCycle swing = cycle(side);
    const Joint joint(spec);
    const JointCycle in_seat(swing, joint);
    ASSERT_TRUE(in_seat.is_at_rims());
    ASSERT_EQ(in_seat.rows().size(), 24u);
    EXPECT_EQ(in_seat.joint().table(), "");  // too few for one
    EXPECT_TRUE(std::isnan(number(in_seat, "table_error")));
    for (std::size_t i : {0u, 6u, 13u}) {
      const auto row = in_seat.rows()[i];
      const DutyCycle::State state = swing.at(row.time);
      // The seat is the body's if the carrier has the ball.
      const Eigen::Matrix3d to_seat =
          side > 0 ? state.turn.conjugate().toRotationMatrix()
                   : Eigen::Matrix3d::Identity().eval();
      const JointSolution s =
          joint.solve({.reaction = to_seat * state.reaction,
                       .angular_velocity = to_seat * state.angular_velocity});
      EXPECT_EQ(std::isnan(s.half_angle), std::isnan(row.solution.half_angle));
      EXPECT_LT(
          (s.friction_moment - to_seat * row.solution.friction_moment).norm(),
          1e-5 * s.friction_moment.norm());
    }
    double at_rim = 0, heat = 0, distance = 0, largest = 0;
    for (const JointCycle::Instant& row : in_seat.rows()) {
      EXPECT_NEAR(row.weight, 1 / 24.0, 1e-15);
      const RimContact rims = *joint.rims(row.solution);
      at_rim += rims.rims[1].intensity > 0 ? row.weight : 0;
      heat -= row.weight * row.solution.power;
      // The heat of dry friction is f0 times p v, free or at the rim.
      const ContactPv pv = in_seat.pv(row);
      largest = std::max(largest, pv.largest);
      distance += row.weight * pv.total / row.solution.normal_force;
      EXPECT_NEAR(-0.05 * pv.total, row.solution.power,
                  (rims.is_free ? 1e-9 : 1e-3) * std::abs(row.solution.power));
      const SlidingContact::Rating rating = in_seat.rating(row);
      EXPECT_EQ(rating.pv_total, pv.total);
      EXPECT_EQ(rating.pv.value, pv.largest);
      EXPECT_EQ(std::isnan(rating.heat_flux.value), !rims.is_free);
      EXPECT_NEAR(rating.heat, -row.solution.power,
                  1e-12 * std::abs(row.solution.power));
    }
    EXPECT_NEAR(in_seat.rim_share(), at_rim, 1e-12);
    EXPECT_GT(at_rim, 0.1);
    EXPECT_LT(at_rim, 0.9);
    EXPECT_EQ(number(in_seat, "least_gap"), 0);
    EXPECT_GT(number(in_seat, "largest_intensity"), 0);
    // The load is nearest to the rim at a quarter and at three.
    EXPECT_NEAR(std::abs(in_seat.largest_peak().time - 0.5), 0.25, 0.1);
    EXPECT_NEAR(in_seat.sums().energy, heat, 1e-12 * heat);
    EXPECT_NEAR(0.05 * in_seat.sums().pv / heat, 1, 1e-3);
    EXPECT_NEAR(in_seat.sums().effective_distance / distance, 1, 1e-12);
    EXPECT_EQ(number(in_seat, "largest_pv"), largest);
    EXPECT_NEAR(
        in_seat.integral([&](const auto& i) { return in_seat.pv(i).total; }),
        in_seat.sums().pv, 1e-12 * in_seat.sums().pv);
    // There is no half-angle at a rim, and no middle of the contact.
    EXPECT_TRUE(std::isnan(in_seat.contact_spread()));
    EXPECT_TRUE(std::isnan(
        in_seat.largest([](const auto& i) { return i.solution.half_angle; })
            .solution.half_angle));
    ASSERT_FALSE(in_seat.notes().empty());
    EXPECT_THAT(in_seat.notes().front(), testing::StartsWith("from "));
  }
}

std::vector<Vector3d> arc() {
  std::vector<Vector3d> all;
  for (const double v : {0.1, 0.5, 0.9}) {
    all.emplace_back(0, std::sin(v), std::cos(v));
  }
  return all;
}

// The seat wears by Joint::pressures() at each time.
TEST(CycleInSeat, WearMapIsTheSumOverTheRows) {
  const JointSpec spec = bearing(JointBody::body);
  const Joint joint(spec);
  const JointCycle in_seat(cycle(-1), joint);
  const WearMap seat(in_seat, JointBody::carrier);
  const double radius = spec.geometry.radius();
  for (const Vector3d& place : arc()) {
    double pv = 0;
    for (const JointCycle::Instant& row : in_seat.rows()) {
      // Grids that are found again are the kept ones.
      pv += row.weight *
            joint.pressures(row.solution.without_grid(), {&place, 1})[0] *
            radius * row.state.angular_velocity.cross(place).norm();
    }
    // As near as contacts from other starts are.
    EXPECT_NEAR(seat.at(place).pv / pv, 1, 1e-5) << place.transpose();
    EXPECT_GT(pv, 0);
  }
  const auto together = seat.at(arc());
  for (std::size_t i = 0; i < together.size(); ++i) {
    const WearMap::Wear one = seat.at(arc()[i]);
    EXPECT_EQ(together[i].pv, one.pv);
    EXPECT_EQ(together[i].cross_shear, one.cross_shear);
  }
  // Beside the rim the pressure keeps its value at 0.02 radii; beyond the rim
  // it is 0.
  const auto at = [&](double v) {
    return seat.at(Vector3d(0, std::sin(v), std::cos(v))).pv;
  };
  const double rim = 60 * degree;
  EXPECT_NEAR(at(rim - 1e-9) / at(rim - 0.01), 1, 0.05);  // the free
  EXPECT_GT(at(rim - 1e-9), 0);
  EXPECT_EQ(at(rim + 1e-6), 0);
  // The ball turns by 0.1 deg: both maps are almost the same, upside down.
  const WearMap ball(in_seat, JointBody::body);
  const Vector3d middle(0, std::sin(0.3), std::cos(0.3));
  EXPECT_NEAR(ball.at(middle).pv / seat.at(middle).pv, 1, 0.02);
  // p within 0.02 radii of the rim is cut: a little of the volume is missing.
  const auto wear = seat.at(seat.grid(4000));
  for (const WearMap::Wear& one : wear) EXPECT_GE(one.pv, 0);
  const double defect = seat.volume_defect(wear);
  EXPECT_LT(defect, 0.002);
  EXPECT_GT(defect, -0.03);
}

// Peaks searched far from the rim can be below the mean of contacts at it: such
// rows have no peak, and neither has the cycle if their mean is the larger.
TEST(CycleInSeat, HasNoPeakThatMayBeExceeded) {
  for (const double report_distance : {0.02, 0.7}) {
    JointSpec spec = bearing(JointBody::body);
    spec.geometry = spec.geometry.with_seat(
        SeatZone::cup(60 * degree)
            .with_edge({.report_distance = report_distance}));
    const JointCycle in_seat(cycle(-1, 55 * degree), Joint(spec));
    int hidden = 0;
    double mean = 0, largest = 0;
    for (const JointCycle::Instant& row : in_seat.rows()) {
      ASSERT_EQ(row.solution.status, Status::ok);
      const double peak = row.solution.peak_pressure;
      if (std::isnan(peak)) {
        ++hidden;
        mean =
            std::max(mean, in_seat.joint().rims(row.solution)->mean_pressure());
      } else {
        largest = std::max(largest, peak);
      }
    }
    EXPECT_EQ(hidden > 0, report_distance > 0.1);
    const double found = number(in_seat, "largest_peak_pressure");
    EXPECT_EQ(std::isnan(found), largest < mean) << largest << " " << mean;
    if (largest >= mean) {
      EXPECT_EQ(found, largest);
    }
  }
}

// A cycle whose contacts reach no rim equals the unbounded seat's under the
// laws exact, Gauss points and maxima between the rows too.
TEST(CycleInSeat, FreeContactsAreThoseWithoutRims) {
  for (const JointBody inner : {JointBody::carrier, JointBody::body}) {
    JointSpec spec = bearing(inner);
    spec.geometry = spec.geometry.with_seat(SeatZone::cup(120 * degree));
    const double side = inner == JointBody::carrier ? 1 : -1;
    const JointCycle in_seat(cycle(side), Joint(spec));
    EXPECT_FALSE(in_seat.is_at_rims());
    EXPECT_EQ(in_seat.rim_share(), 0);
    EXPECT_GT(number(in_seat, "least_gap"), 0);
    EXPECT_EQ(number(in_seat, "largest_intensity"), 0);
    spec = spec.without_seat();
    spec.half_angle_law = "exact";
    const JointCycle free(cycle(side), Joint(spec));
    EXPECT_TRUE(std::isnan(number(free, "least_gap")));
    EXPECT_EQ(in_seat.sums().energy, free.sums().energy);
    EXPECT_EQ(in_seat.sums().pv, free.sums().pv);
    EXPECT_EQ(in_seat.contact_spread(), free.contact_spread());
    for (const auto& quantity : worst_quantities().first(2)) {
      EXPECT_EQ(number_of(quantity, in_seat), number_of(quantity, free));
    }
    for (const JointBody body : {JointBody::body, JointBody::carrier}) {
      const WearMap confined(in_seat, body), endless(free, body);
      for (const Vector3d& place : arc()) {
        EXPECT_EQ(confined.at(place).pv, endless.at(place).pv);
      }
    }
  }
}

// The ball leaves its seat for a while: sums over that time and all largest
// values are unknown.
TEST(CycleInSeat, WithoutASeatThereAreNoNumbers) {
  const JointCycle out(cycle(-1, 70 * degree), Joint(bearing(JointBody::body)));
  const auto rows = out.rows();
  EXPECT_TRUE(std::ranges::any_of(rows, [](const auto& row) {
    return row.solution.status == Status::out_of_seat;
  }));
  EXPECT_EQ(rows[0].solution.status, Status::ok);
  EXPECT_TRUE(std::isnan(out.sums().energy));
  EXPECT_TRUE(std::isnan(out.sums().pv));
  for (const char* key : {"largest_peak_pressure", "largest_pv"}) {
    EXPECT_TRUE(std::isnan(number(out, key))) << key;
  }
  EXPECT_THAT(out.notes(),
              testing::Contains(testing::HasSubstr("the ball leaves it")));
  EXPECT_THAT(error_message([&] { WearMap(out, JointBody::carrier); }),
              testing::HasSubstr("the ball leaves it"));
}

}  // namespace
}  // namespace contact::test::seat_cycle_test
