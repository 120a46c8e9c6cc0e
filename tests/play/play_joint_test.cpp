#include "libcontact/play/play_joint.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "play/reference_joint.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"

// A joint with play as a force law: its balances, its derivatives, its friction
// against the joint without play.
namespace contact::test::play_joint_test {
namespace {

using namespace contact;
using Eigen::Vector3d;

JointSpec ball_spec(double adhesion) {
  JointSpec spec = test::steel_ball();
  spec.friction = FrictionLaw(0.15, adhesion);
  return spec;
}
JointSpec pin_spec(double adhesion) {
  JointSpec spec = test::slider_crank_joint();
  spec.friction = FrictionLaw(0.15, adhesion);
  return spec;
}

// Regularised at a speed within the range of the motions below, so that all
// derivatives are of one size.
const PlayJoint& joint(JointKind kind) {
  const PlayJoint::Options options = {HuntCrossley::from_restitution(0.7, 0.5),
                                      0.05};
  static const PlayJoint ball(ball_spec(2e6), options);
  static const PlayJoint pin(pin_spec(2e6), options);
  return kind == JointKind::ball ? ball : pin;
}

// Touching, at speeds of some impacts.
class Motions {
 public:
  explicit Motions(JointKind kind) : joint_(joint(kind)) {}
  PlayMotion next() {
    const auto vector = [&] {
      return Vector3d(normal_(random_), normal_(random_), normal_(random_));
    };
    PlayMotion motion;
    motion.axis = vector().normalized();
    const ForceLaw& law = joint_.force_law();
    const double eps = law.geometry().radial_clearance();
    Vector3d way = vector();
    if (law.geometry().kind() == JointKind::pin) {
      way -= motion.axis.dot(way) * motion.axis;
    }
    const double share =
        std::uniform_real_distribution<double>(-6, -0.5)(random_);
    const double delta = law.largest_penetration() * std::exp(share);
    motion.position = (eps + delta) * way.normalized();
    if (law.geometry().kind() == JointKind::pin) {
      motion.position += 0.01 * normal_(random_) * motion.axis;
    }
    motion.velocity = 0.05 * vector();
    motion.angular_velocity = 20 * vector();
    return motion;
  }

 private:
  const PlayJoint& joint_;
  std::mt19937 random_{5};
  std::normal_distribution<double> normal_;
};

TEST(PlayJointIdentity, DerivativesAreThoseOfForceAndMoment) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const PlayJoint& of = joint(kind);
    Motions motions(kind);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const PlayMotion motion = motions.next();
      PlayDerivatives derivatives;
      const PlayForce with = of(motion, derivatives);
      const PlayForce without = of(motion);
      // The penetration is a difference, with roundings of its own.
      EXPECT_LT((with.force - without.force).norm(),
                1e-10 * without.force.norm());
      EXPECT_LT((with.moment - without.moment).norm(),
                1e-10 * (without.moment.norm() + 1e-3));
      const double steps[3] = {1e-5 * of.penetration(motion), 1e-6, 1e-4};
      for (int k = 0; k < 9; ++k) {
        const double step = steps[k / 3];
        const auto at = [&](double shift) {
          PlayMotion other = motion;
          (k < 3   ? other.position
           : k < 6 ? other.velocity
                   : other.angular_velocity)(k % 3) += shift;
          const PlayForce f = of(other);
          Eigen::Matrix<double, 6, 1> all;
          all << f.force, f.moment;
          return all;
        };
        const Eigen::Matrix<double, 6, 1> slope =
            (at(step) - at(-step)) / (2 * step);
        for (int part = 0; part < 2; ++part) {
          const double size = derivatives.block<3, 9>(3 * part, 0)
                                  .middleCols<3>(k / 3 * 3)
                                  .norm();
          worst = std::max(worst, (derivatives.col(k).segment<3>(3 * part) -
                                   slope.segment<3>(3 * part))
                                          .norm() /
                                      size);
        }
      }
    }
    // The differences have roundings over their steps, and a third order; a
    // ball's friction is differentiated by differences itself.
    std::printf("derivatives of a %s: %.1e\n", to_string(kind).c_str(), worst);
    EXPECT_LT(worst, kind == JointKind::ball ? 1e-6 : 1e-7);
  }
}

