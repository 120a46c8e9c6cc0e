// A flat thrust face against its integral, and together with pins in a group.
#include "libcontact/joint/thrust_face.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>

#include "libcontact/joint/group.hpp"
#include "support/error_message.hpp"

namespace contact::test::thrust_face_test {
namespace {

using namespace contact;
using contact::test::error_message;
using Eigen::Vector3d;

// The moment is the integral of the stress f0 p + A times r over the ring.
TEST(ThrustFace, MomentIsTheIntegral) {
  for (const double inner : {0.0, 0.006, 0.0119, 0.012 - 1e-9}) {
    const double outer = 0.012, f0 = 0.15, adhesion = 2e5, force = -400;
    const ThrustFace face(inner, outer, FrictionLaw(f0, adhesion));
    const double area = std::numbers::pi * (outer - inner) * (outer + inner);
    const auto stress = [&](double r) {
      return 2 * std::numbers::pi * r * r *
             (f0 * std::abs(force) / area + adhesion);
    };
    const double moment =
        boost::math::quadrature::gauss_kronrod<double, 15>::integrate(
            stress, inner, outer, 0, 0);
    EXPECT_NEAR(face.moment(force), moment, 1e-15 * 100 * moment) << inner;
  }
  // A thin ring is a circle, a disc has 2/3 of its radius.
  EXPECT_NEAR(ThrustFace(0.012 - 1e-9, 0.012, FrictionLaw(1)).arm(), 0.012,
              1e-9);
  EXPECT_DOUBLE_EQ(ThrustFace(0, 0.012, FrictionLaw(1)).arm(), 0.008);
  EXPECT_EQ(ThrustFace(0, 0.012, FrictionLaw(1, 1e5)).moment(0), 0);
}

Joint pin(double f0) {
  const Material steel = {210e9, 0.3};
  return Joint({.geometry = JointGeometry::pin(0.006, 20e-6, 0.03),
                .inner = steel,
                .outer = steel,
                .friction = FrictionLaw(f0)});
}

// A door of 25 kg on two hinges 1.5 m apart, its centre 0.4 m off the axis.
struct Door {
  static constexpr double weight = 25 * 9.81, height = 1.5, width = 0.4;
  ThrustFace face{0.006, 0.012, FrictionLaw(0.2)};
  JointGroup group{{{pin(0.1), 0}, {pin(0.1), height}}, {}, face};
  JointGroup::Slip slip{.reaction = {0, 0, weight},
                        .moment = {0, weight* width, 0},
                        .axis = Vector3d::UnitZ(),
                        .angular_velocity = 0.5};
};

TEST(ThrustFace, DoorTurnsAgainstPinsAndFace) {
  const Door door;
  auto s = door.group.make_solution();
  door.group.solve(door.slip, s);
  ASSERT_EQ(s.status, Status::ok);
  const double thrust = 0.2 * Door::weight * door.face.arm();
  EXPECT_DOUBLE_EQ(s.thrust_moment, -thrust);
  // Each pin carries the couple's force, and no force along the axis.
  double pins = 0;
  for (const JointSolution& joint : s.joints) {
    EXPECT_NEAR(joint.reaction.norm(),
                Door::weight * Door::width / Door::height, 1e-9);
    EXPECT_NEAR(joint.reaction.z(), 0, 1e-12);
    pins += joint.friction_moment.z();
  }
  EXPECT_NEAR(s.friction_moment, pins - thrust, 1e-15);
  EXPECT_NEAR(s.power, 0.5 * s.friction_moment, 1e-15);
  // The textbook's: mu (m g r_thrust + 2 F r_pin).
  const double textbook =
      thrust + 2 * 0.1 * Door::weight * Door::width / Door::height * 0.006;
  EXPECT_NEAR(-s.friction_moment, textbook, 0.02 * textbook);
}

TEST(ThrustFace, DoorHolds) {
  const Door door;
  auto s = door.group.make_solution();
  door.group.solve(door.slip, s);
  const double most = std::abs(s.friction_moment);
  for (const double share : {-1.1, -0.5, 0.5, 1.1}) {
    const double tau = door.group.utilisation(
        {door.slip.reaction, door.slip.moment, door.slip.axis, share * most},
        s);
    EXPECT_NEAR(tau, std::abs(share), 1e-12);
  }
}

TEST(ThrustFace, Refusals) {
  const Door door;
  const Material steel = {210e9, 0.3};
  const Joint ball({.geometry = JointGeometry::ball(0.006, 20e-6),
                    .inner = steel,
                    .outer = steel,
                    .friction = FrictionLaw(0.1)});
  EXPECT_EQ(error_message([&] {
              JointGroup({{ball, 0}, {pin(0.1), 1}}, {}, door.face);
            }),
            "joint group with a thrust face requires pins alone: how a ball "
            "shares the force along the axis is not known");
  EXPECT_EQ(error_message([] { ThrustFace(0.012, 0.012, FrictionLaw(0.1)); }),
            "thrust face: inner_radius = 0.012 must be 0 m or above, below "
            "outer_radius = 0.012 m");
  EXPECT_EQ(error_message([] { ThrustFace(0, 0, FrictionLaw(0.1)); }),
            "thrust face: outer_radius = 0 must be above 0 m and finite");
}

}  // namespace
}  // namespace contact::test::thrust_face_test
