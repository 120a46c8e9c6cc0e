#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/friction/elliptic/friction_real.hpp"
#include "libcontact/friction/elliptic/integrals_real.hpp"
#include "libcontact/friction/special.hpp"
#include "libcontact/tools/reference/quadrature.hpp"
#include "support/accuracy_report.hpp"
#include "support/friction_reference.hpp"
#include "support/numbers.hpp"

namespace contact::test::special_test {
namespace {

using reference::quadrature_friction_integrals;
using reference::QuadratureResult;

TEST(Quadrature, AgreesWithTheReference) {
  // Asked for 1e-10; the error must also be inside the estimate, apart from
  // the rounding of the coefficient's division and the table.
  int not_converged = 0;
  std::vector<AccuracyReport> reports;
  for (const auto& quantity : friction_quantities()) {
    reports.emplace_back(quantity.column, 1e-10);
  }
  for (const auto& row : friction_reference()) {
    const QuadratureResult result =
        quadrature_friction_integrals(row.half_angle, row.axis, 1e-10);
    for (std::size_t i = 0; i < reports.size(); ++i) {
      const auto& quantity = friction_quantities()[i];
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
  EXPECT_LT(not_converged, 12);
}

TEST(Quadrature, ErrorFollowsTheTolerance) {
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    char name[32];
    std::snprintf(name, sizeof name, "tolerance %g", tolerance);
    AccuracyReport report(name, tolerance);
    for (const auto& row : friction_reference()) {
      // Two half-angles: pole outside and inside, on the edge.
      if (row.theta0_deg != 30 && row.theta0_deg != 120) continue;
      const QuadratureResult result =
          quadrature_friction_integrals(row.half_angle, row.axis, tolerance);
      for (const auto& quantity : friction_quantities()) {
        report.add(quantity.of(result.value), quantity.of(row.expected),
                   row.label);
      }
    }
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
    EXPECT_TRUE(all_nan({result.value.normal, result.value.area.force,
                         result.value.coefficient.spinning}));
  };
  expect_out_of_range(quadrature_friction_integrals(nan, axis));
  expect_out_of_range(quadrature_friction_integrals(-0.1, axis));
  expect_out_of_range(quadrature_friction_integrals(3.2, axis));
  expect_out_of_range(quadrature_friction_integrals(1, SlipAxis{nan, 1}));
  expect_out_of_range(quadrature_friction_integrals(1, SlipAxis{0, nan}));
  expect_out_of_range(quadrature_friction_integrals(1, axis, 0));
  expect_out_of_range(quadrature_friction_integrals(1, axis, nan));
}

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<50>, mp::et_off>;

// The documented bound: one elliptic integral or series (1e-15) and the
// roundings of the factors, or the rounding of tanh-sinh sums.
constexpr double budget = 3e-15;

TEST(FrictionSpecial, AgreeWithTheReference) {
  check_friction_accuracy(
      [](double theta0, SlipAxis) {
        return sliding_friction_integrals(theta0);
      },
      budget, [](const auto& row) { return row.alpha_deg == 0; });
  check_friction_accuracy(
      [](double theta0, SlipAxis) {
        return spinning_friction_integrals(theta0);
      },
      budget, [](const auto& row) { return row.alpha_deg == 90; });
  check_friction_accuracy(
      [](double, SlipAxis axis) { return hemisphere_friction_integrals(axis); },
      budget, [](const auto& row) { return row.theta0_deg == 90; });
}

/// All ten quantities against the elliptic method at 50 digits.
void add_all(AccuracyReport& report, const FrictionIntegrals& computed,
             const Real& half_angle, const Real& sa, const Real& q,
             const std::string& label) {
  const auto f = elliptic_friction_integrals<Real>(half_angle, sa, q);
  const FrictionIntegrals expected{
      double(f.normal),
      {double(f.pressure.force), double(f.pressure.sliding),
       double(f.pressure.spinning)},
      {double(f.area.force), double(f.area.sliding), double(f.area.spinning)},
      {double(f.coefficient.force), double(f.coefficient.sliding),
       double(f.coefficient.spinning)}};
  add_integrals(report, computed, expected, label);
}

TEST(FrictionSpecial, AgreeWithTheEllipticMethodAtFiftyDigits) {
  AccuracyReport sliding("a = 0", budget);
  AccuracyReport spinning("a = 90 deg", budget);
  // At a = 90 deg the elliptic form loses theta0^-6: 26 digits are left.
  for (const double theta0 : {1e-4, 1e-3, 0.03, 0.3, 0.9, 1.0, 1.0 + 0x1p-52,
                              1.3, 1.5707, 1.5708, 1.7, 2.0, 2.9}) {
    const std::string label = "theta0=" + std::to_string(theta0);
    add_all(sliding, sliding_friction_integrals(theta0), theta0, 0, 1, label);
    add_all(spinning, spinning_friction_integrals(theta0), theta0, 1, 0, label);
  }
  AccuracyReport hemisphere("theta0 = 90 deg", budget);
  const Real& right_angle = boost::math::constants::half_pi<Real>();
  for (const double sa : {1e-9, 0.001, 0.1, 0.6, 0.99, 1 - 1e-9}) {
    const Real cosine = sqrt((1 - Real(sa)) * (1 + Real(sa)));
    add_all(hemisphere, hemisphere_friction_integrals({sa, double(cosine)}),
            right_angle, sa, cosine, "sin a=" + std::to_string(sa));
  }
}

// The finite combinations of the docstring: they hold, with J[1] in them.
TEST(FrictionSpecial, SlidingClosedFormsHoldAtFiftyDigits) {
  for (const double theta0 : {0.05, 0.7, 1.4, 2.1}) {
    const Real s = sin(Real(theta0)), c = cos(Real(theta0));
    const Real x = c * c, k = elliptic_k<Real>(x), e = elliptic_e<Real>(x);
    const auto f = elliptic_friction_integrals<Real>(theta0, 0, 1);
    // 50 digits less the 4 that cancel at 0.05 and some for the quadrature.
    const double tolerance = 1e-42;
    EXPECT_LE(relative_error(Real(4 * (e - x * k)), f.area.force), tolerance);
    EXPECT_LE(relative_error(Real((f.area.sliding - c * f.area.force) / 2),
                             f.pressure.force),
              tolerance);
    EXPECT_LE(relative_error(Real(Real(4) / 3 * ((1 + s * s) * e - x * k) -
                                  c * f.area.sliding),
                             f.pressure.sliding),
              tolerance);
    EXPECT_LE(
        relative_error(slip_speed_integral<Real>(theta0, 0, 1), f.area.sliding),
        tolerance);
  }
}

TEST(FrictionSpecial, LimitsOfSmallContacts) {
  // Planar disc with parabolic pressure; corrections of order theta0^2.
  const double theta0 = 1e-9;
  const auto slide = sliding_friction_integrals(theta0);
  EXPECT_NEAR(slide.coefficient.force, 1, 4e-15);
  EXPECT_NEAR(slide.coefficient.sliding, 1, 4e-15);
  EXPECT_NEAR(slide.area.force / (pi * theta0 * theta0), 1, 4e-15);
  const auto spin = spinning_friction_integrals(theta0);
  EXPECT_NEAR(spin.coefficient.spinning / theta0, 8.0 / 15, 4e-15);
  EXPECT_NEAR(spin.area.spinning / (2 * pi / 3 * std::pow(theta0, 3)), 1,
              4e-15);
  EXPECT_EQ(sliding_friction_integrals(0).coefficient.force, 1);
  EXPECT_EQ(sliding_friction_integrals(0).coefficient.sliding, 1);
  EXPECT_EQ(sliding_friction_integrals(0).area.force, 0);
  EXPECT_EQ(spinning_friction_integrals(0).coefficient.spinning, 0);
  EXPECT_EQ(spinning_friction_integrals(0).normal, 0);
}

TEST(FrictionSpecial, NoJumpAtTheHemisphere) {
  // The quadrature is split above 90 deg: neighbouring doubles, 1e-15 each.
  const double right_angle = pi / 2;
  const auto below = sliding_friction_integrals(right_angle);
  double theta0 = right_angle;
  for (int i = 0; i < 8; ++i) {
    theta0 = std::nextafter(theta0, 2.0);
    const auto above = sliding_friction_integrals(theta0);
    EXPECT_NEAR(above.pressure.force / below.pressure.force, 1, 4e-15);
    EXPECT_NEAR(above.pressure.sliding / below.pressure.sliding, 1, 4e-15);
    EXPECT_NEAR(above.area.sliding / below.area.sliding, 1, 4e-15);
  }
}

TEST(FrictionSpecial, WholeSphereAndCornersOfTheHemisphere) {
  // A closed uniform contact: no force but pi^2 of moment either way.
  EXPECT_NEAR(sliding_friction_integrals(pi).area.sliding, pi * pi, 3e-14);
  EXPECT_NEAR(sliding_friction_integrals(pi).area.force, 0, 1e-15);
  EXPECT_NEAR(spinning_friction_integrals(pi).area.spinning, pi * pi, 3e-14);
  const auto slide = hemisphere_friction_integrals({0, 1});
  EXPECT_NEAR(slide.area.force, 4, 1e-14);
  EXPECT_NEAR(slide.pressure.force, pi * pi / 4, 1e-14);
  EXPECT_NEAR(slide.pressure.sliding, 8.0 / 3, 1e-14);
  EXPECT_EQ(slide.area.spinning, 0);
  const auto spin = hemisphere_friction_integrals({-1, 0});
  EXPECT_EQ(spin.area.force, 0);
  EXPECT_NEAR(spin.pressure.spinning, -2 * pi / 3, 1e-14);
}

TEST(FrictionSpecial, NanAndOutOfRangeGiveNan) {
  for (const double bad : {nan, -1e-9, 3.15}) {
    for (const auto& quantity : friction_quantities()) {
      EXPECT_TRUE(all_nan({quantity.of(sliding_friction_integrals(bad)),
                           quantity.of(spinning_friction_integrals(bad))}));
    }
  }
  for (const SlipAxis bad : {SlipAxis{nan, 0.5}, SlipAxis{0.5, nan}}) {
    for (const auto& quantity : friction_quantities()) {
      EXPECT_TRUE(std::isnan(quantity.of(hemisphere_friction_integrals(bad))));
    }
  }
}

}  // namespace
}  // namespace contact::test::special_test
