#include "libcontact/friction/elliptic/friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <map>

#include "libcontact/base/units.hpp"
#include "libcontact/friction/elliptic/friction_real.hpp"
#include "libcontact/friction/elliptic/integrals.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "support/accuracy_report.hpp"
#include "support/friction_reference.hpp"
#include "support/long_run.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::elliptic_test {
namespace {

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<50>, mp::et_off>;

struct RealAxis {
  Real sin, cos;
};

const Real& real_degree() {
  static const Real value = boost::math::constants::degree<Real>();
  return value;
}

/// Sine and cosine of an angle that is a double in degrees; exact at 0, 90.
RealAxis real_axis(double a_deg) {
  const Real a = a_deg * real_degree(), b = (90 - Real(a_deg)) * real_degree();
  return {sin(a), sin(b)};
}

// In four parts, so that ctest can run them side by side.
class EllipticFormAtFiftyDigits : public testing::TestWithParam<int> {};

TEST_P(EllipticFormAtFiftyDigits, AgreesWithTheReferenceToItsLastDigits) {
  const ReferenceTable table("friction_integrals.csv");
  const char* columns[] = {"I_normal", "I_p", "J_p", "K_p",     "I_a",
                           "J_a",      "K_a", "chi", "sigma_Y", "sigma_Z"};
  std::vector<AccuracyReport> reports;
  // The table holds 20 digits: half a unit of the last one.
  for (const char* column : columns) reports.emplace_back(column, 5e-20);
  for (std::size_t number = GetParam(); number < table.size();
       number += 4 * every(4)) {
    const ReferenceTable::Row row = table[number];
    const RealAxis axis = real_axis(row.value("alpha_deg"));
    const auto f = elliptic_friction_integrals<Real>(
        row.value("theta0_deg") * real_degree(), axis.sin, axis.cos);
    const Real computed[] = {f.normal,
                             f.pressure.force,
                             f.pressure.sliding,
                             f.pressure.spinning,
                             f.area.force,
                             f.area.sliding,
                             f.area.spinning,
                             f.coefficient.force,
                             f.coefficient.sliding,
                             f.coefficient.spinning};
    for (std::size_t i = 0; i < reports.size(); ++i) {
      reports[i].add(computed[i], row.value<Real>(columns[i]), row.label());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Quarter, EllipticFormAtFiftyDigits,
                         testing::Range(0, 4));

// The documented bounds: what the form subtracts loses 1/s^2 once (area
// spinning, pressure force and sliding) or twice (pressure spinning), and all
// lose 1/M^2 where contact and cos a are both small. The factors 2, 6 and 30
// units of 1e-15 are twice what was measured.
double loss(const std::string& column, double s, double large) {
  const double m2 = large * large;
  if (column == "I_normal") return 1e-15;
  if (column == "I_a" || column == "J_a") return 2e-15 / m2;
  if (column == "K_p" || column == "sigma_Z")
    return 3e-14 / (s * s * s * s * m2);
  return 6e-15 / (s * s * m2);
}

TEST(EllipticForm, LosesDigitsInDoubleAsDocumented) {
  std::vector<AccuracyReport> reports;
  for (const auto& quantity : friction_quantities()) {
    reports.emplace_back(std::string(quantity.column) + " / loss", 1);
  }
  std::map<double, std::map<std::string, double>> largest;
  for (const auto& row : friction_reference()) {
    const FrictionIntegrals f =
        elliptic_friction_integrals(row.half_angle, row.axis);
    const double s = std::sin(row.half_angle);
    for (std::size_t i = 0; i < reports.size(); ++i) {
      const auto& quantity = friction_quantities()[i];
      const double error =
          relative_error(quantity.of(f), quantity.of(row.expected));
      reports[i].add_error(
          error / loss(quantity.column, s, std::max(s, row.axis.cos)),
          row.label);
      double& entry = largest[row.theta0_deg][quantity.column];
      entry = std::max(entry, error);
    }
  }
  const char* columns[] = {"I_a", "J_a", "K_a", "I_p", "J_p", "K_p"};
  std::printf("| theta0, deg | I[1] | J[1] | K[1] | I[p] | J[p] | K[p] |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  for (auto& [theta0_deg, errors] : largest) {
    std::printf("| %g |", theta0_deg);
    for (const char* column : columns) {
      std::printf(errors[column] < 1 ? " %.0e |" : " none |", errors[column]);
    }
    std::printf("\n");
  }
}

TEST(EllipticForm, EdgeIsReachedContinuously) {
  // The pole on the edge and its neighbouring doubles: the integrals are
  // continuous as x ln x, x = 2e-16, times the loss.
  for (const double theta0_deg : {5.0, 45.0, 75.0, 105.0}) {
    const double theta0 = theta0_deg * degree;
    const SlipAxis axis = SlipAxis::from_degrees(90 - theta0_deg);
    const auto on = elliptic_friction_integrals(theta0, axis);
    const double s = std::sin(theta0);
    for (const double direction : {0.0, 4.0}) {
      const auto next =
          elliptic_friction_integrals(std::nextafter(theta0, direction), axis);
      for (const auto& quantity : friction_quantities()) {
        EXPECT_NEAR(quantity.of(next) / quantity.of(on), 1,
                    2 * loss(quantity.column, s, s))
            << quantity.column << ' ' << theta0_deg;
      }
    }
  }
}

TEST(EllipticForm, NoJumpAcrossTheSwitches) {
  // x = 1/2, pole outside and inside, and the hemisphere: at neighbouring
  // doubles both sides agree with the exact method within the loss.
  const auto check = [](double theta0, SlipAxis axis) {
    const FrictionIntegrals f = elliptic_friction_integrals(theta0, axis);
    const FrictionIntegrals exact = friction_integrals(theta0, axis);
    const double s = std::sin(theta0);
    for (const auto& quantity : friction_quantities()) {
      EXPECT_LE(relative_error(quantity.of(f), quantity.of(exact)),
                2e-15 + loss(quantity.column, s, std::max(s, axis.cos)))
          << quantity.column << ' ' << theta0 << ' ' << axis.cos;
    }
  };
  for (const double ratio : {std::sqrt(0.5), std::sqrt(2.0)}) {
    double theta0 = 0.6;
    const double q = std::sin(theta0) / ratio;
    const SlipAxis axis{std::sqrt((1 - q) * (1 + q)), q};
    for (int i = 0; i < 6; ++i) theta0 = std::nextafter(theta0, 0.0);
    for (int i = 0; i < 12; ++i) {
      check(theta0, axis);
      theta0 = std::nextafter(theta0, 1.0);
    }
  }
  for (const double theta0 :
       {std::nextafter(pi / 2, 0.0), pi / 2, std::nextafter(pi / 2, 2.0)}) {
    check(theta0, SlipAxis::from_degrees(30));
    check(theta0, SlipAxis::from_degrees(0));
  }
}

TEST(SlipSpeedIntegral, InvalidArguments) {
  for (const double bad : {nan, -0.1, 3.2, infinity}) {
    EXPECT_TRUE(
        std::isnan(slip_speed_integral(bad, SlipAxis::from_degrees(30))));
  }
  for (const SlipAxis bad : {SlipAxis{nan, 1}, SlipAxis{0, nan}}) {
    EXPECT_TRUE(all_nan({slip_speed_integral(1, bad),
                         elliptic_friction_integrals(1, bad).area.force}));
  }
}

TEST(EllipticForm, FiniteInEveryCorner) {
  for (const double theta0_deg :
       {1e-100, 1e-9, 1e-3, 45.0, 89.999999, 90.0, 90.000001, 179.999, 180.0}) {
    for (const double b_deg :
         {0.0, 1e-100, 1e-9, 1e-3, 45.0, 89.999999, 90.0}) {
      const SlipAxis axis{std::cos(b_deg * degree), std::sin(b_deg * degree)};
      const auto f = elliptic_friction_integrals(theta0_deg * degree, axis);
      EXPECT_TRUE(std::isfinite(f.area.force)) << theta0_deg << ' ' << b_deg;
      EXPECT_TRUE(std::isfinite(f.area.sliding)) << theta0_deg << ' ' << b_deg;
      EXPECT_TRUE(std::isfinite(f.area.spinning)) << theta0_deg << ' ' << b_deg;
    }
  }
}

TEST(SlipSpeedIntegral, AgreesWithTheReference) {
  // A = J cos a + K sin a of the table, whose terms are not negative for the
  // table's a >= 0: the documented bound 2e-15.
  AccuracyReport report("A", 2e-15);
  for (const auto& row : friction_reference()) {
    report.add(slip_speed_integral(row.half_angle, row.axis),
               row.expected.area.sliding * row.axis.cos +
                   row.expected.area.spinning * row.axis.sin,
               row.label);
  }
}

TEST(SlipSpeedIntegral, SpecialValues) {
  for (const double a_deg : {0.0, 0.001, 30.0, 60.0, 89.0, 90.0}) {
    const SlipAxis axis = SlipAxis::from_degrees(a_deg);
    // Hemisphere and sphere; 2e-15, the documented bound.
    EXPECT_NEAR(slip_speed_integral(pi / 2, axis) / (pi * pi / 2), 1, 2e-15);
    EXPECT_NEAR(slip_speed_integral(pi, axis) / (pi * pi), 1, 2e-15);
    // pi theta0^2 cos a; the next term is smaller by theta0^2 tan^2 a = 3e-9.
    if (a_deg < 80) {
      EXPECT_NEAR(slip_speed_integral(1e-5, axis) / (pi * 1e-10 * axis.cos), 1,
                  1e-9);
    }
  }
  for (const double theta0 : {1e-3, 0.1, 0.7, 1.5, 2.0}) {
    // a = 90 deg: pi (theta0 - sin cos), here as pi (2 theta0 - sin 2 theta0)/2
    // in 50 digits.
    const Real t = theta0;
    const double spin = static_cast<double>(
        Real(boost::math::constants::pi<Real>() * (t - sin(t) * cos(t))));
    EXPECT_NEAR(slip_speed_integral(theta0, SlipAxis{1, 0}) / spin, 1, 2e-15);
    // a = 0: 4 int_c^1 E(k^2 = 1 - v^2) dv, v = 1 - rise y, by Gauss-Kronrod
    // to 1e-14; beyond 90 deg in two parts, v^2 ln v between them.
    const double rise = 2 * std::pow(std::sin(theta0 / 2), 2);
    const auto e = [&](double y) {
      const double v = 1 - rise * y;
      return elliptic_e(v * v);
    };
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    const double middle = std::min(1.0, 1 / rise);
    const double integral =
        rise * (Rule::integrate(e, 0.0, middle, 15, 1e-14) +
                (middle < 1 ? Rule::integrate(e, middle, 1.0, 15, 1e-14) : 0));
    EXPECT_NEAR(slip_speed_integral(theta0, SlipAxis{0, 1}) / (4 * integral), 1,
                3e-14)
        << theta0;
  }
}

// The potential: M = -grad Phi, Phi(Dw) = |Dw| A(a) for a constant stress and
// |Dw| (J[p] cos a + K[p] sin a) for the pressure, by central differences in
// the two components of Dw at 50 digits. h = 1e-10: the next terms are h^2
// times the fourth derivative over the second, the rounding 1e-50/h.
TEST(EllipticForm, MomentsAreTheGradientOfThePower) {
  const auto at = [](const Real& theta0, const Real& y, const Real& z) {
    const Real size = sqrt(y * y + z * z);
    return std::pair(size, elliptic_friction_integrals<Real>(
                               theta0, Real(z / size), Real(y / size)));
  };
  const auto power = [&](const Real& theta0, const Real& y, const Real& z) {
    const auto [size, f] = at(theta0, y, z);
    return std::pair(Real(f.area.sliding * y + f.area.spinning * z),
                     Real(f.pressure.sliding * y + f.pressure.spinning * z));
  };
  for (const double theta0_deg : {10.0, 60.0, 110.0}) {
    const Real theta0 = theta0_deg * real_degree();
    const Real y("0.6"), z("0.8"), h("1e-10");
    const auto f = at(theta0, y, z).second;
    const auto [area_yp, pressure_yp] = power(theta0, y + h, z);
    const auto [area_ym, pressure_ym] = power(theta0, y - h, z);
    const auto [area_zp, pressure_zp] = power(theta0, y, z + h);
    const auto [area_zm, pressure_zm] = power(theta0, y, z - h);
    const double tolerance = 1e-17;
    EXPECT_LE(
        relative_error(Real((area_yp - area_ym) / (2 * h)), f.area.sliding),
        tolerance);
    EXPECT_LE(
        relative_error(Real((area_zp - area_zm) / (2 * h)), f.area.spinning),
        tolerance);
    EXPECT_LE(relative_error(Real((pressure_yp - pressure_ym) / (2 * h)),
                             f.pressure.sliding),
              tolerance);
    EXPECT_LE(relative_error(Real((pressure_zp - pressure_zm) / (2 * h)),
                             f.pressure.spinning),
              tolerance);
  }
}

}  // namespace
}  // namespace contact::test::elliptic_test
