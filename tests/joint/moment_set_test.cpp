#include "libcontact/joint/moment_set.hpp"
#include "libcontact/base/magnitude.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "libcontact/joint/joint.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/joints.hpp"
#include "support/numbers.hpp"
#include "support/random_slip.hpp"

namespace contact::test::moment_set_test {
namespace {

using Prox = MomentSet::Prox;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Random contacts with friction, of all sizes. A set is flat, theta0 times as
// thick along n as wide, and changes over angles of theta0: the rounding of n
// and of vectors given to it counts 1/theta0 times.
struct RandomSet {
  RandomSlip input;
  JointSolution solution;
  MomentSet set() const { return input.joint.moment_set(solution); }
  double thickness() const { return std::min(1.0, solution.half_angle); }
};

std::vector<RandomSet> random_sets(RandomSlips& random, int count) {
  std::vector<RandomSet> sets;
  while (static_cast<int>(sets.size()) < count) {
    RandomSlip input = random.next();
    const JointSolution s = input.joint.solve(input.slip());
    // Sizes of moments whose squares are normal numbers.
    const double moment = magnitude(s.friction_moment);
    if (!(moment > 1e-100 && moment < 1e100)) continue;
    sets.push_back({std::move(input), s});
  }
  return sets;
}

// An inertia with principal moments up to 30 times apart.
Matrix3d random_inertia(RandomSlips& random) {
  const Vector3d from = random.direction(), to = random.direction();
  Eigen::Quaterniond quaternion;
  quaternion.w() = 1 + from.dot(to);
  quaternion.vec() = from.cross(to);
  const Matrix3d turn = quaternion.normalized().toRotationMatrix();
  const Vector3d principal(1, random.log_uniform(1, 30),
                           random.log_uniform(1, 30));
  return random.log_uniform(1e-3, 1e3) * turn * principal.asDiagonal() *
         turn.transpose();
}

// It would refer to a joint that is gone.
template <class Joint>
concept HasMomentSet = requires(Joint joint, const JointSolution& solution) {
  std::forward<Joint>(joint).moment_set(solution);
};
static_assert(HasMomentSet<const Joint&>);
static_assert(!HasMomentSet<Joint>);
static_assert(!std::is_constructible_v<MomentSet, JointContact, Vector3d,
                                       double, double>);

TEST(MomentSet, AgreesWithTheSolutionThatMadeIt) {
  RandomSlips random(1);
  AccuracyReport moment("moment(Dw) against M_t, times theta0^2", 3e-14);
  AccuracyReport power("-Phi(Dw) against power, times theta0", 1e-14);
  for (const RandomSet& r : random_sets(random, 1000)) {
    const MomentSet set = r.set();
    const Vector3d m = set.moment(r.input.rate);
    moment.add_error((m - r.solution.friction_moment).norm() / m.norm() *
                         r.thickness() * r.thickness(),
                     "");
    power.add_error(std::abs(set.support(r.input.rate) / r.solution.power + 1) *
                        r.thickness(),
                    "");
  }
}

TEST(MomentSet, MomentIsMinusTheGradientOfSupport) {
  RandomSlips random(2);
  // Central differences with a step of 1e-5 of the smaller of 1 and theta0,
  // the scale of the set's edge: truncation 1e-10, rounding 1e-15/1e-5.
  AccuracyReport report("-grad Phi against M_t", 1e-8);
  for (const RandomSet& r : random_sets(random, 300)) {
    const MomentSet set = r.set();
    if (r.solution.half_angle < 1e-2) continue;
    const Vector3d u = random.direction();
    const double h = 1e-5;
    Vector3d gradient;
    for (int i = 0; i < 3; ++i) {
      const Vector3d step = h * Vector3d::Unit(i);
      gradient[i] = (set.support(u + step) - set.support(u - step)) / (2 * h);
    }
    const Vector3d m = set.moment(u);
    report.add_error((gradient + m).norm() / m.norm(), "");
  }
}

TEST(MomentSet, SupportIsConvexEvenAndHomogeneous) {
  RandomSlips random(3);
  for (const RandomSet& r : random_sets(random, 300)) {
    const MomentSet set = r.set();
    const Vector3d u = random.direction();
    const Vector3d v = random.log_uniform(1e-3, 1e3) * random.direction();
    const double sum = set.support(u) + set.support(v);
    // The sum of two rounded values.
    EXPECT_LE(set.support(u + v), sum * (1 + 1e-14));
    EXPECT_NEAR(set.support(-u) / set.support(u), 1, 1e-14);
    EXPECT_NEAR(set.support(3 * u) / set.support(u), 3, 1e-13);
    // Maximal dissipation: no other moment of the edge opposes u more.
    EXPECT_LE(-set.moment(v).dot(u), set.support(u) * (1 + 1e-14));
  }
  const RandomSet r = random_sets(random, 1)[0];
  EXPECT_EQ(r.set().support(Vector3d::Zero()), 0);
  EXPECT_TRUE(r.set().moment(Vector3d::Zero()).hasNaN());
}

TEST(MomentSet, UtilisationOfTheEdgeIsOne) {
  RandomSlips random(4);
  AccuracyReport report("utilisation of tau M_t(u), times theta0", 1e-14);
  for (const RandomSet& r : random_sets(random, 1000)) {
    const MomentSet set = r.set();
    const double tau = random.log_uniform(1e-3, 1e3);
    const Vector3d n = r.solution.normal;
    for (const Vector3d& u :
         {random.direction(), n, Vector3d(-n), n.unitOrthogonal(),
          Vector3d(n + 1e-3 * r.solution.half_angle * random.direction())}) {
      report.add_error(
          std::abs(set.utilisation(tau * set.moment(u)) / tau - 1) *
              r.thickness(),
          "");
    }
    EXPECT_EQ(set.utilisation(Vector3d::Zero()), 0);
  }
}

// Conditions of the minimum: the moment is in the set and opposes the motion as
// much as the set allows, alpha . M = -Phi(alpha).
TEST(MomentSet, ProxMeetsItsConditions) {
  RandomSlips random(5);
  AccuracyReport inside("utilisation less 1, times theta0", 1e-14);
  AccuracyReport power("alpha . M + Phi(alpha), over |M| |alpha|", 1e-12);
  AccuracyReport balance("W (alpha - free) - M, over |W free|", 1e-12);
  int held = 0;
  int slid = 0;
  int most_steps = 0;
  for (const RandomSet& r : random_sets(random, 3000)) {
    const MomentSet set = r.set();
    const Matrix3d inertia = random_inertia(random);
    // From well inside to far outside of the set, and close to its edge.
    const Vector3d u = random.direction();
    const double tau = random.uniform() < 0.3
                           ? 1 + random.log_uniform(1e-9, 1e-2)
                           : random.log_uniform(0.1, 1e4);
    const Vector3d wanted = -tau * set.moment(u);
    const Vector3d free = inertia.llt().solve(wanted);
    const Prox p = set.prox(inertia, free);
    ASSERT_EQ(p.status, Status::ok)
        << "tau " << tau << " theta0 " << r.solution.half_angle << " residual "
        << p.residual << " steps " << p.iterations;
    balance.add_error(
        (inertia * (p.angular_velocity - free) - p.moment).norm() /
            wanted.norm(),
        "");
    if (p.angular_velocity.isZero(0)) {
      ++held;
      EXPECT_LE(tau, 1 + 1e-14 / r.thickness());
      continue;
    }
    ++slid;
    most_steps = std::max(most_steps, p.iterations);
    EXPECT_GE(tau, 1 - 1e-14 / r.thickness());
    inside.add_error(
        std::max(0.0, set.utilisation(p.moment) - 1) * r.thickness(), "");
    power.add_error(std::abs(p.angular_velocity.dot(p.moment) +
                             set.support(p.angular_velocity)) /
                        (p.angular_velocity.norm() * p.moment.norm()),
                    "");
  }
  EXPECT_GT(held, 100);
  EXPECT_GT(slid, 1000);
  std::printf("prox: most Newton steps %d\n", most_steps);
}

// Both are differences, over lengths that u near to n has not much more of.
TEST(MomentSet, CurvatureIsTheDerivativeOfTheMoment) {
  RandomSlips random(9);
  AccuracyReport slope("curvature against moments, theta0 times", 1e-4);
  for (const RandomSet& r : random_sets(random, 200)) {
    const MomentSet set = r.set();
    const Vector3d u = random.direction();
    const Matrix3d curvature = set.curvature(u);
    const double step = 1e-4 * r.thickness();
    for (int k = 0; k < 3; ++k) {
      const Vector3d way = step * Vector3d::Unit(k);
      const Vector3d difference =
          (set.moment(u - way) - set.moment(u + way)) / (2 * step);
      slope.add_error(r.thickness() * (curvature.col(k) - difference).norm() /
                          curvature.norm(),
                      "");
    }
  }
}

TEST(MomentSet, ProxFromAGuessIsTheSame) {
  RandomSlips random(10);
  AccuracyReport same("moments over |W free|", 1e-11);
  for (const RandomSet& r : random_sets(random, 300)) {
    const MomentSet set = r.set();
    const Vector3d free = random.direction();
    const double held = set.moment(random.direction()).norm();
    const Matrix3d w =
        random.log_uniform(0.3, 30) * held * Matrix3d::Identity();
    const Prox plain = set.prox(w, free);
    for (const Vector3d& guess : {free, random.direction()}) {
      same.add_error(
          (set.prox(w, free, guess).moment - plain.moment).norm() / w.norm(),
          "");
    }
  }
}

TEST(MomentSet, ProjectionIsTheNearestPoint) {
  RandomSlips random(6);
  AccuracyReport idempotent("project(project(M)), over |M|", 1e-11);
  for (const RandomSet& r : random_sets(random, 500)) {
    const MomentSet set = r.set();
    const double size = r.solution.friction_moment.norm();
    const Vector3d m = size * random.log_uniform(0.1, 100) * random.direction();
    const Vector3d p = set.project(m);
    if (set.utilisation(m) <= 1) {
      EXPECT_EQ(p, m);
      continue;
    }
    EXPECT_NEAR(set.utilisation(p), 1, 1e-12 / r.thickness());
    idempotent.add_error((set.project(p) - p).norm() / m.norm(), "");
    // No point of the edge is nearer: (M - P) . (Q - P) <= 0.
    for (int i = 0; i < 20; ++i) {
      const Vector3d q = set.moment(random.direction());
      EXPECT_LE((m - p).dot(q - p), 1e-11 * m.norm() * m.norm());
    }
    // Distances do not grow.
    const Vector3d other = m + 0.1 * m.norm() * random.direction();
    EXPECT_LE((set.project(other) - p).norm(),
              (other - m).norm() * (1 + 1e-10));
  }
}

TEST(MomentSet, WithoutFrictionOrLoadHoldsNothing) {
  const Vector3d m(1, 2, 3);
  for (const Joint& joint :
       {steel_ball(FrictionLaw(0)), steel_ball(ViscousLaw(1e6, 0.1))}) {
    const JointSolution rest =
        joint.solve({Vector3d(0, 0, 1e5), Vector3d::Zero()});
    const MomentSet set = joint.moment_set(rest);
    EXPECT_EQ(set.support(m), 0);
    EXPECT_EQ(set.utilisation(m), infinity);
    EXPECT_EQ(set.utilisation(Vector3d::Zero()), 0);
    EXPECT_EQ(set.project(m), Vector3d::Zero());
    EXPECT_EQ(set.prox(Matrix3d::Identity(), m).angular_velocity, m);
  }
  const Joint dry = steel_ball(FrictionLaw(0.3));
  const JointSolution empty = dry.solve({Vector3d::Zero(), Vector3d::Zero()});
  EXPECT_EQ(dry.moment_set(empty).utilisation(m), infinity);
}

TEST(MomentSet, NanGivesNanAndNothingAllocates) {
  RandomSlips random(7);
  const RandomSet r = random_sets(random, 1)[0];
  const MomentSet set = r.set();
  const Vector3d bad(1, nan, 0);
  const std::size_t before = allocation_count();
  EXPECT_TRUE(std::isnan(set.support(bad)));
  EXPECT_TRUE(set.moment(bad).hasNaN());
  EXPECT_TRUE(std::isnan(set.utilisation(bad)));
  EXPECT_TRUE(set.project(bad).hasNaN());
  const Prox p = set.prox(Matrix3d::Identity(), bad);
  EXPECT_EQ(p.status, Status::out_of_range);
  EXPECT_TRUE(p.angular_velocity.hasNaN());
  set.project(1e3 * r.solution.friction_moment);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace contact::test::moment_set_test
