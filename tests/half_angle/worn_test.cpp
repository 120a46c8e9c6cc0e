#include "libcontact/half_angle/worn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/stress_rule.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/pressure/worn.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/reference_table.hpp"

namespace contact::test::worn_test {
namespace {

// Computed apart from the library, 1e-11 (its angles have 12 digits).
TEST(Worn, Reference) {
  const ReferenceTable table("duty/wear_in.csv");
  ASSERT_EQ(table.size(), 58u);
  AccuracyReport angles("theta0", 1e-11);
  AccuracyReport depths("penetration", 1e-11);
  AccuracyReport pins("S of pins", 1e-11);
  for (const ReferenceTable::Row row : table) {
    const JointKind kind =
        row.text("joint") == "pin" ? JointKind::pin : JointKind::ball;
    const double v = row.value("wear_number");
    const double elastic = row.value("theta0_elastic_deg") * degree;
    const double theta0 = WornHalfAngle::half_angle_of_overlap(
        kind, WornHalfAngle::overlap(kind, elastic) + v);
    const std::string label = row.label();
    angles.add(theta0, row.value("theta0_worn_deg") * degree, label);
    depths.add(1 / std::cos(theta0) - 1,
               row.value("penetration_over_clearance"), label);
    if (kind == JointKind::ball) continue;
    pins.add(WornPressure(kind).force_ratio(theta0),
             row.value("moment_coefficient_a0"), label);
  }
}

std::shared_ptr<const HalfAngleLaw> law(JointKind kind) {
  const auto pair = ElasticPair::from_modulus_ratio(60, 0.3, 0.4);
  return make_half_angle_law("tanh", kind, pair);
}

TEST(Worn, LawInBothDirections) {
  AccuracyReport back("load parameter and back", 1e-11);
  // Slopes are by differences over 1e-4.
  AccuracyReport slopes("slope of the logarithm", 1e-6);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    for (const double v : {0., 1e-6, 0.1, 3.}) {
      const WornHalfAngle worn(law(kind), v);
      for (const double load : {1e-3, 0.1, 0.5}) {
        const auto found = worn.half_angle(load);
        ASSERT_EQ(found.status, Status::ok);
        EXPECT_LT(found.half_angle, worn.limit_half_angle());
        // Contacts much more worn than pressed forget the load.
        if (v < 1e-3) {
          back.add(worn.load_parameter(found.half_angle).load_parameter, load,
                   std::to_string(v));
        }
        const double h = 1e-4;
        const double slope =
            std::log(worn.half_angle(load * (1 + h)).half_angle /
                     worn.half_angle(load * (1 - h)).half_angle) /
            std::log((1 + h) / (1 - h));
        slopes.add_error(std::abs(found.log_slope - slope), std::to_string(v));
      }
      EXPECT_EQ(worn.half_angle(-1).status, Status::out_of_range);
      EXPECT_EQ(worn.load_parameter(1.6).status, Status::out_of_range);
    }
  }
}

// A law that does not converge.
class Unsure final : public HalfAngleLaw {
 public:
  Unsure() : HalfAngleLaw(JointKind::ball) {}
  std::string name() const override { return "unsure"; }
  HalfAngleResult half_angle(double) const noexcept override {
    return {0.5, Status::not_converged, 0.3};
  }
  LoadParameterResult load_parameter(double) const noexcept override {
    return {1, Status::ok};
  }
  double limit_half_angle() const noexcept override { return 1; }
  std::vector<std::string> validity_notes(const ElasticPair&) const override {
    return {};
  }
};

TEST(Worn, HasNoHalfAngleWhereTheLawHasNone) {
  for (const double v : {0., 0.1}) {
    const auto found =
        WornHalfAngle(std::make_shared<Unsure>(), v).half_angle(0.1);
    EXPECT_EQ(found.status, Status::out_of_range);
    EXPECT_TRUE(std::isnan(found.half_angle));
  }
}

TEST(Worn, SmallAngles) {
  AccuracyReport report("theta0 of its own g", 1e-14);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    for (double theta = 1e-60; theta < 1.57; theta *= 1.7) {
      const double g = WornHalfAngle::overlap(kind, theta);
      report.add(WornHalfAngle::half_angle_of_overlap(kind, g), theta,
                 std::to_string(theta));
    }
  }
}

// Against points over the contact: 24 each way, smooth, 1e-10.
TEST(Worn, FrictionOfTheWornPressure) {
  AccuracyReport report("coefficients", 2e-10);
  const WornPressure pressure(JointKind::ball);
  const FrictionStress one([](double p, double) { return p; },
                           FrictionStress::OverSpeed::constant);
  for (const double theta0 : {1., 20., 50., 75., 89.}) {
    for (const double a : {0., 10., 45., 80.}) {
      const SlipAxis axis = SlipAxis::from_degrees(a);
      const FrictionTriple exact =
          friction_integrals(pressure, theta0 * degree, axis).coefficient;
      const FrictionTriple i =
          stress_integrals(pressure, {theta0 * degree, 1, 1}, axis, one);
      const std::string label = std::to_string(theta0);
      report.add(i.force, exact.force, label);
      report.add(i.sliding, exact.sliding, label);
      if (a > 0) report.add(i.spinning, exact.spinning, label);
    }
  }
  // As theta0 -> 0 all pressures slide alike.
  EXPECT_NEAR(friction_integrals(pressure, 0, SlipAxis{0, 1}).coefficient.force,
              1, 1e-15);
  EXPECT_TRUE(
      std::isnan(friction_integrals(pressure, 1.6, {0, 1}).coefficient.force));
}

TEST(Worn, Messages) {
  EXPECT_ERROR(
      WornHalfAngle(law(JointKind::ball), -1),
      "worn half-angle: wear_number = -1 must be 0 or above and finite");
}

}  // namespace
}  // namespace contact::test::worn_test
