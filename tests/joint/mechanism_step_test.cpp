#include "libcontact/joint/steps/mechanism_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <vector>

#include "libcontact/files/joint_file.hpp"
#include "support/error_message.hpp"
#include "support/joints.hpp"
#include "support/random_slip.hpp"

namespace contact::test::mechanism_step_test {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const Joint ball = steel_ball(FrictionLaw(0.2, 1e4));
const Joint pin = steel_pin(FrictionLaw(0.2, 1e4));
constexpr double dt = 1e-2;
// Rates of the mechanism: one without friction, the pin's, another one, three
// of the ball.
constexpr int size = 6;
const std::vector<int> own = {3, 4, 5, 1};
const std::vector<MechanismJoint> joints = {{&ball, 3}, {&pin, 1}};

VectorXd random_rates(RandomSlips& random) {
  VectorXd q(size);
  for (double& x : q) x = 2 * random.uniform() - 1;
  return q;
}

// Symmetric and positive definite, times dt.
MatrixXd random_inertia(RandomSlips& random) {
  MatrixXd a(size, size);
  for (double& x : a.reshaped()) x = 2 * random.uniform() - 1;
  return dt * (a * a.transpose() + 0.3 * MatrixXd::Identity(size, size));
}

struct Case {
  explicit Case(RandomSlips& random)
      : inertia(random_inertia(random)),
        rates(random_rates(random)),
        at_end(100 * random_rates(random)),
        starts{{2e4 * random.direction()},
               {2e4 * random.direction(), random.direction()}} {}
  MatrixXd inertia;
  VectorXd rates;
  VectorXd at_end;
  std::vector<MechanismStart> starts;

