// The moments that a ball in a seat that ends can hold: a convex set whose
// functions agree, the rest that Joint finds, and the free limit.
#include "libcontact/joint/moment_set.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/joint/joint.hpp"
#include "support/random_slip.hpp"

namespace contact::test::moment_set_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double radius = 0.025;

JointSpec cup(double f0) {
  return {.geometry = JointGeometry::ball(radius, 2.5e-5)
                          .with_seat(SeatZone::cup(60 * degree)),
          .inner = Material{2.1e11, 0.3},
          .outer = Material{1.1e11, 0.34},
          .friction = FrictionLaw(f0)};
}

// Beside the rim, at it, and far beyond; the last is free.
std::vector<JointSolution> solutions(const Joint& joint) {
  std::vector<JointSolution> all;
  for (const double direction : {25.0, 40.0, 50.0, 0.0}) {
    const double v = direction * degree;
    const double load = direction == 0 ? 2e4 : 6e4;
    all.push_back(
        joint.solve({.reaction = load * Vector3d(std::sin(v), 0, std::cos(v)),
                     .angular_velocity = {0.3, 1, -0.5}}));
    EXPECT_EQ(all.back().status, Status::ok) << direction;
    EXPECT_EQ(joint.rims(all.back())->is_free, direction == 0);
  }
  return all;
}

TEST(MomentSetAtRim, IsConvexAndEvenWithTheMomentAsGradient) {
  const Joint joint(cup(0.1));
  RandomSlips random(1);
  for (const JointSolution& s : solutions(joint)) {
    const MomentSet set = joint.moment_set(s);
    const double size = 0.1 * radius * s.normal_force;
    EXPECT_LT((set.moment({0.3, 1, -0.5}) - s.friction_moment).norm(),
              1e-5 * size);
    EXPECT_EQ(set.support(Vector3d::Zero()), 0);
    for (int i = 0; i < 20; ++i) {
      const Vector3d u = random.direction(), v = random.direction();
      EXPECT_NEAR(set.support(-u), set.support(u), 1e-12 * size);
      EXPECT_NEAR(set.support(3 * u), 3 * set.support(u), 1e-12 * size);
      EXPECT_LE(set.support(u + v),
                set.support(u) + set.support(v) + 1e-4 * size);
      // The support is the largest of M.u: no other edge reaches further.
      EXPECT_LE(-set.moment(v).dot(u), set.support(u) + 1e-4 * size);
      constexpr double h = 1e-5;
      EXPECT_NEAR((set.support(u + h * v) - set.support(u - h * v)) / (2 * h),
                  -set.moment(u).dot(v), 1e-5 * size);
    }
  }
}

TEST(MomentSetAtRim, UtilisationOfTheEdgeIsOne) {
  const Joint joint(cup(0.1));
  RandomSlips random(2);
  for (const JointSolution& s : solutions(joint)) {
    const MomentSet set = joint.moment_set(s);
    EXPECT_EQ(set.utilisation(Vector3d::Zero()), 0);
    for (int i = 0; i < 10; ++i) {
      const Vector3d edge = set.moment(random.direction());
      EXPECT_NEAR(set.utilisation(edge), 1, 1e-6);
      EXPECT_NEAR(set.utilisation(-0.3 * edge), 0.3, 1e-6);
      EXPECT_LT((set.project(0.9 * edge) - 0.9 * edge).norm(),
                1e-12 * edge.norm());
    }
  }
}

TEST(MomentSetAtRim, ProxLeavesWhatFrictionCannotHold) {
  const Joint joint(cup(0.1));
  RandomSlips random(3);
  for (const JointSolution& s : solutions(joint)) {
    const MomentSet set = joint.moment_set(s);
    const Vector3d from = random.direction();
    const Matrix3d inertia = Matrix3d::Identity() + 4 * from * from.transpose();
    for (int i = 0; i < 10; ++i) {
      const Vector3d free =
          3 * inertia.inverse() * set.moment(random.direction());
      const MomentSet::Prox prox = set.prox(inertia, free);
      EXPECT_EQ(prox.status, Status::ok);
      EXPECT_LT(prox.residual, 1e-9);
      EXPECT_LT((set.moment(prox.angular_velocity) - prox.moment).norm(),
                1e-9 * prox.moment.norm());
      EXPECT_TRUE(set.prox(inertia, free / 3.1).angular_velocity.isZero(0));
      // The projection is the nearest of all points of the edge.
      const Vector3d far = 2 * set.moment(random.direction());
      const Vector3d nearest = set.project(far);
      for (int k = 0; k < 10; ++k) {
        EXPECT_LE(
            (far - nearest).norm(),
            (far + set.moment(random.direction())).norm() + 1e-6 * far.norm());
      }
    }
  }
}

// Joint::at_rest() finds the same by other equations.
TEST(MomentSetAtRim, OfTheSlipAtRestHoldsTheSameShare) {
  const Joint joint(cup(0.1));
  for (const double direction : {25.0, 40.0, 48.0}) {
    const double v = direction * degree;
    const Vector3d reaction = 6e4 * Vector3d(std::sin(v), 0, std::cos(v));
    for (const Vector3d& moment :
         {Vector3d(20, 70, -30), Vector3d(-50, 10, 60)}) {
      const RestSolution rest =
          joint.at_rest({.reaction = reaction, .moment = moment});
      ASSERT_EQ(rest.slip.status, Status::ok);
      const MomentSet set = joint.moment_set(rest.slip);
      EXPECT_NEAR(set.utilisation(moment) / rest.utilisation, 1, 1e-5);
    }
  }
}

// Just before a rim is reached the set is Joint's, just after nearly so.
TEST(MomentSetAtRim, GoesOverIntoThatOfTheFreeContact) {
  const Joint joint(cup(0.1));
  RandomSlips random(4);
  const double load = 2e4;
  const double reach = joint.contact().half_angle(load).half_angle;
  for (const double beyond : {-0.01, 0.02}) {
    const double v = 60 * degree - reach + beyond * degree;
    const Vector3d force = load * Vector3d(std::sin(v), 0, std::cos(v));
    const JointSolution s = joint.solve_contact(
        {.normal_force = force, .angular_velocity = {1, 0, 0}});
    ASSERT_EQ(joint.rims(s)->is_free, beyond < 0);
    const MomentSet set = joint.moment_set(s);
    const MomentSet free(joint.contact(), force.normalized(), load, reach);
    for (int i = 0; i < 10; ++i) {
      const Vector3d u = random.direction();
      EXPECT_NEAR(set.support(u) / free.support(u), 1, 2e-3);
    }
  }
}

}  // namespace
}  // namespace contact::test::moment_set_test
