// Cases of data/cases against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "libcontact/base/units.hpp"
#include "separation/case_runs.hpp"
#include "separation/simulation/torque_margin.hpp"

namespace contact::test::shipped_cases_test {
namespace {

using Eigen::Vector3d;
using separation::Case;
using separation::Outcome;

Case shipped(const std::string& name, const KeySettings& settings) {
  return separation::read_case(CONTACT_DATA_DIR "/cases/" + name + ".toml", {},
                               settings);
}

// The work of the springs, W = 8 (1500 + 600)/2 0.09 J, is that of the reduced
// mass, m1 m2/(m1 + m2) v^2/2, with centres of mass on the axis. The nozzle's
// rim then passes the walls at 0.6 m - 0.45 m.
TEST(ShippedCases, TwoStagesOnTheirAxis) {
  const Outcome outcome =
      run_case(shipped("two_stages", {{"body[upper].com_m[2]", "0"},
                                      {"body[upper].com_m[3]", "0"},
                                      {"carrier.com_m[2]", "0"}}));
  EXPECT_EQ(outcome.failure, "");
  const double apart = std::sqrt(2 * 756 * (1850. + 1260) / (1850. * 1260));
  EXPECT_NEAR(last(outcome, "upper.vx_m_per_s"), apart * 1850 / 3110, 1e-8);
  EXPECT_NEAR(last(outcome, "lower.vx_m_per_s"), -apart * 1260 / 3110, 1e-8);
  ASSERT_EQ(outcome.memory.pairs.size(), 1u);
  EXPECT_NEAR(outcome.memory.pairs[0].smallest, 0.15, 1e-7);
  EXPECT_EQ(outcome.memory.notes.size(), 2u);  // it ends at its time
}

// As they are they tumble, without angular momentum of the whole: each turns as
// the impulse off its centre of mass wants it, to the order of the angle.
TEST(ShippedCases, TwoStagesTumble) {
  separation::Run run(shipped("two_stages", {}));
  run.advance_to(2);
  const auto& bodies = run.sample().motions();
  const double mass[] = {1850, 1260};
  const Vector3d inertia[] = {{900, 5200, 5200}, {320, 1400, 1400}};
  Vector3d sum = Vector3d::Zero();
  for (const int i : {0, 1}) {
    const Eigen::Matrix3d& turn = bodies[i].rotation;
    sum += mass[i] * bodies[i].position.cross(bodies[i].velocity) +
           turn * inertia[i].cwiseProduct(turn.transpose() *
                                          bodies[i].angular_velocity);
  }
  EXPECT_LT(sum.norm(), 1e-7);
  const double impulse = 1260 * bodies[1].velocity.x();
  const separation::TipOffRecord& at_end = run.memory().tip_offs[0];
  EXPECT_NEAR(at_end.across, impulse * std::hypot(0.004, 0.003) / 1400,
              0.1 * at_end.across);
}

// Without friction the springs and the acceleration a do the work
// W = 850 N m 20 deg + 300 N m 1 deg, m a (x0 - x(60 deg)), on J.
TEST(ShippedCases, FairingHalfIsReleasedAtItsRate) {
  const Outcome outcome =
      run_case(shipped("fairing_half", {{"run.friction", "ideal"}}));
  const double angle = 60 * degree;
  const double work =
      (850 * 20 + 300) * degree +
      350 * 2 * (2.4 - 2.4 * std::cos(angle) - 0.6 * std::sin(angle));
  const double inertia = 870 + 350 * (2.4 * 2.4 + 0.6 * 0.6);
  const auto& release = outcome.memory.bodies[0].release;
  EXPECT_NEAR(release.angle, angle, 1e-8);
  EXPECT_NEAR(release.rate, std::sqrt(2 * work / inertia), 1e-7);
}

// Drive over resistance where it begins: 1100 N m over m a 0.6 m and the pins'
// f r R/sqrt(1 + f^2), which the spread of the pressure changes by less than
// 1e-3.
TEST(ShippedCases, FairingHalfHasItsMargin) {
  const Case c = shipped("fairing_half", {});
  const auto margin =
      separation::torque_margin(c, 0, separation::FrictionChoice::full);
  const double force = 350 * 2;
  const double wanted =
      1100 / (force * 0.6 + 0.2 / std::sqrt(1.04) * force * 0.02);
  EXPECT_NEAR(margin.ratio, wanted, 1e-5 * wanted);
  EXPECT_EQ(margin.angle, 0);
}

}  // namespace
}  // namespace contact::test::shipped_cases_test
