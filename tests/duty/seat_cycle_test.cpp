#include "libcontact/duty/seat_cycle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "support/numbers.hpp"

// Balls in seats that end on a cycle: a load that swings in a cup towards its
// rim.
namespace contact::test {
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

// The force on the seat, if there were no friction, swings about X in
// its axes; the body does not turn but for a rate about X.
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

TEST(SeatCycle, AnswersAsTheJointAtEachTime) {
  for (const JointBody inner : {JointBody::carrier, JointBody::body}) {
    const double side = inner == JointBody::carrier ? 1 : -1;
    const JointSpec spec = bearing(inner);
    const DutyCycle swing = cycle(side);
    const SeatCycle in_seat(swing, spec);
    const SeatJoint joint(spec);
    ASSERT_EQ(in_seat.rows().size(), 24u);
    EXPECT_EQ(in_seat.check().states, 0);  // too few for a table
    double at_rim = 0;
    for (std::size_t i : {0u, 6u, 13u}) {
      const auto& row = in_seat.rows()[i];
      const DutyCycle::State state = swing.at(row.time);
      // The seat is the body's if the carrier has the ball.
      const Eigen::Matrix3d to_seat =
          side > 0 ? state.turn.conjugate().toRotationMatrix()
                   : Eigen::Matrix3d::Identity().eval();
      const SeatJointSolution s =
          joint.solve({.reaction = to_seat * state.reaction,
                       .angular_velocity = to_seat * state.angular_velocity});
      EXPECT_EQ(s.contact.is_free, row.solution.contact.is_free);
      EXPECT_LT((s.friction_moment - row.solution.friction_moment).norm(),
                1e-5 * s.friction_moment.norm());
    }
    for (const auto& row : in_seat.rows()) {
      EXPECT_NEAR(row.weight, 1 / 24.0, 1e-15);
      const bool is_at_rim = row.solution.contact.rims[1].intensity > 0;
      at_rim += is_at_rim ? row.weight : 0;
    }
    EXPECT_NEAR(in_seat.rim_share(), at_rim, 1e-12);
    EXPECT_GT(at_rim, 0.1);
    EXPECT_LT(at_rim, 0.9);
    ASSERT_NE(in_seat.least_gap(), nullptr);
    EXPECT_EQ(in_seat.least_gap()->solution.contact.rims[1].gap, 0);
    // The load is nearest to the rim at a quarter and at three.
    ASSERT_NE(in_seat.largest_peak(), nullptr);
    EXPECT_NEAR(std::abs(in_seat.largest_peak()->time - 0.5), 0.25, 0.1);
    // The heat of dry friction is f0 times p v, free or at the rim.
    double heat = 0, largest = 0;
    for (const auto& row : in_seat.rows()) {
      heat -= row.weight * row.solution.power;
      largest = std::max(largest, row.pv.largest);
      EXPECT_NEAR(-0.05 * row.pv.total, row.solution.power,
                  (row.solution.contact.is_free ? 1e-9 : 1e-3) *
                      std::abs(row.solution.power));
    }
    EXPECT_NEAR(0.05 * in_seat.pv_integral() / heat, 1, 1e-3);
    ASSERT_NE(in_seat.largest_pv(), nullptr);
    EXPECT_EQ(in_seat.largest_pv()->pv.largest, largest);
  }
}

std::vector<WearMap::Wear> worn(const WearMap& map,
                                const std::vector<Vector3d>& points) {
  std::vector<WearMap::Wear> all;
  for (const Vector3d& point : points) all.push_back(map.at(point));
  return all;
}

// The seat wears by what SeatJoint::pressures() says at each time.
TEST(SeatCycle, WearMapIsTheSumOverTheRows) {
  const JointSpec spec = bearing(JointBody::body);
  const SeatCycle in_seat(cycle(-1), spec, {.keeps_contacts = true});
  const SeatJoint& joint = *in_seat.joint();
  const WearMap seat(in_seat, JointBody::carrier);
  const double radius = spec.geometry.radius();
  for (const double v : {0.1, 0.5, 0.9}) {
    const Vector3d place(0, std::sin(v), std::cos(v));
    double pv = 0;
    for (const auto& row : in_seat.rows()) {
      pv += row.weight * joint.pressures(row.solution, {&place, 1})[0] *
            radius * row.angular_velocity.cross(place).norm();
    }
    EXPECT_NEAR(seat.at(place).pv / pv, 1, 1e-9) << v;
    EXPECT_GT(pv, 0);
  }
  // Beside the rim it stays what it is 0.02 radii off, and beyond it is 0.
  const auto at = [&](double v) {
    return seat.at({0, std::sin(v), std::cos(v)}).pv;
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
  const auto points = seat.grid(4000);
  const auto wear = worn(seat, points);
  for (const WearMap::Wear& one : wear) EXPECT_GE(one.pv, 0);
  const double defect = seat.volume_defect(wear);
  EXPECT_LT(defect, 0.002);
  EXPECT_GT(defect, -0.03);
}

// Peaks that are looked for far from the rim are below the mean of contacts at
// it: such rows have none, nor has the cycle where their mean is the larger.
TEST(SeatCycle, HasNoPeakThatMayBeExceeded) {
  for (const double report_distance : {0.02, 0.7}) {
    JointSpec spec = bearing(JointBody::body);
    spec.geometry = spec.geometry.with_seat(
        SeatZone::cup(60 * degree)
            .with_edge({.report_distance = report_distance}));
    const SeatCycle in_seat(cycle(-1, 55 * degree), spec);
    int hidden = 0;
    double mean = 0, largest = 0;
    for (const auto& row : in_seat.rows()) {
      const SeatState& s = row.solution.contact;
      ASSERT_EQ(s.status, SeatStatus::ok);
      if (std::isnan(s.peak_pressure)) {
        ++hidden;
        mean = std::max(mean, s.mean_pressure());
      } else {
        largest = std::max(largest, s.peak_pressure);
      }
    }
    EXPECT_EQ(hidden > 0, report_distance > 0.1);
    const auto* found = in_seat.largest_peak();
    ASSERT_EQ(found != nullptr, largest >= mean) << largest << " " << mean;
    if (found) {
      EXPECT_EQ(found->solution.contact.peak_pressure, largest);
    }
  }
}

// A cycle whose contacts reach no rim: the map of the seat without end, whose
// times are Gauss points: the trapezoidal rule of 24 even times is off by (2 pi
// /24)^2/12 where |cos| turns at 0.
TEST(SeatCycle, WearMapOfFreeContactsIsThatWithoutRims) {
  JointSpec spec = bearing(JointBody::carrier);
  spec.geometry = spec.geometry.with_seat(SeatZone::cup(120 * degree));
  const SeatCycle in_seat(cycle(1), spec);
  EXPECT_EQ(in_seat.rim_share(), 0);
  const JointCycle free(cycle(1), Joint(spec.without_seat()));
  for (const JointBody body : {JointBody::body, JointBody::carrier}) {
    const WearMap confined(in_seat, body), endless(free, body);
    for (const double v : {0.0, 0.2, 0.4}) {
      const Vector3d place(0, std::sin(v), std::cos(v));
      const WearMap::Wear a = confined.at(place), b = endless.at(place);
      EXPECT_NEAR(a.pv / b.pv, 1, 8e-3) << v;
      EXPECT_NEAR(a.cross_shear, b.cross_shear, 2e-3) << v;
    }
  }
}

}  // namespace
}  // namespace contact::test
