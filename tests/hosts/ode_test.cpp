// ODE's solver holds hinges and balls, libcontact says how much.
#include "hosts/ode/hinge_friction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "hosts/cup.hpp"

namespace contact::test::ode_test {
namespace {

using contact_hosts::ode::HingeFriction;

const std::string folder = CONTACT_HOST_TESTS;
const std::string ball_file = folder + "ball.toml";
const std::string pin_file = folder + "pin.toml";

/// A body that hangs from the origin.
struct World {
  dWorldID world;
  dBodyID body;

  World(double mass, const double (&inertia)[3], double x, double z) {
    dInitODE();
    world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    dWorldSetERP(world, 0.2);
    dWorldSetCFM(world, 0);
    body = dBodyCreate(world);
    dMass m;
    dMassSetParameters(&m, mass, 0, 0, 0, inertia[0], inertia[1], inertia[2], 0,
                       0, 0);
    dBodySetMass(body, &m);
    dBodySetPosition(body, x, 0, z);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() {
    dWorldDestroy(world);
    dCloseODE();
  }
  double rate() const {
    const dReal* const w = dBodyGetAngularVel(body);
    return std::hypot(w[0], w[1], w[2]);
  }
};

dJointID hinge(const World& w) {
  dJointID joint = dJointCreateHinge(w.world, nullptr);
  dJointAttach(joint, w.body, nullptr);
  dJointSetHingeAnchor(joint, 0, 0, 0);
  dJointSetHingeAxis(joint, 0, 1, 0);
  return joint;
}

// The limit is f rho R/sqrt(1 + f^2) and more for the width of the contact; a
// link of 1 kg whose centre lies aside holds or swings by the arm of its
// weight.
TEST(HostOde, HingeHoldsUpToItsLimit) {
  for (const double share : {0.98, 1.02}) {
    const auto joint = contact_hosts::read_joint(pin_file, "", CONTACT_PIN);
    const contact_hold hold = {{0, 0, 9.81}, {0, 1, 0}, {0, 1, 0}};
    contact_rest rest;
    ASSERT_EQ(contact_joint_at_rest(joint.get(), &hold, nullptr, &rest),
              CONTACT_OK);
    const double arm = share / rest.utilisation / 9.81;
    World w(1, {0.02, 0.02, 0.002}, arm, -0.25);
    HingeFriction friction(w.world);
    dJointID h = hinge(w);
    friction.add(h, pin_file);
    // The first reaction: a step in which nothing can move.
    dJointSetHingeParam(h, dParamVel, 0);
    dJointSetHingeParam(h, dParamFMax, 1e3);
    dWorldStep(w.world, 1e-3);
    for (int i = 0; i < 60'000; ++i) {
      friction.update(1e-3);
      dWorldStep(w.world, 1e-3);
      if (share > 1 && i == 50) {
        EXPECT_GT(w.rate(), 1e-5);
        break;
      }
    }
    if (share < 1) {
      EXPECT_NEAR(dJointGetHingeAngle(h), 0, 1e-10);
    }
  }
}

// docs/tutorials/pendulum.md: 44.37 s; steps of 1, 0.5 and 0.25 ms, of first
// order, give 43.298, 43.808 and 44.075 s.
TEST(HostOde, PendulumRests) {
  World w(5, {0.1, 0.1, 0.02}, 0, 0);
  dBodySetPosition(w.body, 0, 0.4 * std::sin(1), -0.4 * std::cos(1));
  dMatrix3 rotation;
  dRFromAxisAndAngle(rotation, 1, 0, 0, 1);
  dBodySetRotation(w.body, rotation);
  // w = (0, 1, 0.5) about the joint.
  const dReal* const c = dBodyGetPosition(w.body);
  dBodySetAngularVel(w.body, 0, 1, 0.5);
  dBodySetLinearVel(w.body, c[2] - 0.5 * c[1], 0, 0);
  dJointID ball = dJointCreateBall(w.world, nullptr);
  dJointAttach(ball, w.body, nullptr);
  dJointSetBallAnchor(ball, 0, 0, 0);
  HingeFriction friction(w.world);
  friction.add(ball, ball_file);
  double last = 0;  // when it moved
  for (int i = 0; i < 60'000; ++i) {
    friction.update(1e-3);
    dWorldStep(w.world, 1e-3);
    if (w.rate() > 1e-6) last = 1e-3 * i;
  }
  RecordProperty("rests_at_ms", static_cast<int>(1e3 * last));
  EXPECT_NEAR(last, 43.30, 0.05);
  EXPECT_LT(w.rate(), 1e-9);
}

Eigen::Matrix3d axes_of(dBodyID body) {
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> rows;
  std::copy_n(dBodyGetRotation(body), 12, rows.data());
  return rows.leftCols<3>();
}

void turn(dBodyID body, const Eigen::Matrix3d& axes) {
  const Eigen::Quaterniond q(axes);
  const dQuaternion to = {q.w(), q.x(), q.y(), q.z()};
  dBodySetQuaternion(body, to);
}

TEST(HostOde, SeatsTurnWithTheirBody) {
  for (const bool on_parent : {false, true}) {
    World w(100, {5, 5, 5}, 0, -0.4);
    dBodyID parent = dBodyCreate(w.world);
    dBodySetKinematic(parent);
    turn(w.body, attitude(on_parent, false));
    turn(parent, attitude(on_parent, true));
    dBodySetAngularVel(w.body, 0.3, 0.1, 0.5);
    dBodySetLinearVel(w.body, -0.04, 0.12, 0);
    dJointID ball = dJointCreateBall(w.world, nullptr);
    dJointAttach(ball, w.body, parent);
    dJointSetBallAnchor(ball, 0, 0, 0);
    HingeFriction friction(w.world);
    const std::string file = cup(on_parent);
    friction.add(ball, file);
    for (int i = 0; i < 2; ++i) {
      friction.update(1e-4);
      dWorldStep(w.world, 1e-4);
    }
    const Eigen::Vector3d reaction(dJointGetFeedback(ball)->f1);
    const Eigen::Vector3d rate(dBodyGetAngularVel(w.body));
    friction.update(1e-4);
    const double wanted =
        moment_in(file, axes_of(on_parent ? parent : w.body), reaction, rate)
            .norm();
    // A contact at the rim begins from the last one.
    EXPECT_NEAR(friction.limit(0) / wanted, 1, 1e-5);
    HingeFriction cold(w.world);
    dJointFeedback* const feedback = dJointGetFeedback(ball);
    const dJointFeedback last = *feedback;
    cold.add(ball, file);
    *dJointGetFeedback(ball) = last;
    cold.update(1e-4);
    EXPECT_NEAR(cold.limit(0) / wanted, 1, 1e-12);
  }
}

TEST(HostOde, SaysWhatIsWrong) {
  World w(1, {1, 1, 1}, 0, 0);
  HingeFriction friction(w.world);
  dJointID slider = dJointCreateSlider(w.world, nullptr);
  dJointAttach(slider, w.body, nullptr);
  EXPECT_THROW(friction.add(slider, pin_file), std::runtime_error);
  EXPECT_THROW(friction.add(hinge(w), ball_file), std::runtime_error);
}

}  // namespace
}  // namespace contact::test::ode_test
