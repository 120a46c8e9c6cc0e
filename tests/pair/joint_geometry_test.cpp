#include "libcontact/pair/joint_geometry.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "libcontact/pair/friction_law.hpp"
#include "support/accuracy_report.hpp"

namespace {

using contact::ElasticPair;
using contact::FrictionLaw;
using contact::JointBody;
using contact::JointGeometry;
using contact::JointKind;
using contact::LoadScale;
using contact::test::AccuracyReport;
using Real = boost::multiprecision::cpp_bin_float_50;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(JointGeometry, KeepsWhatItIsGiven) {
  const auto ball = JointGeometry::ball(0.05, 5e-5, JointBody::body);
  EXPECT_EQ(ball.kind(), JointKind::ball);
  EXPECT_EQ(ball.radius(), 0.05);
  EXPECT_EQ(ball.radial_clearance(), 5e-5);
  EXPECT_EQ(ball.relative_clearance(), 5e-5 / 0.05);
  EXPECT_TRUE(std::isnan(ball.length()));
  EXPECT_EQ(ball.inner_body(), JointBody::body);
  EXPECT_EQ(ball.load_from_force(7), 7);
  EXPECT_EQ(ball.force_from_load(7), 7);
  EXPECT_DOUBLE_EQ(ball.pressure_unit(2e5), 8e7);

  const auto pin = JointGeometry::pin(0.02, 1e-5, 0.5);
  EXPECT_EQ(pin.kind(), JointKind::pin);
  EXPECT_EQ(pin.length(), 0.5);
  EXPECT_EQ(pin.inner_body(), JointBody::carrier);
  EXPECT_EQ(pin.load_from_force(7), 14);
  EXPECT_EQ(pin.force_from_load(14), 7);
  EXPECT_DOUBLE_EQ(pin.pressure_unit(1e6), 5e7);
}

TEST(JointGeometry, NotesAClearanceThatIsNotSmall) {
  EXPECT_TRUE(JointGeometry::ball(1, 0.05).validity_notes().empty());
  const auto notes =
      JointGeometry::ball(1, std::nextafter(0.05, 1.0)).validity_notes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "relative clearance 0.05 exceeds 0.05: the theory is of first "
            "order in it");
  EXPECT_TRUE(JointGeometry::ball(1, 1e-5).validity_notes().empty());
  const auto small =
      JointGeometry::pin(1, std::nextafter(1e-5, 0.0), 1).validity_notes();
  ASSERT_EQ(small.size(), 1u);
  EXPECT_EQ(small[0],
            "relative clearance 1e-05 is below 1e-05: errors of form and "
            "warmth change clearances as small as this");
}

TEST(JointGeometry, NominalPressureIsThatOfTheProjectedArea) {
  EXPECT_DOUBLE_EQ(JointGeometry::ball(0.5, 1e-3).nominal_pressure(3),
                   12 / std::numbers::pi);
  EXPECT_DOUBLE_EQ(JointGeometry::pin(0.5, 1e-3, 2).nominal_pressure(3), 1.5);
}

TEST(LoadScale, AgreesWithFiftyDigits) {
  const Real& pi = boost::math::constants::pi<Real>();
  // 6 to 8 roundings of at most 1.1e-16, measured 2.8e-16.
  AccuracyReport forward("load_parameter", 5e-16);
  AccuracyReport back("load", 5e-16);
  for (const double radius : {1e-4, 0.05, 3.7}) {
    for (const double share : {1e-6, 1e-3, 0.04}) {
      for (const double e2 : {2e9, 2.07e11}) {
        const double clearance = share * radius;
        const ElasticPair pair({1.1e11, 0.33}, {e2, 0.29});
        const Real c1 = (1 - Real(0.33) * 0.33) / 1.1e11;
        const Real c2 = (1 - Real(0.29) * 0.29) / e2;
        const Real modulus = 2 / (c1 + c2);
        const Real relative = Real(clearance) / radius;
        const Real mu_1 = 2 * relative * radius * radius * modulus / 3;
        const Real lambda_1 = pi * relative * radius * modulus / 2;
        const auto ball = JointGeometry::ball(radius, clearance);
        const auto pin = JointGeometry::pin(radius, clearance, 1);
        const LoadScale ball_scale(ball, pair);
        const LoadScale pin_scale(pin, pair);
        for (const double value : {1e-9, 1.234, 7.7e8}) {
          forward.add(Real(ball_scale.load_parameter(value)),
                      Real(value / mu_1), "ball");
          forward.add(Real(pin_scale.load_parameter(value)),
                      Real(value / lambda_1), "pin");
          back.add(Real(ball_scale.load(value)), Real(value * mu_1), "ball");
          back.add(Real(pin_scale.load(value)), Real(value * lambda_1), "pin");
        }
      }
    }
  }
  forward.check();
  back.check();
}

