#include "libcontact/play/force_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "play/reference_joint.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"

// The force law of joints with clearance against independent solutions at
// given penetrations, against the library's own solver, and its identities.
namespace contact::test::force_law_test {
namespace {

TEST(ForceLawAccuracy, IsTheReferenceAtGivenPenetrations) {
  const ReferenceTable table("play/force_law.csv");
  // The reference has 13 digits. The half-angles of its pins are 4e-11 from
  // their forces, those from ours 2e-11; liners are 1e-11 from the truth.
  AccuracyReport balls("balls", 1e-11);
  AccuracyReport pins("pins", 5e-11);
  AccuracyReport liners("thin liners", 2e-10);
  std::optional<ForceLaw> law;
  JointSpec last = test::steel_ball();
  for (const ReferenceTable::Row row : table) {
    const JointSpec joint = test::reference_joint(row);
    if (!law || joint != last) law.emplace(joint);
    last = joint;
    const ForceState at = law->at(row.value("delta"));
    AccuracyReport& report = row.given("La_t") && row.value("La_t") < 0.001
                                 ? liners
                             : row.text("kind") == "ball" ? balls
                                                          : pins;
    const auto add = [&](const char* what, double value, double truth) {
      report.add(value, truth, what + (", " + row.label()));
    };
    add("force", at.force, row.value("force"));
    add("slope", at.slope, row.value("slope"));
    add("energy", at.energy, row.value("energy"));
    add("theta0", at.half_angle, row.value("theta0_deg") * degree);
    add("S", at.force_ratio, row.value("S"));
  }
  for (auto* report : {&balls, &pins, &liners}) report->check();
}

// All of them at many half-angles, by the solver without any table.
template <class Contact, class Pair>
void compare_with_solver(const JointSpec& joint, const Pair& pair, int count,
                         double budget) {
  const ForceLaw law(joint);
  const Contact contact(pair, InnerLoading::centre(), count);
  const bool ball = joint.geometry.kind() == JointKind::ball;
  const double eps = joint.geometry.radial_clearance();
  const double e = joint.pair().effective_modulus();
  const double length =
      ball ? joint.geometry.radius() : joint.geometry.length();
  const double load_unit = (ball ? 2.0 / 3 : pi / 2) * eps * e * length;
  AccuracyReport force("force", budget);
  AccuracyReport slope("slope", budget);
  AccuracyReport energy("energy", budget);
  AccuracyReport angle("theta0", budget);
  for (double theta = 0.004; theta < 1.35; theta *= 1.037) {
    const ForcePoint point = contact.force_point(theta);
    if (!(point.reciprocal_load > 0)) break;
    const double penetration = eps * point.approach.approach;
    if (penetration > law.largest_penetration()) break;
    const ForceState at = law.at(penetration);
    const double load = load_unit / point.reciprocal_load;
    const std::string label = std::to_string(theta / degree);
    force.add(at.force, load, label);
    slope.add(at.slope, point.approach.stiffness * e * length, label);
    energy.add(at.energy, load / 2 * (penetration - eps * point.excess), label);
    angle.add(at.half_angle, theta, label);
  }
  for (auto* report : {&force, &slope, &energy, &angle}) report->check();
}

TEST(ForceLawAccuracy, IsTheSolverAtEveryHalfAngle) {
  compare_with_solver<BallContact>(test::steel_ball(),
                                   test::steel_ball().pair(), 24, 3e-13);
  const JointSpec pin = test::slider_crank_joint();
  compare_with_solver<PinContact>(pin, *pin.conditions().walls, 24, 3e-13);
  // The edge of a thin layer is too sharp for the series.
  JointSpec lined = test::steel_ball();
  lined.outer = {{{0.0004, {1e9, 0.42}}}, Backing::rigid()};
  const LayeredPair walls = *lined.conditions().walls;
  compare_with_solver<BallContact>(lined, walls, 64, 3e-10);
}

// How far the slopes of the last one may be from its forces: as far as the
// solver's own, whose edge is thin.
constexpr double budgets[] = {1e-12, 1e-12, 1e-11, 1e-10};
std::vector<JointSpec> joints() {
  JointSpec soft = test::steel_ball();
  soft.outer = {{{0.003, {1e9, 0.45}}}, Backing::held()};
  JointSpec rigid = test::slider_crank_joint();
  rigid.inner = {{}, Backing::rigid()};
  rigid.outer = {{{0.0002, {2e9, 0.3}}}, Backing::rigid()};
  return {test::steel_ball(), test::slider_crank_joint(), soft, rigid};
}

// Over pieces that cross the cells' edges.
TEST(ForceLawIdentity, WorkOfTheForceIsTheEnergy) {
  const contact::detail::GaussLegendre rule(24);
  for (std::size_t j = 0; j < joints().size(); ++j) {
    AccuracyReport work("work over a piece", budgets[j]);
    AccuracyReport slope("change of force over a piece", budgets[j]);
    const ForceLaw law(joints()[j]);
    for (double from = 1.1 * law.smallest_penetration();
         1.5 * from < law.largest_penetration(); from *= 1.5) {
      const double half = from / 4;
      double sum = 0;
      double change = 0;
      for (int i = 0; i < rule.node.size(); ++i) {
        const double delta = from + half * (1 + rule.node(i));
        sum += half * rule.weight(i) * law.force(delta);
        change += half * rule.weight(i) * law.slope(delta);
      }
      const std::string label = std::to_string(from);
      work.add_error(std::abs(law.energy(1.5 * from) - law.energy(from) - sum) /
                         law.energy(1.5 * from),
                     label);
      slope.add_error(
          std::abs(law.force(1.5 * from) - law.force(from) - change) /
              law.force(1.5 * from),
          label);
    }
    work.check();
    slope.check();
  }
}

TEST(ForceLawIdentity, CellsMeet) {
  for (std::size_t j = 0; j < joints().size(); ++j) {
    const double budget = budgets[j];
    const ForceLaw law(joints()[j]);
    // Cells begin where the last 49 bits are 0.
    for (double edge = law.smallest_penetration();
         edge < law.largest_penetration();) {
      const ForceState left = law.at(std::nextafter(edge, 0));
      const ForceState right = law.at(edge);
      EXPECT_LT(relative_error(left.force, right.force), budget) << edge;
      EXPECT_LT(relative_error(left.energy, right.energy), budget) << edge;
      EXPECT_LT(relative_error(left.half_angle, right.half_angle), budget);
      if (edge > law.smallest_penetration()) {
        EXPECT_LT(relative_error(left.slope, right.slope), budget) << edge;
      }
      int exponent = 0;
      std::frexp(edge, &exponent);
      edge += std::ldexp(1.0 / 16, exponent);
    }
  }
}

// F ~ delta^(3/2) of a ball; the force of a pin is delta over a logarithm.
TEST(ForceLawIdentity, SmallPenetrationsFollowAPower) {
  const ForceLaw ball(test::steel_ball());
  const double delta = ball.smallest_penetration();
  const auto power = [](const ForceLaw& law, double at) {
    return at * law.slope(at) / law.force(at);
  };
  EXPECT_NEAR(power(ball, delta / 100), 1.5, 2e-3);
  const Material steel = {207e9, 0.3};
  const double modulus = 207e9 / (2 * (1 - 0.09));
  const double radius = 0.0125 * 0.0125 / 1e-4;
  EXPECT_NEAR(ball.force(delta / 100) / (4.0 / 3 * modulus * std::sqrt(radius) *
                                         std::pow(delta / 100, 1.5)),
              1, 1e-2);
  const ForceLaw pin(test::slider_crank_joint());
  EXPECT_GT(power(pin, pin.smallest_penetration() / 2), 1.05);
  EXPECT_LT(power(pin, pin.smallest_penetration() / 2), 1.15);
  for (const ForceLaw* law : {&ball, &pin}) {
    const double small = law->smallest_penetration() / 7;
    EXPECT_NEAR(law->energy(small) * (power(*law, small) + 1) /
                    (small * law->force(small)),
                1, 1e-14);
    EXPECT_EQ(law->force(-small), 0);
    EXPECT_EQ(law->energy(0), 0);
    EXPECT_EQ(law->force_ratio(-1), 1);
  }
}

TEST(ForceLawIdentity, InversesComeBack) {
  for (const JointSpec& joint : joints()) {
    const ForceLaw law(joint);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(
        std::log(law.smallest_penetration() / 1e4),
        std::log(law.largest_penetration()));
    for (int i = 0; i < 300; ++i) {
      const double delta = std::exp(share(random));
      EXPECT_LT(
          relative_error(law.penetration_of_force(law.force(delta)), delta),
          1e-12);
      EXPECT_LT(
          relative_error(law.penetration_of_energy(law.energy(delta)), delta),
          1e-12);
    }
    EXPECT_EQ(law.penetration_of_force(0), 0);
    const double most = law.force(law.largest_penetration());
    EXPECT_EQ(law.penetration_of_force(most), law.largest_penetration());
    EXPECT_TRUE(std::isnan(law.penetration_of_force(1.001 * most)));
    EXPECT_TRUE(std::isnan(law.penetration_of_force(-1)));
    EXPECT_TRUE(std::isnan(law.penetration_of_energy(nan)));
  }
}

TEST(ForceLawContract, EndsWithNaNAndDoesNotAllocate) {
  const ForceLaw law(test::steel_ball());
  const double end = law.largest_penetration();
  EXPECT_GT(law.half_angle(end), 78 * degree);
  EXPECT_FALSE(std::isnan(law.force(end)));
  EXPECT_TRUE(std::isnan(law.force(std::nextafter(end, 1))));
  EXPECT_TRUE(std::isnan(law.at(nan).energy));
  EXPECT_TRUE(std::isnan(law.force(nan)));
  const std::size_t before = test::allocation_count();
  law.at(end / 2);
  law.penetration_of_energy(law.energy(end / 3));
  EXPECT_EQ(test::allocation_count(), before);
}

TEST(ForceLawContract, RefusesJointsWithoutApproach) {
  JointSpec pin = test::slider_crank_joint();
  pin.outer = Material{207e9, 0.3};
  EXPECT_ERROR(
      ForceLaw{pin},
      "pin joint with play requires a wall with a backing other than an "
      "infinite body: in an infinite hole the displacement has no limit");
  JointSpec ball = test::steel_ball();
  ball.loading = InnerLoading::back(0.2);
  EXPECT_ERROR(ForceLaw{ball},
               "ball joint with play requires loading = centre: a body that is "
               "pressed from behind has no approach");
}

}  // namespace
}  // namespace contact::test::force_law_test
