#include "libcontact/play/impact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "play/reference_joint.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"

// Restitution and impacts against independent solutions.
namespace contact::test::impact_test {
namespace {

using namespace contact;
using contact::test::AccuracyReport;
using contact::test::ReferenceTable;

TEST(RestitutionAccuracy, IsExact) {
  const ReferenceTable table("play/restitution.csv");
  // The nearest double to e is 1e-16/(1 - e) from it in 1 - e.
  AccuracyReport number("a v0", 1e-12);
  AccuracyReport back("restitution", 1e-14);
  AccuracyReport energy("energy at the turn", 1e-12);
  AccuracyReport others("by factors of others", 1e-11);  // 12 digits
  for (const ReferenceTable::Row row : table) {
    const double e = row.value("e");
    const double x = row.value("a_v0");
    const std::string label = row.label();
    constexpr double speed = 0.37;
    const auto damping = HuntCrossley::from_restitution(e, speed);
    number.add(damping.damping() * speed, x, label);
    const HuntCrossley reference(x);
    back.add(reference.restitution(1), e, label);
    energy.add(reference.energy_share(1),
               row.value("peak_energy_over_half_m_v0_squared"), label);
    const ApproximateRestitution other = approximate_restitution(e);
    others.add(other.lankarani_nikravesh, row.value("e_of_lankarani_nikravesh"),
               label);
    others.add(other.hunt_crossley, row.value("e_of_hunt_crossley"), label);
    others.add(other.flores, row.value("e_of_flores"), label);
  }
  for (auto* report : {&number, &back, &energy, &others}) report->check();
}

// e = 1 - 2X/3 + 4X^2/9 - 44X^3/135 + ... and X(e) there and back, from next to
// no damping to next to no restitution.
TEST(RestitutionIdentity, LimitsAndInverse) {
  EXPECT_EQ(HuntCrossley().restitution(3), 1);
  EXPECT_EQ(HuntCrossley(2).restitution(0), 1);
  EXPECT_EQ(HuntCrossley::from_restitution(1, 1).damping(), 0);
  for (const double x : {1e-12, 1e-6, 1e-4}) {
    EXPECT_NEAR((1 - HuntCrossley(x).restitution(1)) / x,
                2.0 / 3 - 4 * x / 9 + 44 * x * x / 135, 3e-4 * 1e-12 / x);
  }
  EXPECT_NEAR(HuntCrossley(1e6).restitution(1), 1e-6, 1e-18);
  for (double e = 1e-6; e < 1; e += 0.00137) {
    EXPECT_NEAR(HuntCrossley::from_restitution(e, 1).restitution(1), e,
                1e-13 * e);
  }
  for (double rest = 1e-3; rest > 1e-12; rest /= 3) {
    EXPECT_NEAR(1 - HuntCrossley::from_restitution(1 - rest, 1).restitution(1),
                rest, 1e-15 + 1e-12 * rest);
  }
  // The speeds of an impact: v0 at first, e v0 at last.
  for (const double a : {0.0, 1e-9, 0.02, 0.3, 5.0, 400.0}) {
    const HuntCrossley damping(a);
    const double energy = damping.energy_share(1.5) * 1.5 * 1.5 / 2;
    EXPECT_NEAR(damping.speed_inwards(energy), 1.5, 1e-12);
    EXPECT_NEAR(damping.speed_outwards(energy), 1.5 * damping.restitution(1.5),
                1e-12);
  }
}

TEST(RestitutionContract, RefusesWhatIsNone) {
  EXPECT_ERROR(HuntCrossley::from_restitution(0, 1),
               "impact: restitution = 0 must be above 0, and at most 1");
  EXPECT_ERROR(HuntCrossley::from_restitution(0.5, 0),
               "impact: reference_speed = 0 must be above 0 m/s");
  EXPECT_ERROR(HuntCrossley{-1}, "impact: damping = -1 must be 0 s/m or more");
  EXPECT_TRUE(std::isnan(
      HuntCrossley(1).restitution(std::numeric_limits<double>::quiet_NaN())));
}

TEST(ImpactAccuracy, IsTheReference) {
  const ReferenceTable table("play/impact.csv");
  AccuracyReport damping("damping", 1e-12);
  AccuracyReport penetration("penetration and force", 1e-10);
  // The reference's change with its nodes, 1e-8, is not all of its error: two
  // quadratures of ours agree to 1e-11 and differ from it by up to 2.4e-8. The
  // motion itself is integrated in motion_test.cpp.
  AccuracyReport time("times, over their accuracy", 3);
  std::optional<JointImpact> impact;
  JointSpec last = test::slider_crank_joint();
  for (const ReferenceTable::Row row : table) {
    const JointSpec joint = test::reference_joint(row);
    if (!impact || joint != last) impact.emplace(joint);
    last = joint;
    const double speed = row.value("speed");
    const auto of = HuntCrossley::from_restitution(row.value("e"), speed);
    const Impact is = (*impact)(of, row.value("mass"), speed);
    const std::string label = row.label();
    damping.add(of.damping(), row.value("a"), label);
    penetration.add(is.penetration, row.value("delta_max"), label);
    penetration.add(is.elastic_force, row.value("elastic_force_max"), label);
    const auto add_time = [&](double value, const char* column) {
      time.add_error(test::relative_error(value, row.value(column)) /
                         row.value("acc_time"),
                     label);
    };
    add_time(is.compression_time, "time_compression");
    add_time(is.restitution_time, "time_restitution");
    EXPECT_GE(is.peak_force, is.elastic_force) << label;
    // Pressures grow more slowly than the force that makes them.
    const double elastic =
        joint.make_pressure_law()->peak(is.half_angle) *
        joint.geometry.pressure_unit(
            joint.geometry.load_from_force(is.elastic_force));
    EXPECT_GE(is.peak_pressure, elastic) << label;
    EXPECT_LE(is.peak_pressure / elastic, is.peak_force / is.elastic_force *
                                              (1 + 1e-9) *
                                              (1 + of.damping() * speed))
        << label;
    if (row.value("e") == 1) {
      EXPECT_EQ(is.peak_force, is.elastic_force) << label;
      EXPECT_NEAR(is.peak_pressure / elastic, 1, 1e-9) << label;
      EXPECT_NEAR(is.compression_time / is.restitution_time, 1, 1e-12);
    }
  }
  for (auto* report : {&damping, &penetration, &time}) report->check();
}

TEST(ImpactContract, SaysWhereTheModelEnds) {
  JointSpec ball = test::steel_ball();
  ball.inner = Material{207e9, 0.3, "steel", 3e8};
  const JointImpact impact(ball);
  const auto damping = HuntCrossley::from_restitution(0.8, 1);
  const Impact slow = impact(damping, 0.064, 0.01);
  EXPECT_TRUE(impact.notes(slow, 7800).empty());
  // 8 g at 20 m/s: 3 us.
  const Impact fast = impact(damping, 0.008, 20);
  const auto notes = impact.notes(fast, 7800);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_TRUE(notes[0].starts_with("peak pressure ")) << notes[0];
  EXPECT_TRUE(
      notes[0].ends_with("the restitution is then mostly plastic, and "
                         "its damping a fit"))
      << notes[0];
  EXPECT_TRUE(notes[1].starts_with("the impact takes ")) << notes[1];
  EXPECT_EQ(impact.notes(fast, 0).size(), 1u);
  const Impact beyond = impact(damping, 1e6, 20);
  EXPECT_TRUE(std::isnan(beyond.penetration));
  ASSERT_EQ(impact.notes(beyond, 0).size(), 1u);
  EXPECT_TRUE(
      impact.notes(beyond, 0)[0].starts_with("the impact exceeds the energy"));
  EXPECT_ERROR(impact(damping, 0, 1), "impact: mass = 0 must be above 0 kg");
  EXPECT_ERROR(impact(damping, 1, -1),
               "impact: speed = -1 must be above 0 m/s");
}

}  // namespace
}  // namespace contact::test::impact_test
