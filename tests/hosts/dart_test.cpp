// DART's solver holds joints, libcontact says how much.
#include "hosts/dart/hinge_friction.hpp"

#include <gtest/gtest.h>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include <cmath>
#include <string>

#include "hosts/cup.hpp"

namespace contact::test::dart_test {
namespace {

using contact_hosts::dart::HingeFriction;
using Eigen::Vector3d;

const std::string folder = CONTACT_HOST_TESTS;
const std::string ball_file = folder + "ball.toml";
const std::string pin_file = folder + "pin.toml";

/// A body that hangs from the origin.
template <class Joint>
struct World {
  ::dart::simulation::WorldPtr world = ::dart::simulation::World::create();
  ::dart::dynamics::SkeletonPtr skeleton =
      ::dart::dynamics::Skeleton::create("pendulum");
  Joint* joint = nullptr;

  World(double mass, const Vector3d& inertia, const Vector3d& centre,
        double dt) {
    const auto pair = skeleton->createJointAndBodyNodePair<Joint>();
    joint = pair.first;
    ::dart::dynamics::Inertia i;
    i.setMass(mass);
    i.setLocalCOM(centre);
    i.setMoment(inertia.x(), inertia.y(), inertia.z(), 0, 0, 0);
    pair.second->setInertia(i);
    world->setGravity({0, 0, -9.81});
    world->setTimeStep(dt);
    world->addSkeleton(skeleton);
  }
};
using Hanging = World<::dart::dynamics::RevoluteJoint>;
using Pendulum = World<::dart::dynamics::BallJoint>;

// The hinge holds the weight of its link up to its limit.
TEST(HostDart, HingeHoldsUpToItsLimit) {
  const auto joint = contact_hosts::read_joint(pin_file, "", CONTACT_PIN);
  const contact_hold hold = {{0, 0, 9.81}, {0, 1, 0}, {0, 1, 0}};
  contact_rest rest;
  ASSERT_EQ(contact_joint_at_rest(joint.get(), &hold, nullptr, &rest),
            CONTACT_OK);
  for (const double share : {0.98, 1.02}) {
    Hanging w(1, {0.02, 0.02, 0.002},
              {share / rest.utilisation / 9.81, 0, -0.25}, 1e-3);
    w.joint->setAxis(Vector3d::UnitY());
    HingeFriction friction;
    friction.add(w.joint, pin_file);
    // The first reaction: a step in which nothing can move.
    w.joint->setCoulombFriction(0, 1e3);
    w.world->step();
    for (int i = 0; i < (share < 1 ? 60'000 : 100); ++i) {
      friction.update();
      w.world->step();
    }
    if (share < 1) {
      EXPECT_NEAR(w.joint->getPosition(0), 0, 1e-10);
    } else {
      EXPECT_GT(std::abs(w.joint->getVelocity(0)), 1e-5);
    }
  }
}

// docs/tutorials/pendulum.md: 44.37 s; a step of 1 ms, of first order,
// gives 43.523 s.
TEST(HostDart, PendulumRests) {
  Pendulum w(5, {0.1, 0.1, 0.02}, {0, 0, -0.4}, 1e-3);
  w.joint->setPositions(Vector3d(1, 0, 0));
  const Vector3d rate =
      Eigen::AngleAxisd(-1, Vector3d::UnitX()) * Vector3d(0, 1, 0.5);
  w.joint->setVelocities(rate);
  HingeFriction friction;
  friction.add(w.joint, ball_file);
  double last = 0;  // when it moved
  for (int i = 0; i < 60'000; ++i) {
    friction.update();
    w.world->step();
    if (w.joint->getVelocities().norm() > 1e-6) last = 1e-3 * i;
  }
  EXPECT_NEAR(last, 43.52, 0.05);
  EXPECT_LT(w.joint->getVelocities().norm(), 1e-9);
}

TEST(HostDart, SeatsTurnWithTheirBody) {
  for (const bool on_parent : {false, true}) {
    // A body that hangs from one that is welded to the world.
    Pendulum w(100, {5, 5, 5}, {0, 0, -0.4}, 1e-4);
    auto* const child = w.joint->getChildBodyNode();
    auto* const weld =
        w.skeleton->createJointAndBodyNodePair<::dart::dynamics::WeldJoint>()
            .second;
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.linear() = attitude(on_parent, true);
    weld->getParentJoint()->setTransformFromParentBodyNode(at);
    child->moveTo(weld);
    auto* const joint =
        static_cast<::dart::dynamics::BallJoint*>(child->getParentJoint());
    // The joint's own axes on the child are others.
    Eigen::Isometry3d on_child = Eigen::Isometry3d::Identity();
    on_child.linear() =
        Eigen::AngleAxisd(0.4, Vector3d::UnitZ()).toRotationMatrix();
    joint->setTransformFromChildBodyNode(on_child);
    const Eigen::Matrix3d relative = at.linear().transpose() *
                                     attitude(on_parent, false) *
                                     on_child.linear();
    joint->setPositions(
        ::dart::dynamics::BallJoint::convertToPositions(relative));
    joint->setVelocities(Vector3d(0.3, 0.1, 0.5));
    const std::string file = cup(on_parent);
    w.world->step();
    HingeFriction friction;
    friction.add(joint, file);
    friction.update();
    const Eigen::Matrix3d axes = child->getWorldTransform().linear();
    const Vector3d reaction = axes * child->getBodyForce().tail<3>();
    const Vector3d rate = axes * on_child.linear() * joint->getVelocities();
    const double wanted =
        moment_in(file, on_parent ? weld->getWorldTransform().linear() : axes,
                  reaction, rate)
            .norm();
    EXPECT_NEAR(friction.limit(0) / wanted, 1, 1e-12);
  }
}

TEST(HostDart, SaysWhatIsWrong) {
  HingeFriction friction;
  Hanging w(1, {1, 1, 1}, {0, 0, 0}, 1e-3);
  EXPECT_THROW(friction.add(w.joint, ball_file), std::runtime_error);
  World<::dart::dynamics::PrismaticJoint> rail(1, {1, 1, 1}, {0, 0, 0}, 1e-3);
  EXPECT_THROW(friction.add(rail.joint, pin_file), std::runtime_error);
}

}  // namespace
}  // namespace contact::test::dart_test
