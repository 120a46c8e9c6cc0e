#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "libcontact/base/linear/turn.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/joint/joint.hpp"
#include "support/numbers.hpp"

// p v over contacts that reach a rim: against the power of friction, which
// comes from harmonics, and against the pressures at places.
namespace contact::test::pv_test {
namespace {

using Eigen::Vector3d;

constexpr double radius = 0.025;
constexpr double f0 = 0.1;

JointSpec bearing(const SeatZone& zone) {
  return {.geometry = JointGeometry::ball(radius, 2.5e-5, JointBody::carrier)
                          .with_seat(zone),
          .inner = Material{2.1e11, 0.3},
          .outer = Material{1.1e11, 0.34},
          .friction = FrictionLaw(f0)};
}

// The seat's axis is tilted in the axes of the reaction.
SeatZone tilted_cup() {
  return SeatZone::cup(60 * degree).about({0.6, 0, 0.8});
}

const Vector3d rates[] = {
    {0.2, 0, 0}, {0, 0.3, 0}, {0, 0, -0.1}, {0.1, 0.2, 0.3}};

TEST(SeatContactPv, TotalTimesFrictionIsThePower) {
  for (const SeatZone& zone : {tilted_cup(), SeatZone::ring(0.02, radius)}) {
    const Joint joint(bearing(zone));
    for (const Vector3d& rate : rates) {
      const JointSolution s =
          joint.solve({.reaction = {4e4, 2e4, 3e4}, .angular_velocity = rate});
      ASSERT_EQ(s.status, Status::ok);
      ASSERT_GT(joint.rims(s)->intensity(), 0);
      const ContactPv pv = joint.pv(s, rate);
      EXPECT_NEAR(-f0 * pv.total / s.power, 1, 1e-3);
      EXPECT_NEAR(pv.place.norm(), 1, 1e-12);
    }
  }
}

// Against places 1 deg apart: never above the largest by more than pressures
// between longitudes are off, and reached at its place.
TEST(SeatContactPv, LargestIsThatOfPlaces) {
  const Joint joint(bearing(tilted_cup()));
  const Vector3d axis(0.6, 0, 0.8);
  const auto turn = detail::turn_between(Vector3d::UnitZ(), axis);
  std::vector<Vector3d> places;
  const double end = 60 * degree - 0.02;  // the reported distance
  for (int i = 0; i <= 60; ++i) {
    for (int k = 0; k < 360; ++k) {
      const double v = end * i / 60, phi = k * degree;
      places.push_back(turn * Vector3d(std::sin(v) * std::cos(phi),
                                       std::sin(v) * std::sin(phi),
                                       std::cos(v)));
    }
  }
  for (const Vector3d& rate : rates) {
    const JointSolution s =
        joint.solve({.reaction = {4e4, 2e4, 3e4}, .angular_velocity = rate});
    const ContactPv pv = joint.pv(s, rate);
    const std::vector<double> p = joint.pressures(s, places);
    double most = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      most = std::max(most, p[i] * radius * rate.cross(places[i]).norm());
    }
    EXPECT_NEAR(pv.largest / most, 1, 5e-3);
    const double there = joint.pressures(s, std::vector{pv.place})[0] * radius *
                         rate.cross(pv.place).norm();
    EXPECT_NEAR(pv.largest / there, 1, 5e-3);
    EXPECT_GT(std::acos(pv.place.dot(axis)), 0);
    EXPECT_LE(std::acos(pv.place.dot(axis)), end + 1e-9);
  }
}

TEST(SeatContactPv, RestAndNoContact) {
  const Joint joint(bearing(tilted_cup()));
  const JointSolution s = joint.solve(
      {.reaction = {4e4, 2e4, 3e4}, .angular_velocity = Vector3d::Zero()});
  EXPECT_EQ(joint.pv(s, Vector3d::Zero()).total, 0);
  EXPECT_EQ(joint.pv(s, Vector3d::Zero()).largest, 0);
  EXPECT_TRUE(std::isnan(joint.pv({}, rates[0]).total));
}

}  // namespace
}  // namespace contact::test::pv_test
