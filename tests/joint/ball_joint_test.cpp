#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "libcontact/base/magnitude.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/joint/fixed_point.hpp"
#include "libcontact/joint/joint.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/joint_sweep.hpp"
#include "support/joints.hpp"
#include "support/numbers.hpp"
#include "support/random_slip.hpp"

namespace contact::test::ball_joint_test {
namespace {

using Eigen::Vector3d;

// R at the angle b from Dw = speed z.
Vector3d reaction_at(double force, double b) {
  return {force * std::sin(b), 0, force * std::cos(b)};
}

// Everything that a solution states about itself, on one random input.
struct Check {
  AccuracyReport residual{"f/tan g - 1 of the named contact", 2e-13};
  // Directions and sums of a few products: some roundings each.
  AccuracyReport reaction{"R - R_n n - R_t over R", 1e-12};
  AccuracyReport directions{"n, R_t, w: right angles, lengths", 4e-15};
  AccuracyReport power{"M_t . Dw against power, over rho R |Dw|", 4e-15};

  void add(const RandomSlip& input, const JointSolution& s,
           const std::string& label) {
    ASSERT_EQ(s.status, Status::ok) << label;
    const double force = input.reaction.norm();
    const Vector3d w = input.rate.normalized();
    residual.add_error(true_residual(input.joint, s), label);
    reaction.add_error(
        (s.normal_force * s.normal + s.friction_force - input.reaction).norm() /
            force,
        label);
    directions.add_error(std::abs(s.normal.norm() - 1), label);
    directions.add_error(std::abs(s.normal.dot(w) - s.slip_axis.sin), label);
    directions.add_error(std::abs(s.friction_force.dot(w)) / force, label);
    directions.add_error(std::abs(s.friction_force.dot(s.normal)) / force,
                         label);
    directions.add_error(std::abs(s.friction_force.norm() -
                                  s.force_coefficient * s.normal_force) /
                             force,
                         label);
    const double moment_unit =
        input.joint.contact().geometry().radius() *
        (force * input.rate.norm() *
         (1 + s.sliding_coefficient + std::abs(s.spinning_coefficient)));
    power.add_error(
        std::abs(s.friction_moment.dot(input.rate) - s.power) / moment_unit,
        label);
    EXPECT_LE(s.power, 0) << label;
    EXPECT_LE(s.friction_force.dot(s.slip_velocity), 0) << label;
    const double b = s.reaction_angle();
    // g by atan2 and b by atan2 round once each.
    EXPECT_LE(s.friction_angle(), std::min(b, pi - b) + 4e-16) << label;
    EXPECT_GE(s.friction_angle_margin(), 0) << label;
  }
};

TEST(BallJoint, RandomInputsColdAndWarm) {
  RandomSlips random(1);
  Check cold;
  Check warm;
  for (int i = 0; i < 3000; ++i) {
    RandomSlip input = random.next();
    const std::string label = "input " + std::to_string(i);
    const JointSolution s = input.joint.solve(input.slip());
    cold.add(input, s, label);
    // Moved by a thousandth, and anywhere at all.
    for (const double move : {1e-3, 1.0}) {
      RandomSlip moved = input;
      moved.reaction += move * input.reaction.norm() * random.direction();
      moved.rate += move * input.rate.norm() * random.direction();
      const JointSolution t = moved.joint.solve(moved.slip(), s);
      warm.add(moved, t, label + " moved");
    }
  }
}

// Against their definitions, by the vectors.
TEST(BallJoint, CoefficientsOfTheWholeJointAreThoseOfItsVectors) {
  RandomSlips random(11);
  // Towards pure spinning the direction of the sliding moment, and so the sum
  // of both as vectors, loses digits: roundings over cos a.
  AccuracyReport moment("M_t/(rho R), times cos a", 1e-14);
  AccuracyReport heat("heat over area", 1e-15);  // two roundings
  for (int i = 0; i < 2000; ++i) {
    const RandomSlip input = random.next();
    const JointSolution s = input.joint.solve(input.slip());
    const double rho = input.joint.contact().geometry().radius();
    const std::string label = "input " + std::to_string(i);
    const double expected =
        magnitude(s.friction_moment) / magnitude(s.reaction) / rho;
    moment.add_error(
        s.slip_axis.cos * relative_error(s.moment_coefficient(), expected),
        label);
    heat.add(s.mean_heat_flux(),
             -s.power / input.joint.contact().area(s.half_angle), label);
  }
}

// The directions as in the paper's geometry, tan g/tan b and all: another
// way to the same vectors.
TEST(BallJoint, DirectionsFromFrictionAngle) {
  RandomSlips random(2);
  AccuracyReport normal("n by g and b", 1e-11);
  AccuracyReport moment("M_t by n", 1e-11);
  for (int i = 0; i < 2000; ++i) {
    const RandomSlip input = random.next();
    const JointSolution s = input.joint.solve(input.slip());
    const double b = s.reaction_angle();
    const double side =
        input.joint.contact().geometry().inner_body() == JointBody::carrier
            ? 1
            : -1;
    // The closed form loses digits at the ends of b and where g -> b.
    if (std::sin(b) < 1e-3 || s.friction_angle_margin() < 1e-3) continue;
    const Vector3d e = input.reaction.normalized();
    const Vector3d w = input.rate.normalized();
    const Vector3d wp = (w - e * std::cos(b)) / std::sin(b);
    const double ratio = s.force_coefficient / std::tan(b);
    const Vector3d m =
        ratio * wp - side * std::sqrt((1 - ratio) * (1 + ratio)) * e.cross(wp);
    const double g = s.friction_angle();
    const Vector3d n = e * std::cos(g) + m * std::sin(g);
    normal.add_error((n - s.normal).norm(), "input " + std::to_string(i));
    const JointSolution forward =
        input.joint.solve_contact({s.normal_force * n, input.rate});
    if (s.power == 0) continue;  // no friction
    moment.add_error((forward.friction_moment - s.friction_moment).norm() /
                         s.friction_moment.norm(),
                     "input " + std::to_string(i));
  }
}

// Largest change of the parts of a solution over their sizes.
double difference(const JointSolution& s, const JointSolution& t) {
  const auto part = [](const Vector3d& a, const Vector3d& b) {
    return a == b ? 0 : magnitude(a - b) / magnitude(a);
  };
  return std::max(
      {(s.normal - t.normal).norm(),
       (s.friction_force - t.friction_force).norm() / s.reaction.norm(),
       part(s.friction_moment, t.friction_moment),
       std::abs(s.normal_force - t.normal_force) / s.reaction.norm()});
}

TEST(BallJoint, TurningRAndDwTurnsTheResult) {
  RandomSlips random(3);
  // The rotation rounds R and Dw. Where the result depends on them more than in
  // proportion (adhesion near b = 90 deg, tiny contacts near a = 90 deg),
  // rounding grows by this factor, which is also measured.
  AccuracyReport plain("turned result, condition below 10", 1e-13);
  AccuracyReport scaled("turned result over condition", 1e-14);
  for (int i = 0; i < 3000; ++i) {
    const RandomSlip input = random.next();
    const JointSolution s = input.joint.solve(input.slip());
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(pi * random.uniform(), random.direction())
            .toRotationMatrix();
    JointSolution t =
        input.joint.solve({turn * input.reaction, turn * input.rate});
    for (Vector3d* v : {&t.normal, &t.friction_force, &t.friction_moment}) {
      *v = turn.transpose() * *v;
    }
    double condition = 1;
    for (int k = 0; k < 3; ++k) {
      constexpr double move = 1e-12;
      const Vector3d moved =
          input.reaction + move * input.reaction.norm() * random.direction();
      condition = std::max(
          condition,
          difference(s, input.joint.solve({moved, input.rate})) / move);
    }
    const std::string label = "input " + std::to_string(i);
    if (condition < 10) plain.add_error(difference(s, t), label);
    scaled.add_error(difference(s, t) / condition, label);
  }
  EXPECT_GT(plain.size(), 1000u);
}

// Swapping the ball mirrors n, R_t and M_t in the plane of R and Dw.
TEST(BallJoint, BallOnLoadMirrorsBallOnCarrier) {
  RandomSlips random(4);
  for (int i = 0; i < 200; ++i) {
    const Vector3d reaction = random.log_uniform(1, 1e7) * random.direction();
    const Vector3d rate = random.direction();
    const double f0 = random.uniform();
    const double adhesion = random.log_uniform(1e3, 1e10);
    const JointSolution s =
        steel_ball(FrictionLaw(f0, adhesion), JointBody::carrier)
            .solve({reaction, rate});
    const JointSolution t =
        steel_ball(FrictionLaw(f0, adhesion), JointBody::body)
            .solve({reaction, rate});
    const Vector3d plane = reaction.cross(rate).normalized();
    const Eigen::Matrix3d mirror =
        Eigen::Matrix3d::Identity() - 2 * plane * plane.transpose();
    // Some roundings of the directions.
    EXPECT_LE((mirror * s.normal - t.normal).norm(), 1e-14);
    EXPECT_LE((mirror * s.friction_force - t.friction_force).norm(),
              1e-14 * reaction.norm());
    EXPECT_LE((mirror * s.friction_moment - t.friction_moment).norm(),
              1e-14 * s.friction_moment.norm());
    EXPECT_EQ(s.normal_force, t.normal_force);
    EXPECT_EQ(s.power, t.power);
  }
}

TEST(BallJoint, OppositeRateOpposesMoment) {
  RandomSlips random(5);
  for (int i = 0; i < 200; ++i) {
    const RandomSlip input = random.next();
    const JointSolution s = input.joint.solve(input.slip());
    const JointSolution t = input.joint.solve({input.reaction, -input.rate});
    // Turning R and Dw by pi about R x Dw maps one state on the other's
    // mirror: the sizes agree, up to the rounding of the solve.
    EXPECT_NEAR(t.normal_force / s.normal_force, 1, 1e-12);
    if (s.power < 0) {
      EXPECT_NEAR(t.power / s.power, 1, 1e-12);
    }
    EXPECT_EQ(t.slip_axis.sin, -s.slip_axis.sin);
  }
}

// The margin b - g against long double, where that has digits left.
TEST(BallJoint, MarginKeepsItsDigits) {
  RandomSlips random(6);
  AccuracyReport margin("min(b, pi - b) - g", 1e-12);
  int small = 0;
  for (int i = 0; i < 4000; ++i) {
    const RandomSlip input = random.next();
    const JointSolution s = input.joint.solve(input.slip());
    // sin g = sin b sin psi and the solver's own tan psi, in 64 bits.
    const long double t = s.memory.tangent;
    const long double sb = s.memory.reaction.sin;
    const long double cb = s.memory.reaction.cos;
    const long double b = std::atan2(sb, cb);
    const long double g =
        std::atan2(sb * t, std::sqrt(cb * cb * (1 + t * t) + sb * sb));
    const long double expected = b - g;
    if (!(expected > 1e-6L * b) || t == 0) continue;
    small += expected < 1e-3L * b;
    margin.add_error(
        static_cast<double>(std::abs(s.friction_angle_margin() / expected - 1)),
        "input " + std::to_string(i));
  }
  EXPECT_GT(small, 20);  // the case that the test is for occurs
}

// theta0 -> 0, A = 0, a = 0: Coulomb friction of a point, M = rho R_t.
TEST(BallJoint, TinyContactIsCoulombs) {
  for (const double f : {1e-3, 0.1, 1.0, 5.0}) {
    const Joint joint = steel_ball(FrictionLaw(f, 0));
    const double force = 1e-9;  // theta0 = 1e-5 rad: its square is rounding
    const JointSolution s = joint.solve({{force, 0, 0}, {0, 0, 1}});
    const double expected = 0.05 * force * f / std::sqrt(1 + f * f);
    EXPECT_NEAR(s.friction_moment.norm() / expected, 1, 1e-9);
    EXPECT_NEAR(s.force_coefficient / f, 1, 1e-9);
  }
}

// Viscous friction of constant k through the same solver: force and moments
// are closed forms in theta0 and a (section 3.1 of the paper).
TEST(BallJoint, ViscousFrictionHasItsClosedForms) {
  RandomSlips random(9);
  AccuracyReport force("R_t", 1e-12);
  AccuracyReport moment("M_t", 1e-12);
  AccuracyReport balance("R - R_n n - R_t over R", 1e-14);
  for (int i = 0; i < 500; ++i) {
    const double k0 = random.log_uniform(1e3, 1e9);
    const Joint joint = steel_ball(ViscousLaw(k0));
    const Vector3d reaction = random.log_uniform(1e2, 1e6) * random.direction();
    const Vector3d rate = random.log_uniform(1e-3, 10) * random.direction();
    const JointSolution cold = joint.solve({reaction, rate});
    const JointSolution s = joint.solve({reaction, 1.001 * rate}, cold);
    ASSERT_EQ(s.status, Status::ok);
    const double rho = 0.05;
    const double c = std::cos(s.half_angle);
    const double unit = k0 * rho * rho * rho * 1.001 * rate.norm();
    const double sine = std::sin(s.half_angle);
    const std::string label = "input " + std::to_string(i);
    force.add(s.friction_force.norm(),
              unit * pi * sine * sine * s.slip_axis.cos, label);
    // j and n span what the moment lies in.
    const double h = std::sin(s.half_angle / 2);
    const double sliding = pi * (4.0 / 3 - c - c * c * c / 3) * s.slip_axis.cos;
    // 2/3 - c + c^3/3 = (1 - c)^2 (2 + c)/3, 1 - c = 2 h^2
    const double spinning =
        2 * pi * 4 * h * h * h * h * (2 + c) / 3 * s.slip_axis.sin;
    moment.add(s.friction_moment.norm(),
               unit * rho * std::hypot(sliding, spinning), label);
    balance.add_error(
        (s.normal_force * s.normal + s.friction_force - reaction).norm() /
            reaction.norm(),
        label);
    EXPECT_LE(s.power, 0);
  }
}

TEST(BallJoint, RestIsAStateOfItsOwn) {
  const Joint joint = steel_ball(FrictionLaw(0.2, 1e8));
  const Vector3d reaction(3e4, -4e4, 0);
  const JointSolution s = joint.solve({reaction, Vector3d::Zero()});
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_EQ(s.state, JointState::resting);
  EXPECT_EQ(s.friction_force, Vector3d::Zero());
  EXPECT_EQ(s.friction_moment, Vector3d::Zero());
  EXPECT_EQ(s.moment_coefficient(), 0);
  EXPECT_EQ(s.mean_heat_flux(), 0);
  EXPECT_EQ(s.power, 0);
  EXPECT_DOUBLE_EQ(s.normal_force, 5e4);
  EXPECT_TRUE(s.normal.isApprox(Vector3d(0.6, -0.8, 0), 1e-15));
  EXPECT_EQ(s.half_angle,
            joint.contact().half_angle(s.normal_force).half_angle);
  EXPECT_GT(s.peak_pressure, 0);
  // However slow, sliding is not rest: friction does not depend on speed.
  const Vector3d rate(0, 0.3, 0.7);
  const JointSolution fast = joint.solve({reaction, rate});
  const JointSolution slow = joint.solve({reaction, 1e-300 * rate});
  EXPECT_EQ(slow.state, JointState::sliding);
  EXPECT_LE((slow.friction_moment - fast.friction_moment).norm(),
            1e-14 * fast.friction_moment.norm());
}

TEST(BallJoint, NoReactionNoContact) {
  const Joint joint = steel_ball(FrictionLaw(0.2, 1e8));
  const JointSolution s = joint.solve({Vector3d::Zero(), {1, 2, 3}});
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_EQ(s.state, JointState::unloaded);
  EXPECT_EQ(s.normal_force, 0);
  EXPECT_EQ(s.half_angle, 0);
  EXPECT_EQ(s.contact_area, 0);
  EXPECT_EQ(s.peak_pressure, 0);
  EXPECT_EQ(s.friction_moment, Vector3d::Zero());
}

// R -> 0 with adhesion: theta0 falls as cbrt(R_n), so adhesion wins, g -> b
// and M_t -> 0; every decade solves.
TEST(BallJoint, FallingReaction) {
  const Joint joint = steel_ball(FrictionLaw(0.1, 1e7));
  double last_moment = infinity;
  for (int decade = 6; decade >= -280; --decade) {
    const JointSolution s =
        joint.solve({reaction_at(std::pow(10.0, decade), 1.0), {0, 0, 1}});
    ASSERT_EQ(s.status, Status::ok) << decade;
    const double moment = magnitude(s.friction_moment);
    EXPECT_LT(moment, last_moment) << decade;
    EXPECT_GT(moment, 0) << decade;
    last_moment = moment;
    if (decade < -20) {
      EXPECT_NEAR(s.friction_angle(), 1.0, 1e-9) << decade;
    }
  }
}

TEST(BallJoint, SpinningAboutTheReaction) {
  const Joint joint = steel_ball(FrictionLaw(0.2, 1e8));
  for (const double sign : {1.0, -1.0}) {
    const JointSolution s = joint.solve({{0, 0, 1e5}, {0, 0, sign}});
    EXPECT_EQ(s.status, Status::ok);
    EXPECT_EQ(s.normal, Vector3d(0, 0, 1));
    EXPECT_EQ(s.normal_force, 1e5);
    EXPECT_EQ(s.friction_force.norm(), 0);
    EXPECT_EQ(s.slip_axis.cos, 0);
    EXPECT_EQ(s.slip_axis.sin, sign);
    EXPECT_EQ(s.slip_velocity.norm(), 0);
    // M_t = -rho (f0 R_n sigma_Z + A rho^2 K[1]) about the axis.
    const auto i = friction_integrals(s.half_angle, SlipAxis{1, 0});
    const double expected = 0.05 * (0.2 * 1e5 * i.coefficient.spinning +
                                    1e8 * 0.05 * 0.05 * i.area.spinning);
    EXPECT_NEAR(s.friction_moment.z(), -sign * expected, 1e-14 * expected);
    // The neighbours go over into it.
    const JointSolution near = joint.solve({{1e-9, 0, 1e5}, {0, 0, sign}});
    EXPECT_LE((near.friction_moment - s.friction_moment).norm(),
              1e-12 * expected);
  }
}

TEST(BallJoint, WithoutFriction) {
  const Joint joint = steel_ball(FrictionLaw(0, 0));
  const Vector3d reaction(1e4, 2e4, -3e4);
  const JointSolution s = joint.solve({reaction, {1, 0, 1}});
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_LE((s.normal - reaction.normalized()).norm(), 1e-15);
  EXPECT_EQ(s.friction_force.norm(), 0);
  EXPECT_EQ(s.friction_moment.norm(), 0);
  EXPECT_EQ(s.power, 0);
  EXPECT_EQ(s.friction_angle(), 0);
  EXPECT_NEAR(s.normal_force, reaction.norm(), 1e-11);
}

TEST(BallJoint, ContactDataFitTheContact) {
  const Joint joint = steel_ball(FrictionLaw(0.1, 0));
  const JointSolution s = joint.solve_contact({{0, 0, 2e5}, {0, 1, 0}});
  // Mean of the normal component of p over the contact's projection is R_n.
  const double c = std::cos(s.half_angle);
  EXPECT_NEAR(s.contact_area, 2 * pi * 0.05 * 0.05 * (1 - c), 1e-15);
  const double amplitude =
      3 * 2e5 / (pi * (1 - c) * (1 - c) * (2 + c)) / (0.05 * 0.05);
  EXPECT_NEAR(s.peak_pressure / (amplitude * (1 - c)), 1, 1e-13);
  EXPECT_TRUE(s.slip_velocity.isApprox(
      0.05 * Vector3d(0, 1, 0).cross(Vector3d(0, 0, 1)), 1e-15));
  EXPECT_NEAR(s.power, -s.sliding_coefficient * 0.05 * 2e5, 1e-9);
}

TEST(BallJoint, FixedPointAgreesWhereItConverges) {
  RandomSlips random(7);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const RandomSlip input = random.next();
    std::vector<FixedPointStep> trace(500);
    const auto result =
        contact::fixed_point(input.joint, input.slip(), trace,
                             {.tolerance = 1e-13, .step_limit = 500});
    if (result.status != Status::ok) continue;
    const JointSolution s = input.joint.solve(input.slip());
    const FixedPointStep& last = trace[result.steps - 1];
    // Contraction q leaves tolerance q/(1 - q), q < 0.95 within 500 steps.
    EXPECT_NEAR(last.normal_force / s.normal_force, 1, 1e-11) << i;
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST(BallJoint, FixedPointReportsWhereItFails) {
  // g grows past b: (4.2) has no a.
  const Joint joint = steel_ball(FrictionLaw(3, 0));
  std::vector<FixedPointStep> trace(10);
  const Vector3d reaction = reaction_at(1e5, 50 * degree);
  EXPECT_EQ(contact::fixed_point(joint, {reaction, {0, 0, 1}}, trace).status,
            Status::out_of_range);
  EXPECT_EQ(joint.solve({reaction, {0, 0, 1}}).status, Status::ok);
  // A short limit.
  EXPECT_EQ(contact::fixed_point(steel_ball(FrictionLaw(0.1, 4e7)),
                                 {reaction, {0, 0, 1}}, trace,
                                 {.tolerance = 1e-12, .step_limit = 3})
                .status,
            Status::not_converged);
}

// Hertz's law ends at a load: friction can bring R_n below it.
TEST(BallJoint, HalfAngleLawWithAnEnd) {
  const auto make = [](double f0) {
    return steel_ball(FrictionLaw(f0), JointBody::carrier, "hertz");
  };
  const double end = 1 / make(1).contact().load_parameter(1);
  const Vector3d rate(0, 0, 1);
  const JointSolution inside = make(1).solve({{1.2 * end, 0, 0}, rate});
  EXPECT_EQ(inside.status, Status::ok);
  EXPECT_LT(inside.normal_force, end);
  EXPECT_LE(true_residual(make(1), inside), 2e-13);
  const JointSolution outside = make(0.1).solve({{1.2 * end, 0, 0}, rate});
  EXPECT_EQ(outside.status, Status::out_of_range);
  EXPECT_TRUE(std::isnan(outside.friction_moment.x()));
}

TEST(BallJoint, NanAndInfinityGiveNan) {
  const Joint joint = steel_ball(FrictionLaw(0.2, 1e8));
  const JointSolution last = joint.solve({{1e4, 2e4, 0}, {0, 1, 1}});
  for (const double bad : {nan, infinity, -infinity}) {
    for (int i = 0; i < 3; ++i) {
      Vector3d reaction(1e4, 2e4, 0);
      Vector3d rate(0, 1, 1);
      reaction[i] = bad;
      for (const JointSolution& s :
           {joint.solve({reaction, rate}), joint.solve({reaction, rate}, last),
            joint.solve_contact({reaction, rate}),
            joint.solve({rate, reaction}),
            joint.solve({reaction, {0, 0, 0}})}) {
        EXPECT_EQ(s.status, Status::out_of_range);
        EXPECT_TRUE(std::isnan(s.normal_force));
        EXPECT_TRUE(s.friction_moment.hasNaN());
        EXPECT_TRUE(std::isnan(s.power));
      }
      std::vector<FixedPointStep> trace(5);
      EXPECT_EQ(contact::fixed_point(joint, {reaction, rate}, trace).status,
                Status::out_of_range);
    }
  }
  // A spoilt solution is no start, and does no harm.
  const JointSolution bad = joint.solve({{nan, 0, 0}, {0, 1, 1}});
  EXPECT_EQ(joint.solve({{1e4, 2e4, 0}, {0, 1, 1}}, bad).status, Status::ok);
}

TEST(BallJoint, KernelsDoNotAllocate) {
  RandomSlips random(8);
  std::vector<RandomSlip> inputs;
  for (int i = 0; i < 50; ++i) inputs.push_back(random.next());
  std::vector<FixedPointStep> trace(20);
  inputs[0].joint.solve(inputs[0].slip());
  const std::size_t before = allocation_count();
  for (const RandomSlip& input : inputs) {
    const JointSolution s = input.joint.solve(input.slip());
    input.joint.solve({1.001 * input.reaction, input.rate}, s);
    input.joint.solve_contact({input.reaction, input.rate});
    contact::fixed_point(input.joint, input.slip(), trace,
                         {.tolerance = 1e-12, .step_limit = 20});
  }
  EXPECT_EQ(allocation_count(), before);
}

TEST(BallJoint, RefusesWhatDoesNotFit) {
  for (const JointKind kind : kinds) {
    const bool is_pin = kind == JointKind::pin;
    const JointKind other = is_pin ? JointKind::ball : JointKind::pin;
    const auto geometry = is_pin ? JointGeometry::pin(0.05, 0.05e-3, 0.1)
                                 : JointGeometry::ball(0.05, 0.05e-3);
    const auto make = [&](JointKind law, JointKind pressure) {
      return error_message([&] {
        Joint({geometry, steel_in_steel, FrictionLaw(0.1),
               make_half_angle_law("tanh", law, steel_in_steel),
               std::make_unique<CosinePressure>(pressure)});
      });
    };
    const std::string joint = to_string(kind) + " joint";
    const std::string end =
        " law for a " + to_string(other) + " joint must be for a " + joint;
    EXPECT_EQ(make(other, kind), joint + ": half-angle" + end);
    EXPECT_EQ(make(kind, other), joint + ": pressure" + end);
    EXPECT_ERROR(
        Joint({geometry, steel_in_steel, FrictionLaw(0.1), nullptr, nullptr}),
        joint + " requires a half-angle law and a pressure law");
  }
}

TEST(JointSweep, RandomInputsAndPaths) {
  const JointSweep sweep = joint_sweep(10000, 11);
  EXPECT_EQ(sweep.inputs, 10000U);
  EXPECT_EQ(sweep.not_ok, 0U);
  EXPECT_LE(sweep.residual, 1e-12) << sweep.worst_residual;
  EXPECT_LE(sweep.reaction, 1e-12);
  EXPECT_EQ(sweep.power, 0);
  // g and b by atan2: one rounding each.
  EXPECT_LE(sweep.angle_excess, 5e-16);
  EXPECT_EQ(sweep.scanned, 10000U);
  // Several roots need contacts beyond the hemisphere
  // (docs/explanation/joint.md).
  EXPECT_GT(sweep.several_roots_limit, std::numbers::pi / 2);
  EXPECT_EQ(sweep.paths, 100U);
  // Inputs 1e-12 apart change the result by some 1e-12.
  EXPECT_LE(sweep.jump, 1e-11);
  EXPECT_EQ(sweep.folds, 0U);
  EXPECT_EQ(sweep.cold.count(), 10000U);
  EXPECT_EQ(sweep.warm.count(), 10000U);
  // The sweep includes inputs on which the fixed point fails or is slow.
  EXPECT_GT(sweep.fixed_point_fails, 100U);
  EXPECT_GT(sweep.fixed_point_slow, 50U);
}

}  // namespace
}  // namespace contact::test::ball_joint_test