// N = F (1 + a d delta/dt) while it is positive: bodies that part do not hold
// each other, however fast they are driven apart.
TEST(PlayJointIdentity, PartingNeverPulls) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const PlayJoint& of = joint(kind);
    const double a = of.damping().damping();
    ASSERT_GT(a, 0);
    Motions motions(kind);
    for (int i = 0; i < 50; ++i) {
      PlayMotion motion = motions.next();
      Vector3d n = motion.position;
      if (kind == JointKind::pin) n -= motion.axis.dot(n) * motion.axis;
      n.normalize();
      for (const double share : {0.5, 0.99, 1.01, 3., 100.}) {
        motion.velocity = -share / a * n;
        const double elastic = of.force_law().force(of.penetration(motion));
        const double expected = std::max(0., 1 - share) * elastic;
        PlayDerivatives derivatives;
        for (const PlayForce& f : {of(motion), of(motion, derivatives)}) {
          // The rate is a product of vectors that are 1 to their rounding.
          EXPECT_NEAR(f.normal_force, expected, 1e-12 * share * elastic);
          EXPECT_GE(f.normal_force, 0);
          EXPECT_NEAR(-f.force.dot(n), expected, 1e-9 * f.force.norm());
        }
      }
    }
  }
}

TEST(PlayJointIdentity, PowersAddUpAndNoneIsPositive) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const PlayJoint& of = joint(kind);
    Motions motions(kind);
    for (int i = 0; i < 500; ++i) {
      const PlayMotion motion = motions.next();
      const PlayForce f = of(motion);
      const double rate = of.penetration_rate(motion);
      const double elastic = -of.force_law().force(f.penetration) * rate;
      const double power =
          f.force.dot(motion.velocity) + f.moment.dot(motion.angular_velocity);
      EXPECT_NEAR(power, elastic + f.damping_power + f.friction_power,
                  1e-12 * (std::abs(elastic) + std::abs(power)));
      EXPECT_LE(f.damping_power, 0);
      // A ball's centre that moves round is passive up to its curvature.
      const double slack = kind == JointKind::ball
                               ? 0.2 * f.normal_force * motion.velocity.norm()
                               : 0;
      EXPECT_LE(f.friction_power, slack);
      EXPECT_GE(f.normal_force, 0);
      // The same force at the same point, about the seat's centre.
      const Vector3d seat = f.seat_moment(motion);
      EXPECT_LT((seat + f.moment + motion.position.cross(f.force)).norm(),
                1e-15 * (1 + f.force.norm()));
    }
  }
}

// Turning about its own centre, far above vs: the support function of the set
// of moments that a ball holds, and the pin's own moment.
TEST(PlayJointIdentity, FrictionOfATurningJointIsThatWithoutPlay) {
  const JointSpec spec = ball_spec(2e6);
  const PlayJoint ball(spec, {{}, 1e-9});
  Motions motions(JointKind::ball);
  for (int i = 0; i < 50; ++i) {
    PlayMotion motion = motions.next();
    motion.velocity.setZero();
    const PlayForce f = ball(motion);
    const double support =
        ball.moment_set(motion).support(motion.angular_velocity);
    EXPECT_NEAR(-f.friction_power / support, 1, 2e-6);
  }
  const PlayJoint pin(pin_spec(2e6), {{}, 1e-9});
  Motions pin_motions(JointKind::pin);
  const JointContact contact = pin_spec(2e6).contact();
  for (int i = 0; i < 50; ++i) {
    PlayMotion motion = pin_motions.next();
    motion.velocity.setZero();
    const PlayForce f = pin(motion);
    const ForceState at = pin.force_law().at(f.penetration);
    const double rho = 0.0095;
    const double expected = rho * (0.15 * at.force * at.force_ratio +
                                   2e6 * contact.area(at.half_angle));
    EXPECT_NEAR(f.moment.norm() / expected, 1, 1e-12);
    EXPECT_LT(f.moment.dot(motion.angular_velocity), 0);
    const FrictionBounds bounds = pin.friction_bounds(motion);
    EXPECT_NEAR((rho * bounds.force + bounds.moment) / expected, 1, 1e-12);
  }
}

