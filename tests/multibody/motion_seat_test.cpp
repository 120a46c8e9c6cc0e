#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <memory>

#include "libcontact/files/joint_file.hpp"
#include "multibody/motion/motion.hpp"
#include "multibody_support/wheel.hpp"

// Bodies on balls in seats that end.
namespace multibody::test::motion_seat_test {
namespace {

using contact::Joint;
using contact::JointBody;
using contact::JointSpec;
using contact::RimContact;

// 60 kN are enough for the rims of the ring; it is the body's.
constexpr double mass = 12000;
constexpr double arm = 1;
constexpr double own_inertia = 3000;

const JointSpec& ring() {
  static const JointSpec joint = contact::read_joint(
      CONTACT_DATA_DIR "/joints/spherical_plain_bearing_ge50.toml");
  return joint;
}

const Joint& endless() {
  static const Joint joint = [] {
    JointSpec spec = ring().without_seat();
    spec.half_angle_law = "exact";
    return Joint(spec);
  }();
  return joint;
}

System pendulum(double of_mass) {
  Carrier ground;
  ground.fixed = true;
  Body body{HingeKind::ball, of_mass,
            own_inertia * of_mass / mass * Matrix3d::Identity()};
  body.hinge_from_com = Vector3d(0, arm, 0);
  return {ground, {body}};
}

// Turned about z, the ring's axis, from hanging.
MotionStart turned(double angle, double rate,
                   const Vector3d& axis = Vector3d::UnitZ()) {
  MotionStart start = start_of(1);
  start.bodies[0].rotation = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  start.bodies[0].relative_angular_velocity = rate * axis;
  return start;
}

MotionOptions with_gravity(double step) {
  MotionOptions options;
  options.integrator = Integrator::rk4;
  options.step = step;
  options.gravity = Vector3d(0, -g, 0);
  return options;
}

// The same pendulum by one angle, its friction by Joint called here.
struct Plane {
  const Joint& seat;
  contact::JointSolution last = {};

  // phi'' of the reaction that it causes.
  double acceleration(double phi, double rate) {
    const double inertia = own_inertia + mass * arm * arm;
    const double free = -mass * g * arm * std::sin(phi) / inertia;
    double found = free;
    for (int fit = 0; fit < 12; ++fit) {
      // R = m (a - gravity) on the body, in body axes.
      const Vector3d reaction(mass * (arm * found + g * std::sin(phi)),
                              mass * (arm * rate * rate + g * std::cos(phi)),
                              0);
      last = seat.solve(
          {.reaction = reaction, .angular_velocity = {0, 0, rate}}, last);
      found = free + last.friction_moment.z() / inertia;
    }
    return found;
  }