// Literature: example 1 of the paper prints mu = 0.55; by hand
// 3 * 2e5/(2 * 1e-3 * 0.05^2 * 2e11/0.91) = 0.546.
TEST(LoadScale, PaperExampleOne) {
  const LoadScale scale(JointGeometry::ball(0.05, 5e-5),
                        ElasticPair({2e11, 0.3}, {2e11, 0.3}));
  EXPECT_NEAR(scale.load_parameter(2e5), 0.546, 1e-15);
  EXPECT_NEAR(scale.load_parameter(2e5), 0.55, 0.005);
}

// x is the contact radius over the ball's (pin's) radius that Hertz's own
// formulas give: a^3 = 3 R_n r/(4 E*), b^2 = 4 P r/(pi E*), with
// 1/r = 1/rho1 - 1/rho2 = eps/rho1^2 to first order.
TEST(LoadScale, IsHertzTheoryForSmallLoads) {
  const ElasticPair pair({2e11, 0.3}, {1e11, 0.34});
  const double rho = 0.03;
  const double eps = 2e-5;
  const double curvature_radius = rho * rho / eps;
  const double e_star = pair.contact_modulus();
  const double force = 12.0;
  const double ball_radius =
      std::cbrt(3 * force * curvature_radius / (4 * e_star));
  const double pin_radius =
      std::sqrt(4 * force * curvature_radius / (std::acos(-1.0) * e_star));
  const LoadScale ball(JointGeometry::ball(rho, eps), pair);
  const LoadScale pin(JointGeometry::pin(rho, eps, 1), pair);
  // A dozen roundings on both sides.
  EXPECT_NEAR(contact::x_from_load_parameter(JointKind::ball,
                                             ball.load_parameter(force)) /
                  (ball_radius / rho),
              1, 2e-15);
  EXPECT_NEAR(contact::x_from_load_parameter(JointKind::pin,
                                             pin.load_parameter(force)) /
                  (pin_radius / rho),
              1, 2e-15);
}

TEST(LoadParameter, XAgreesWithFiftyDigits) {
  // glibc's cbrt, 2 ulp; two products.
  AccuracyReport forward("x_from_load_parameter", 5e-16);
  AccuracyReport back("load_parameter_from_x", 3e-16);
  for (double value = 1e-90; value < 1e90; value *= 1.73) {
    const std::string row = std::to_string(value);
    forward.add(Real(contact::x_from_load_parameter(JointKind::ball, value)),
                Real(cbrt(Real(value))), row);
    forward.add(Real(contact::x_from_load_parameter(JointKind::pin, value)),
                Real(2 * sqrt(Real(value))), row);
    back.add(Real(contact::load_parameter_from_x(JointKind::ball, value)),
             Real(Real(value) * value * value), row);
    back.add(Real(contact::load_parameter_from_x(JointKind::pin, value)),
             Real(Real(value) * value / 4), row);
  }
  forward.check();
  back.check();
}

TEST(LoadParameter, NanAndLimits) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    EXPECT_TRUE(std::isnan(contact::x_from_load_parameter(kind, nan)));
    EXPECT_TRUE(std::isnan(contact::load_parameter_from_x(kind, nan)));
    EXPECT_EQ(contact::x_from_load_parameter(kind, 0), 0);
    EXPECT_EQ(contact::x_from_load_parameter(kind, infinity), infinity);
    EXPECT_EQ(contact::load_parameter_from_x(kind, infinity), infinity);
  }
  EXPECT_TRUE(std::isnan(contact::x_from_load_parameter(JointKind::pin, -1)));
}

TEST(FrictionLaw, StressAndCoefficient) {
  const FrictionLaw law(0.1, 4e7);
  EXPECT_EQ(law.coefficient(), 0.1);
  EXPECT_EQ(law.adhesion(), 4e7);
  EXPECT_DOUBLE_EQ(law.coefficient_at(8e7), 0.6);
  EXPECT_DOUBLE_EQ(law.stress_at(8e7), 4.8e7);
  // The stress stays finite where the coefficient does not.
  EXPECT_EQ(law.stress_at(0), 4e7);
  EXPECT_EQ(law.coefficient_at(0), infinity);
  EXPECT_EQ(FrictionLaw(0.3).coefficient_at(0), 0.3);
  EXPECT_TRUE(std::isnan(law.coefficient_at(nan)));
  EXPECT_TRUE(std::isnan(law.stress_at(nan)));
}

}  // namespace
