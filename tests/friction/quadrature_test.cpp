#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "libcontact/base/units.hpp"
#include "libcontact/reference/quadrature.hpp"
#include "support/accuracy_report.hpp"
#include "support/friction_reference.hpp"

namespace contact {
namespace {

using reference::quadrature_friction_integrals;
using reference::QuadratureResult;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Quadrature, AgreesWithTheReference) {
  // Asked for 1e-10; the error must also be inside the estimate, apart from
  // the rounding of the coefficient's division and the table.
  int not_converged = 0;
  std::vector<test::AccuracyReport> reports;
  for (const auto& quantity : test::friction_quantities()) {
    reports.emplace_back(quantity.column, 1e-10);
  }
  for (const auto& row : test::friction_reference()) {
    const QuadratureResult result =
        quadrature_friction_integrals(row.half_angle, row.axis, 1e-10);
    for (std::size_t i = 0; i < reports.size(); ++i) {
      const auto& quantity = test::friction_quantities()[i];
      const double value = quantity.of(result.value);
      const double expected = quantity.of(row.expected);
      reports[i].add(value, expected, row.label);
      EXPECT_LE(std::abs(value - expected),
                quantity.of(result.error) + 1e-15 * std::abs(expected))
          << quantity.column << ' ' << row.label;
    }
    if (result.status != Status::ok) {
      ++not_converged;
      // Only where K is a difference of nearly equal numbers.
      EXPECT_LT(row.half_angle * row.axis.sin, 2e-4) << row.label;
      EXPECT_GT(result.error.area.spinning, 1e-10 * result.value.area.spinning)
          << row.label;
    }
  }
  for (const auto& report : reports) report.check();
  EXPECT_LT(not_converged, 12);
}

TEST(Quadrature, ErrorFollowsTheTolerance) {
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    char name[32];
    std::snprintf(name, sizeof name, "tolerance %g", tolerance);
    test::AccuracyReport report(name, tolerance);
    for (const auto& row : test::friction_reference()) {
      // Two half-angles: pole outside and inside, on the edge.
      if (row.theta0_deg != 30 && row.theta0_deg != 120) continue;
      const QuadratureResult result =
          quadrature_friction_integrals(row.half_angle, row.axis, tolerance);
      for (const auto& quantity : test::friction_quantities()) {
        report.add(quantity.of(result.value), quantity.of(row.expected),
                   row.label);
      }
    }
    report.check();
  }
}

TEST(Quadrature, NegativeSlipAxisAngles) {
  // No symmetry in a is used: both signs are integrated as they come.
  for (const double theta0_deg : {20.0, 70.0, 110.0}) {
    const auto at = [&](double a_deg) {
      return quadrature_friction_integrals(theta0_deg * degree,
                                           SlipAxis::from_degrees(a_deg))
          .value;
    };
    const FrictionIntegrals plus = at(35), minus = at(-35);
    // Twice the tolerance.
    EXPECT_NEAR(minus.area.force / plus.area.force, 1, 2e-10);
    EXPECT_NEAR(minus.area.sliding / plus.area.sliding, 1, 2e-10);
    EXPECT_NEAR(minus.area.spinning / plus.area.spinning, -1, 2e-10);
    EXPECT_NEAR(minus.pressure.force / plus.pressure.force, 1, 2e-10);
    EXPECT_NEAR(minus.pressure.sliding / plus.pressure.sliding, 1, 2e-10);
    EXPECT_NEAR(minus.pressure.spinning / plus.pressure.spinning, -1, 2e-10);
  }
}

TEST(Quadrature, StatusAndInvalidArguments) {
  const SlipAxis axis = SlipAxis::from_degrees(30);
  const QuadratureResult zero = quadrature_friction_integrals(0, axis);
  EXPECT_EQ(zero.status, Status::ok);
  EXPECT_EQ(zero.value.coefficient.force, 1);
  EXPECT_EQ(zero.value.coefficient.sliding, 1);
  EXPECT_EQ(zero.value.coefficient.spinning, 0);
  EXPECT_EQ(zero.value.area.force, 0);
  const QuadratureResult spin =
      quadrature_friction_integrals(0.5, SlipAxis::from_degrees(90));
  EXPECT_EQ(spin.value.area.force, 0);
  EXPECT_EQ(spin.value.coefficient.sliding, 0);
  EXPECT_GT(quadrature_friction_integrals(0.5, axis).evaluations, 1000u);
  const auto expect_out_of_range = [](const QuadratureResult& result) {
    EXPECT_EQ(result.status, Status::out_of_range);
    EXPECT_TRUE(std::isnan(result.value.normal));
    EXPECT_TRUE(std::isnan(result.value.area.force));
    EXPECT_TRUE(std::isnan(result.value.coefficient.spinning));
  };
  expect_out_of_range(quadrature_friction_integrals(nan, axis));
  expect_out_of_range(quadrature_friction_integrals(-0.1, axis));
  expect_out_of_range(quadrature_friction_integrals(3.2, axis));
  expect_out_of_range(quadrature_friction_integrals(1, SlipAxis{nan, 1}));
  expect_out_of_range(quadrature_friction_integrals(1, SlipAxis{0, nan}));
  expect_out_of_range(quadrature_friction_integrals(1, axis, 0));
  expect_out_of_range(quadrature_friction_integrals(1, axis, nan));
}

}  // namespace
}  // namespace contact