  void step(std::array<double, 2>& s, double h) {
    using State = Eigen::Array2d;
    const auto rates = [&](const State& y) {
      return State(y[1], acceleration(y[0], y[1]));
    };
    const State y(s[0], s[1]);
    const State a = rates(y), b = rates(y + h / 2 * a),
                c = rates(y + h / 2 * b), d = rates(y + h * c);
    const State next = y + h / 6 * (a + 2 * b + 2 * c + d);
    s = {next[0], next[1]};
  }
};

double angle_of(const Motion& motion) {
  const Matrix3d c = motion.sample().hinge(0).rotation;
  return std::atan2(c(1, 0), c(0, 0));
}

TEST(MotionSeat, AtTheRimsIsTheEquationOfOneAngle) {
  const Joint seat(ring());
  constexpr double h = 0.02;
  constexpr int steps = 4;
  Motion motion(pendulum(mass), {JointFriction{seat}}, nullptr,
                turned(0.5, -0.2), with_gravity(h));
  const double before = motion.sample().energy().balance();
  Plane plane{seat};
  std::array<double, 2> state = {0.5, -0.2};
  for (int i = 0; i < steps; ++i) plane.step(state, h);
  ASSERT_EQ(motion.advance_to(h * steps), Stop::time);
  const HingeSample hinge = motion.sample().hinge(0);
  // Rounding, and loops that stop at their tolerances.
  EXPECT_NEAR(angle_of(motion), state[0], 1e-10);
  EXPECT_NEAR(hinge.relative_angular_velocity.z(), state[1], 1e-9);
  EXPECT_LT(hinge.relative_angular_velocity.head<2>().norm(), 1e-9);
  // At both rims of the ring; friction there differs from the friction of the
  // whole ball.
  const RimContact at = *seat.rims(hinge.joints[0]);
  EXPECT_EQ(at.rims[0].gap, 0);
  EXPECT_EQ(at.rims[1].gap, 0);
  EXPECT_TRUE(std::isnan(hinge.joints[0].half_angle));
  const contact::Joint::Slip slip{hinge.reaction_force,
                                  hinge.relative_angular_velocity};
  const auto found = seat.solve(slip);
  EXPECT_NEAR(hinge.friction_moment.z() / found.friction_moment.z(), 1, 1e-6);
  EXPECT_GT(std::abs(hinge.friction_moment.z() /
                         endless().solve(slip).friction_moment.z() -
                     1),
            1e-3);
  EXPECT_EQ(hinge.joints[0].peak_pressure > 0, true);
  EXPECT_LT(hinge.joints[0].power, 0);
  // RK4 leaves as much of a plain ball at this step.
  EXPECT_NEAR(motion.sample().energy().balance() / before, 1, 1e-6);
}

TEST(MotionSeat, AwayFromTheRimsExactLawsAnswer) {
  const Joint seat(ring());
  constexpr double light = 20;
  Motion confined(pendulum(light), {JointFriction{seat}}, nullptr,
                  turned(0.5, -0.2), with_gravity(0.01));
  Motion whole(pendulum(light), {JointFriction{endless()}}, nullptr,
               turned(0.5, -0.2), with_gravity(0.01));
  ASSERT_EQ(confined.advance_to(0.5), Stop::time);
  ASSERT_EQ(whole.advance_to(0.5), Stop::time);
  // The same equations; one of them is tracked.
  EXPECT_NEAR(angle_of(confined), angle_of(whole), 1e-10);
  const HingeSample hinge = confined.sample().hinge(0);
  EXPECT_GT(seat.rims(hinge.joints[0])->gap(), 0);
  const double half_angle =
      endless()
          .solve({hinge.reaction_force, hinge.relative_angular_velocity})
          .half_angle;
  // Begun elsewhere: to the joint solver's tolerance.
  EXPECT_NEAR(hinge.joints[0].half_angle / half_angle, 1, 1e-11);
}

// Rests while the seat says that friction holds, in the axes of the body that
// has the seat.
TEST(MotionSeat, RestsAsTheSeatSays) {
  for (const JointBody inner : {JointBody::carrier, JointBody::body}) {
    JointSpec joint = ring();
    joint.geometry =
        contact::JointGeometry::ball(joint.geometry.radius(),
                                     joint.geometry.radial_clearance(), inner)
            .with_seat(*joint.geometry.seat());
    const Joint seat(joint);
    // Across the ring's axis the load leaves its middle.
    const Vector3d axis = Vector3d(1, 0, 1).normalized();
    for (const double angle : {0.8e-3, 4e-3}) {
      Motion motion(pendulum(mass), {JointFriction{seat}}, nullptr,
                    turned(angle, 0, axis), with_gravity(0.01));
      const Matrix3d to_body =
          Eigen::AngleAxisd(-angle, axis).toRotationMatrix();
      const Vector3d weight(0, mass * g, 0);
      // Friction has to hold gravity's moment about the ball.
      const Vector3d held = -(to_body.transpose() * Vector3d(0, -arm, 0))
                                 .cross(Vector3d(0, -mass * g, 0));
      const bool has_body = inner == JointBody::carrier;
      const auto rest = seat.at_rest(
          {.reaction = has_body ? Vector3d(to_body * weight) : weight,
           .moment = has_body ? Vector3d(to_body * held) : held});
      const HingeSample hinge = motion.sample().hinge(0);
      EXPECT_EQ(hinge.mode,
                rest.utilisation <= 1 ? HingeMode::resting : HingeMode::sliding)
          << angle;
      EXPECT_EQ(rest.utilisation <= 1, angle < 2e-3) << rest.utilisation;
      if (hinge.mode == HingeMode::resting) {
        EXPECT_NEAR(hinge.utilisation / rest.utilisation, 1, 1e-6);
        EXPECT_EQ(seat.rims(hinge.joints[0])->rims[0].gap, 0);
        ASSERT_EQ(motion.advance_to(0.1), Stop::time);
        EXPECT_TRUE(
            motion.sample().hinge(0).relative_angular_velocity.isZero(0));
      }
    }
  }
}

TEST(MotionSeat, OutOfTheSeatIsSaid) {
  JointSpec joint =
      contact::read_joint(CONTACT_DATA_DIR "/joints/hip_cup.toml");
  const Joint seat(joint);
  // The load pulls along the cup's opening, whichever way it looks.
  const auto& z = joint.geometry.seat()->axis();
  const Vector3d along(z[0], z[1], z[2]);
  int failed = 0;
  for (const double sign : {1.0, -1.0}) {
    Carrier ground;
    ground.fixed = true;
    Body body{HingeKind::ball, 50, Matrix3d::Identity()};
    body.hinge_from_com = Vector3d(0, 0.1, 0);
    MotionOptions options = with_gravity(0.01);
    options.gravity = sign * g * along;
    // At rest too, where there is no moment to be held.
    Body balanced = body;
    balanced.hinge_from_com.setZero();
    const Motion resting({ground, {balanced}}, {JointFriction{seat}}, nullptr,
                         turned(0, 0), options);
    Motion motion({ground, {body}}, {JointFriction{seat}}, nullptr,
                  turned(0, 0.1), options);
    EXPECT_EQ(resting.failure().has_value(), motion.failure().has_value());
    if (!motion.failure()) continue;
    ++failed;
    EXPECT_NE(motion.failure()->message().find(
                  "no contact on the joint's seat carries its load of"),
              std::string::npos)
        << motion.failure()->message();
  }
  EXPECT_EQ(failed, 1);
}

}  // namespace
}  // namespace multibody::test::motion_seat_test