// The formula of disc.csv.
TEST(PlayJointIdentity, PinHasTwoPartsOfFriction) {
  const PlayJoint pin(pin_spec(0), {HuntCrossley(0.4), 0.02});
  const ForceLaw& law = pin.force_law();
  const double rho = 0.0095;
  const double delta = 4e-6;
  // Rolling: the contact's centre hardly slips, and the sign of its slip
  // differs from the turning's.
  const PlayMotion motion = {
      {0.0005 + delta, 0, 0}, {0.01, -0.2, 0}, {0, 0, 20}};
  const PlayForce f = pin(motion);
  const double n = law.force(delta) * (1 + 0.4 * 0.01);
  const double slip = rho * 20 - 0.2;
  const double t = -0.15 * n * slip / std::hypot(slip, 0.02);
  EXPECT_NEAR(f.force.x(), -n, 1e-12 * n);
  EXPECT_NEAR(f.force.y(), t, 1e-12 * n);
  const double own = -0.15 * n * rho * (law.force_ratio(delta) - 1) *
                     (rho * 20) / std::hypot(rho * 20, 0.02);
  EXPECT_NEAR(f.moment.z(), rho * t + own, 1e-12 * n * rho);
  EXPECT_LT(f.friction_power, 0);
}

TEST(PlayJointContract, FreeBeyondAndAtRest) {
  const PlayJoint& pin = joint(JointKind::pin);
  PlayMotion motion = {{0.0004, 0, 0}, {1, 1, 0}, {0, 0, 5}};
  PlayDerivatives derivatives;
  EXPECT_EQ(pin(motion, derivatives).force.norm(), 0);
  EXPECT_EQ(derivatives.norm(), 0);
  EXPECT_NEAR(pin.penetration(motion), -1e-4, 1e-18);
  EXPECT_EQ(pin.penetration_rate(motion), 1);
  motion.position.x() = 0.0005 + 2 * pin.force_law().largest_penetration();
  EXPECT_TRUE(std::isnan(pin(motion).force.x()));
  EXPECT_EQ(pin.notes(motion).size(), 1u);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const PlayJoint& of = joint(kind);
    const double eps = of.force_law().geometry().radial_clearance();
    PlayMotion rest = {{eps * 1.01, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const PlayForce f = of(rest, derivatives);
    EXPECT_NEAR(f.force.x(), -of.force_law().force(f.penetration), 1e-6);
    EXPECT_EQ(f.moment.norm(), 0);
    EXPECT_TRUE(derivatives.allFinite());
    EXPECT_GT(derivatives.rightCols<3>().norm(), 0);
    const std::size_t before = test::allocation_count();
    of(rest);
    of(rest, derivatives);
    EXPECT_EQ(test::allocation_count(), before);
  }
  // Wide, and hardly turning.
  const PlayJoint& ball = joint(JointKind::ball);
  const double wide = 0.9 * ball.force_law().largest_penetration();
  const PlayMotion rolls = {{1e-4 + wide, 0, 0}, {0, 0.1, 0}, {0, 0, 10}};
  ASSERT_EQ(ball.notes(rolls).size(), 1u);
  EXPECT_TRUE(ball.notes(rolls)[0].starts_with("a half-angle of "));
  const PlayMotion turns = {{1e-4 + wide, 0, 0}, {0, 0.001, 0}, {0, 0, 10}};
  EXPECT_TRUE(ball.notes(turns).empty());
}

TEST(PlayJointContract, RefusesOtherFrictionAndSpeeds) {
  JointSpec viscous = test::steel_ball();
  viscous.friction = ViscousLaw(1e3);
  EXPECT_ERROR(PlayJoint(viscous, {}),
               "ball joint with play requires dry friction");
  EXPECT_ERROR(PlayJoint(ball_spec(0), {{}, 0}),
               "joint with play: regularisation_speed = 0 must be above 0 m/s");
  // Without friction it has no part.
  EXPECT_ERROR(PlayJoint(test::steel_ball(), {{}, 0}), "(no error)");
}

}  // namespace
}  // namespace contact::test::play_joint_test
