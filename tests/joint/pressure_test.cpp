// Joints with every pressure law.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "libcontact/base/linear/turn.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/joint/group.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/moment_set.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/factory.hpp"
#include "support/accuracy_report.hpp"

namespace contact::test::pressure_test {
namespace {

using Eigen::Vector3d;

ElasticPair unlike_pair() { return ElasticPair({2e11, 0.3}, {1.1e11, 0.35}); }

Joint ball_joint(const std::string& pressure, const FrictionModel& friction) {
  const ElasticPair pair = unlike_pair();
  const JointKind kind = JointKind::ball;
  return Joint({JointGeometry::ball(0.05, 0.05e-3), pair, friction,
                make_half_angle_law("exact", kind, pair),
                make_pressure_law(pressure, kind, pair)});
}

Joint pin_joint(const std::string& pressure, const FrictionModel& friction) {
  const ElasticPair pair = unlike_pair();
  const JointKind kind = JointKind::pin;
  return Joint({JointGeometry::pin(0.05, 0.05e-3, 0.1), pair, friction,
                make_half_angle_law("exact", kind, pair),
                make_pressure_law(pressure, kind, pair)});
}

Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

double vector_error(const Vector3d& computed, const Vector3d& expected) {
  return (computed - expected).norm() / expected.norm();
}

TEST(JointPressure, BallSolvesItsEquationAndKeepsItsVectors) {
  for (const std::string& name : pressure_law_names()) {
    // f/tan g of the solver's own tolerance.
    AccuracyReport residual(name + ": f/tan g", 1e-12);
    AccuracyReport balance(name + ": R = R_n n + R_t", 1e-12);
    AccuracyReport turned(name + ": rotation", 1e-11);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 300; ++i) {
      const FrictionLaw friction(1.5 * uniform(random),
                                 i % 3 == 0 ? 0 : 1e8 * uniform(random));
      const Joint joint = ball_joint(name, friction);
      const double force = std::pow(10, 2 + 5 * uniform(random));
      const Vector3d reaction = force * random_direction(random);
      const Vector3d rate = 3 * random_direction(random);
      const JointSolution s = joint.solve({reaction, rate});
      const std::string row = name + " " + std::to_string(i);
      ASSERT_EQ(s.status, Status::ok) << row;
      EXPECT_LE(s.power, 0) << row;
      const auto f =
          friction_integrals(joint.contact().pressure_law(), s.half_angle,
                             {s.slip_axis.sin, s.slip_axis.cos});
      const double rho2 = 0.05 * 0.05;
      const double expected =
          friction.coefficient() * f.coefficient.force +
          friction.adhesion() * rho2 / s.normal_force * f.area.force;
      residual.add(s.force_coefficient, expected, row);
      balance.add_error(
          vector_error(s.normal_force * s.normal + s.friction_force, reaction),
          row);
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(2.1, random_direction(random)).toRotationMatrix();
      const JointSolution other = joint.solve({turn * reaction, turn * rate});
      turned.add_error(
          vector_error(other.friction_moment, turn * s.friction_moment), row);
    }
  }
}

TEST(JointPressure, SmallContactsDoNotSeeThePressure) {
  // theta0 -> 0, a = 0, A = 0: M = rho R f/sqrt(1 + f^2). At R = 1e-6 N
  // theta0 is 1e-2 deg, 1 - cos theta0 some 1e-8.
  const double f = 0.3;
  for (const std::string& name : pressure_law_names()) {
    const JointSolution s =
        ball_joint(name, FrictionLaw(f))
            .solve({Vector3d(1e-6, 0, 0), Vector3d(0, 0, 1)});
    EXPECT_LT(s.half_angle, 0.02 * degree) << name;
    EXPECT_NEAR(s.friction_moment.norm() / (0.05 * 1e-6 * f / std::hypot(1, f)),
                1, 1e-7)
        << name;
  }
}

TEST(JointPressure, PlanarDiscOfHertz) {
  // a = 90 deg, small theta0: the moment of a disc under its pressure,
  // (3 pi/16) theta0 rho f0 R_n for Hertz', 8/15 for a paraboloid,
  // 2/3 where it is even.
  for (const std::string& name : pressure_law_names()) {
    const JointSolution s =
        ball_joint(name, FrictionLaw(0.2))
            .solve_contact({Vector3d(0, 0, 1), Vector3d(0, 0, 1)});
    const double factor = name == "cosine" ? 8.0 / 15
                          : name == "worn" ? 2.0 / 3
                                           : 3 * std::numbers::pi / 16;
    // theta0 is 0.9 deg here: theta0^2 is 3e-4, and the mixture has 0.6 % of
    // the cosine pressure in it.
    EXPECT_NEAR(s.spinning_coefficient / (0.2 * s.half_angle * factor), 1, 2e-3)
        << name;
  }
}

TEST(JointPressure, SpinningMomentShowsTheChoice) {
  // Under a known normal force, spinning: 10 to 20 % more by the exact
  // pressure than by the cosine one.
  const FrictionLaw friction(0.1);
  for (const double force : {1e3, 1e5, 1e7}) {
    const auto moment = [&](const char* name) {
      return ball_joint(name, friction)
          .solve_contact({Vector3d(0, 0, force), Vector3d(0, 0, 1)})
          .friction_moment.norm();
    };
    const double excess = moment("exact") / moment("cosine") - 1;
    EXPECT_GT(excess, 0.09) << force;
    EXPECT_LT(excess, 0.21) << force;
    EXPECT_NEAR(moment("mixture") / moment("exact"), 1, 0.015) << force;
  }
}

TEST(JointPressure, MomentsAreTheGradientOfThePotential) {
  for (const std::string& name : pressure_law_names()) {
    // Differences of fourth order; the exact pressure's integrals are good to
    // 3e-9.
    AccuracyReport report(name + ": M = -dPhi/dDw", 1e-8);
    const Joint joint = ball_joint(name, FrictionLaw(0.3, 2e7));
    std::mt19937 random(5);
    for (const double theta0_deg : {10.0, 45.0, 80.0}) {
      const MomentSet set(joint.contact(), Vector3d::UnitZ(), 1e5,
                          theta0_deg * degree);
      for (int i = 0; i < 5; ++i) {
        const Vector3d rate = random_direction(random);
        Vector3d gradient;
        const double h = 1e-4;
        for (int k = 0; k < 3; ++k) {
          const Vector3d e = h * Vector3d::Unit(k);
          gradient[k] =
              (8 * (set.support(rate + e) - set.support(rate - e)) -
               (set.support(rate + 2 * e) - set.support(rate - 2 * e))) /
              (12 * h);
        }
        const Vector3d moment = set.moment(rate);
        report.add_error(vector_error(moment, -gradient), name);
        // On the edge of the set.
        EXPECT_NEAR(set.utilisation(moment), 1, 1e-8) << name;
      }
    }
  }
}

TEST(JointPressure, RestAndProxWork) {
  for (const std::string& name : pressure_law_names()) {
    const Joint joint = ball_joint(name, FrictionLaw(0.3, 2e7));
    const Vector3d reaction(3e4, 1e4, -2e4);
    const JointSolution slip = joint.solve({reaction, Vector3d(0.2, -1, 0.4)});
    const auto rest = joint.at_rest({reaction, 0.5 * slip.friction_moment});
    EXPECT_EQ(rest.status, Status::ok) << name;
    EXPECT_NEAR(rest.utilisation, 0.5, 1e-8) << name;
    const MomentSet set(joint.contact(), Vector3d::UnitX(), 1e4, 30 * degree);
    const auto prox =
        set.prox(Eigen::Matrix3d::Identity(), 2e3 * Vector3d(1, 2, -1));
    EXPECT_EQ(prox.status, Status::ok) << name;
  }
}

TEST(JointPressure, PinTakesTheForceRatio) {
  const double f0 = 0.2;
  for (const std::string& name : pressure_law_names()) {
    const Joint joint = pin_joint(name, FrictionLaw(f0, 3e6));
    const JointSolution s = joint.solve({{1e5, 2e5, 0}, {0, 0, 2}});
    ASSERT_EQ(s.status, Status::ok) << name;
    const double ratio =
        joint.contact().pressure_law().force_ratio(s.half_angle);
    const double moment = 0.05 * (f0 * s.normal_force * ratio +
                                  2 * 3e6 * 0.05 * 0.1 * s.half_angle);
    EXPECT_NEAR(-s.friction_moment.z() / moment, 1, 1e-12) << name;
  }
}

TEST(JointPressure, ViscousJoints) {
  for (const std::string& name : pressure_law_names()) {
    const Joint joint = ball_joint(name, ViscousLaw(1e3, 0.02));
    const JointSolution s =
        joint.solve({Vector3d(1e4, 3e4, -2e4), Vector3d(5, -2, 4)});
    EXPECT_EQ(s.status, Status::ok) << name;
    EXPECT_LT(s.power, 0) << name;
  }
}

TEST(JointPressure, NodesMixPressures) {
  const JointGroup group({{ball_joint("exact", FrictionLaw(0.2)), 0.0},
                          {pin_joint("mixture", FrictionLaw(0.1)), 0.4}});
  JointGroup::Solution s = group.make_solution();
  group.solve({.reaction = {1e4, 2e4, 5e3},
               .moment = {100, -300, 0},
               .axis = Vector3d::UnitZ(),
               .angular_velocity = 1.5},
              s);
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_LT(s.power, 0);
}

TEST(JointPressure, HalfAnglesBeyondTheTableAreThoseOfInterference) {
  // A half-angle law may go beyond the 120 deg of the usual table; nothing
  // jumps there.
  const ElasticPair pair = unlike_pair();
  HalfAngleOptions options;
  options.limit_half_angle = 150 * degree;
  const Joint joint(
      {JointGeometry::ball(0.05, 0.05e-3), pair, FrictionLaw(0.1),
       make_half_angle_law("tanh", JointKind::ball, pair, options),
       make_pressure_law("exact", JointKind::ball, pair)});
  const auto moment = [&joint](double half_angle) {
    const double load = joint.contact()
                            .half_angle_law()
                            .load_parameter(half_angle)
                            .load_parameter;
    const double force = load / joint.contact().load_parameter(1);
    const JointSolution s =
        joint.solve_contact({Vector3d(0, 0, force), Vector3d(0, 1, 1)});
    return s.friction_moment.norm() / force;
  };
  EXPECT_GT(moment(149 * degree), moment(121 * degree));
  EXPECT_NEAR(moment(120.0001 * degree) / moment(119.9999 * degree), 1, 1e-5);
  EXPECT_TRUE(joint.contact().validity_notes().empty());
  // An exact half-angle law ends where the exact pressure does.
  const ElasticPair soft({1e8, 0.49}, {2e11, 0.3});
  const Joint same({JointGeometry::ball(0.05, 0.05e-3), soft, FrictionLaw(0.1),
                    make_half_angle_law("exact", JointKind::ball, soft),
                    make_pressure_law("exact", JointKind::ball, soft)});
  EXPECT_TRUE(same.contact().validity_notes().empty());
}

// The ball or pin of the one body is pressed into the other one's seat there:
// pressures add up to the normal force and p v to its integral.
TEST(JointAnswers, PressuresAndPvAreThoseOfTheContact) {
  constexpr double radius = 0.05;
  const Vector3d reaction(0, 3e5, 0);
  const Vector3d rate(0, 1, 0.4);
  for (const JointBody inner : {JointBody::carrier, JointBody::body}) {
    const ElasticPair pair = unlike_pair();
    const Joint joint({JointGeometry::ball(radius, 0.05e-3, inner), pair,
                       FrictionLaw(0.1),
                       make_half_angle_law("exact", JointKind::ball, pair),
                       make_pressure_law("exact", JointKind::ball, pair)});
    const JointSolution s = joint.solve({reaction, rate});
    const Vector3d to_contact =
        inner == JointBody::carrier ? s.normal : Vector3d(-s.normal);
    const Eigen::Quaterniond turn =
        detail::turn_between(Vector3d::UnitZ(), to_contact);
    const auto speed = [&](const Vector3d& place) {
      return radius * rate.cross(place).norm();
    };
    std::vector<Vector3d> places;
    std::vector<double> areas;
    constexpr int rings = 200;
    constexpr int parts = 60;
    for (int i = 0; i < rings; ++i) {
      const double theta = s.half_angle * (i + 0.5) / rings;
      for (int k = 0; k < parts; ++k) {
        const double phi = 2 * std::numbers::pi * k / parts;
        places.push_back(turn * Vector3d(std::sin(theta) * std::cos(phi),
                                         std::sin(theta) * std::sin(phi),
                                         std::cos(theta)));
        areas.push_back(radius * radius * std::sin(theta) * s.half_angle /
                        rings * 2 * std::numbers::pi / parts);
      }
    }
    const std::vector<double> pressures = joint.pressures(s, places);
    Vector3d force = Vector3d::Zero();
    double pv = 0;
    double largest = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      force += pressures[i] * areas[i] * places[i];
      pv += pressures[i] * areas[i] * speed(places[i]);
      largest = std::max(largest, pressures[i] * speed(places[i]));
    }
    // Error of the sum over the root at the edge.
    EXPECT_LT((force / s.normal_force - to_contact).norm(), 3e-4);
    const ContactPv found = joint.pv(s, rate);
    EXPECT_NEAR(found.total / pv, 1, 3e-4);
    const Vector3d place[] = {found.place, -to_contact};
    const std::vector<double> there = joint.pressures(s, place);
    EXPECT_NEAR(found.largest / (there[0] * speed(found.place)), 1, 1e-9);
    EXPECT_GE(found.largest, largest * (1 - 1e-9));
    EXPECT_NEAR(found.largest / largest, 1, 1e-3);
    EXPECT_GT((found.place - to_contact).norm(), 0.05);
    EXPECT_EQ(there[1], 0);
  }
}

// Without a load too, all round.
TEST(JointAnswers, PressedJointsHaveTheirPressure) {
  const ElasticPair pair = unlike_pair();
  const Joint pin({JointGeometry::pin(0.05, -1e-6, 0.1), pair, FrictionLaw(0.1),
                   make_half_angle_law("exact", JointKind::pin, pair),
                   make_pressure_law("exact", JointKind::pin, pair)});
  const Vector3d z = Vector3d::UnitZ();
  const JointSolution s = pin.solve({Vector3d::Zero(), z, z});
  const Vector3d places[] = {{1, 0, 0}, {-0.6, 0.8, 0}};
  const double pressed = pin.contact().interference_pressure();
  EXPECT_GT(pressed, 0);
  for (const double p : pin.pressures(s, places)) {
    EXPECT_NEAR(p, pressed, 1e-12 * pressed);
  }
}

}  // namespace
}  // namespace contact::test::pressure_test