  // As the simulator has it.
  VectorXd with(const VectorXd& force) const {
    return at_end + dt * inertia.inverse() * force;
  }
  MechanismStep begun() const {
    MechanismStep step(joints, size);
    step.weigh(inertia, MatrixXd(0, size), VectorXd(0), dt);
    step.begin(starts, rates, rates);
    return step;
  }
};

TEST(MechanismStep, IsTheStepOfItsJoints) {
  RandomSlips random(11);
  for (int i = 0; i < 200; ++i) {
    const Case c(random);
    MechanismStep turned = c.begun();
    VectorXd force = VectorXd::Zero(size);
    EXPECT_EQ(turned.turn(c.at_end, force), 1);
    // The same by the inverse of the mass matrix.
    const MatrixXd w =
        MatrixXd(MatrixXd(c.inertia.inverse())(own, own)).inverse() / dt;
    const Vector3d axis = c.starts[1].axis;
    const std::vector<const Joint*> all = {&ball, &pin};
    const std::vector<StepStart> starts = {
        {c.starts[0].reaction, c.rates.tail<3>(), c.at_end.tail<3>()},
        {c.starts[1].reaction, c.rates[1] * axis, c.at_end[1] * axis, axis}};
    std::vector<JointStep> steps(2);
    EXPECT_EQ(step(all, starts, w, steps).status, Status::ok);
    // 1e-12 of both, times the condition of H.
    const double scale = 1e-10 * force.norm();
    EXPECT_LT((force.tail<3>() - steps[0].moment).norm(), scale);
    EXPECT_NEAR(force[1], steps[1].moment.dot(axis), scale);
    EXPECT_EQ(force[0], 0);
    EXPECT_EQ(force[2], 0);
    EXPECT_EQ(turned.steps()[0].holds, steps[0].holds);
    EXPECT_EQ(turned.steps()[1].holds, steps[1].holds);
    EXPECT_EQ(turned.sweeps().status, Status::ok);
    // The simulator has those rates then, and another turn changes nothing.
    const VectorXd end = c.with(force);
    EXPECT_LT((end.tail<3>() - turned.steps()[0].angular_velocity).norm(),
              1e-9 * c.at_end.norm());
    EXPECT_LT(turned.turn(end, force), 1e-9);
  }
}

TEST(MechanismStep, ConstraintsAreInertia) {
  RandomSlips random(12);
  const Case c(random);
  const MatrixXd rows = MatrixXd(random_inertia(random)).topRows(2) / dt;
  const Eigen::Vector2d stiffness(3, 0.5);
  MechanismStep as_rows = c.begun();
  MechanismStep as_inertia = c.begun();
  as_rows.weigh(c.inertia, rows, stiffness, dt);
  as_inertia.weigh(c.inertia + rows.transpose() * stiffness.asDiagonal() * rows,
                   MatrixXd(0, size), VectorXd(0), dt);
  VectorXd a = VectorXd::Zero(size);
  VectorXd b = a;
  as_rows.turn(c.at_end, a);
  as_inertia.turn(c.at_end, b);
  EXPECT_LT((a - b).norm(), 1e-12 * a.norm());
  VectorXd without = VectorXd::Zero(size);
  c.begun().turn(c.at_end, without);
  EXPECT_GT((a - without).norm(), 1e-3 * a.norm());
}

TEST(MechanismStep, HoldingForceKeepsTheRates) {
  RandomSlips random(13);
  for (int i = 0; i < 20; ++i) {
    const Case c(random);
    const VectorXd force = c.begun().holding_force(c.rates, c.at_end);
    EXPECT_LT((c.with(force) - c.rates)(own).norm(), 1e-10 * c.at_end.norm());
    EXPECT_EQ(force[0], 0);
  }
}

TEST(MechanismStep, SeatsTurnWithTheirBody) {
  const Joint cup(read_joint(CONTACT_DATA_DIR "/joints/hip_cup.toml"));
  // At a rim of the cup.
  const Vector3d reaction(0, 1000, 3000);
  const Vector3d rate(0.3, 0.1, 0.5);
  const Vector3d at_end(0.4, -0.2, 0.3);
  const Matrix3d turn =
      Eigen::AngleAxisd(1.1, Vector3d(1, 2, -0.5).normalized())
          .toRotationMatrix();
  const auto moment = [&](const Matrix3d& axes) {
    MechanismStep step({{&cup, 0}}, 3);
    step.weigh(Matrix3d::Identity() * dt, MatrixXd(0, 3), VectorXd(0), dt);
    const Vector3d rates = axes * rate;
    step.begin(std::vector<MechanismStart>{{axes * reaction, {}, axes}}, rates,
               rates);
    VectorXd force = VectorXd::Zero(3);
    step.turn(axes * at_end, force);
    return Vector3d(force);
  };
  const Vector3d level = moment(Matrix3d::Identity());
  EXPECT_LT((moment(turn) - turn * level).norm(), 1e-9 * level.norm());
}

TEST(MechanismStep, OfNoJointsHasNoFriction) {
  MechanismStep step({}, 2);
  step.weigh(Eigen::Matrix2d::Identity(), MatrixXd(0, 2), VectorXd(0), dt);
  step.begin({}, VectorXd(2), VectorXd(2));
  VectorXd force = VectorXd::Zero(2);
  EXPECT_EQ(step.turn(VectorXd::Ones(2), force), 0);
  EXPECT_EQ(force, VectorXd::Zero(2));
}

TEST(MechanismStep, SaysWhatIsWrong) {
  const auto made = [](int first, int rates) {
    return error_message([&] { MechanismStep({{&ball, first}}, rates); });
  };
  const std::string rule =
      "MechanismStep: the rates of joint 0 must be among 5 and of no other "
      "joint";
  EXPECT_EQ(made(2, 5), "(no error)");
  EXPECT_EQ(made(3, 5), rule);
  EXPECT_EQ(made(-1, 5), rule);
  EXPECT_ERROR(MechanismStep({{&ball, 0}, {&pin, 2}}, 5),
               "MechanismStep: the rates of joint 1 must be among 5 and of no "
               "other joint");
  RandomSlips random(14);
  const Case c(random);
  MechanismStep step = c.begun();
  const MatrixXd none(0, size);
  const VectorXd nothing(0);
  EXPECT_ERROR(step.weigh(MatrixXd(5, 6), none, nothing, dt),
               "MechanismStep: the size of inertia must be 6, not 5");
  EXPECT_ERROR(step.weigh(c.inertia, MatrixXd(1, 5), VectorXd(1), dt),
               "MechanismStep: the size of rows must be 6, not 5");
  EXPECT_ERROR(step.weigh(c.inertia, MatrixXd(1, 6), VectorXd(2), dt),
               "MechanismStep: stiffness must be one for each row");
  EXPECT_ERROR(step.weigh(c.inertia, none, nothing, 0),
               "MechanismStep: time_step must be above 0");
  EXPECT_ERROR(step.begin({}, c.rates, c.rates),
               "MechanismStep: starts must be of all joints");
  std::vector<MechanismStart> sheared = c.starts;
  sheared[0].from_seat(0, 1) = 0.1;
  EXPECT_ERROR(step.begin(sheared, c.rates, c.rates),
               "MechanismStep: from_seat of joint 0 must be a rotation");
  VectorXd force(size);
  EXPECT_ERROR(step.turn(VectorXd(2), force),
               "MechanismStep: the size of rates_at_end must be 6, not 2");
  MechanismStep fresh(joints, size);
  EXPECT_ERROR(fresh.turn(c.rates, force),
               "MechanismStep: weigh() and begin() must come before turn()");
  EXPECT_ERROR(fresh.holding_force(c.rates, c.rates),
               "MechanismStep: weigh() must come before holding_force()");
  // As step() refuses them.
  step.weigh(-c.inertia, none, nothing, dt);
  force.setZero();
  EXPECT_TRUE(has_text(error_message([&] { step.turn(c.at_end, force); }),
                       "positive definite"));
}

}  // namespace
}  // namespace contact::test::mechanism_step_test
