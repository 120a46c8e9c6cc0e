#include "libcontact/conforming/pin.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::pin_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

Real closed_reciprocal(double outer_share, double half_angle) {
  const Real b2 = pow(tan(Real(half_angle) / 2), 2);
  return (1 - outer_share * (log(1 + b2) + 2 * b2 * b2)) / (b2 * (1 + b2));
}

TEST(PinClosedForm, FollowsItsFormula) {
  // Two roundings each of tan, square, log1p and their combination; where
  // 1 - w_2 (...) cancels, near the limit angle, the error is measured
  // against the two terms.
  AccuracyReport load("1/lambda", 2e-15);
  AccuracyReport ratio("S", 2e-15);
  AccuracyReport inverse("theta0", 1e-15);
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    const PinClosedForm pin(share);
    for (const double theta0_deg :
         {1e-6, 0.01, 1.0, 20.0, 45.0, 60.0, 70.0, 72.0}) {
      const double theta0 = theta0_deg * degree;
      const std::string label = "w2 = " + std::to_string(share) +
                                ", theta0_deg = " + std::to_string(theta0_deg);
      const Real b2 = pow(tan(Real(theta0) / 2), 2);
      const Real expected = closed_reciprocal(share, theta0);
      const Real size = 1 / (b2 * (1 + b2));
      load.add_error(double(abs(pin.reciprocal_load(theta0) - expected) / size),
                     label);
      if (theta0_deg >= 0.01) {
        ratio.add(Real(PinClosedForm::force_ratio(theta0)),
                  Real((log(1 + b2) + 2 * b2 * b2) / (b2 * (1 + b2))), label);
      }
      const ExactHalfAngle result = pin.half_angle(double(1 / expected));
      EXPECT_EQ(result.status, Status::ok) << label;
      inverse.add(result.half_angle, theta0, label);
    }
  }
}

TEST(PinClosedForm, PressureFollowsItsFormula) {
  AccuracyReport report("p / peak", 4e-15);  // rounding of some ten operations
  for (const double theta0_deg : {1e-4, 5.0, 60.0, 90.0, 150.0}) {
    for (const double share : {0.0, 0.3, 0.9, 0.999}) {
      const double theta0 = theta0_deg * degree;
      const double theta = share * theta0;
      const Real b2 = pow(tan(Real(theta0) / 2), 2);
      const Real y2 = pow(tan(Real(theta) / 2), 2);
      const auto formula = [&b2](const Real& y2_) -> Real {
        const Real s1 = sqrt(b2 + 1);
        const Real s2 = sqrt(b2 - y2_);
        const Real& pi50 = boost::math::constants::pi<Real>();
        return 2 / (pi50 * s1) * s2 / (1 + y2_) +
               log((s1 + s2) / (s1 - s2)) / (2 * pi50 * b2 * (1 + b2));
      };
      report.add_error(
          double(abs(PinClosedForm::pressure(theta, theta0) - formula(y2)) /
                 formula(0)),
          "theta0_deg = " + std::to_string(theta0_deg) +
              ", theta/theta0 = " + std::to_string(share));
    }
  }
}

TEST(PinClosedForm, LimitsAndBadArguments) {
  EXPECT_EQ(PinClosedForm(0).limit_half_angle(), pi);
  const PinClosedForm pin(0.5);
  // Identical materials: the figure of the literature, to its digits.
  EXPECT_NEAR(pin.limit_half_angle() / degree, 84.828, 5e-4);
  EXPECT_EQ(pin.half_angle(infinity).half_angle, pin.limit_half_angle());
  EXPECT_EQ(pin.half_angle(0).half_angle, 0);
  EXPECT_EQ(pin.load_parameter(pin.limit_half_angle()).load_parameter,
            infinity);
  EXPECT_EQ(pin.load_parameter(0).load_parameter, 0);
  EXPECT_EQ(pin.load_parameter(1.6).status, Status::out_of_range);
  for (const double bad : {nan, -1.0}) {
    EXPECT_TRUE(std::isnan(pin.half_angle(bad).half_angle));
    EXPECT_EQ(pin.half_angle(bad).status, Status::out_of_range);
    EXPECT_TRUE(all_nan(
        {pin.reciprocal_load(bad), pin.load_parameter(bad).load_parameter,
         PinClosedForm::pressure(0, bad), PinClosedForm::force_ratio(bad)}));
    EXPECT_THROW(PinClosedForm{bad}, Error);
  }
  EXPECT_THROW(PinClosedForm(1.1), Error);
  EXPECT_EQ(PinClosedForm::force_ratio(0), 1);
  EXPECT_EQ(PinClosedForm::pressure(1, 1), 0);
  EXPECT_EQ(PinClosedForm::pressure(-0.5, 1), PinClosedForm::pressure(0.5, 1));
}

TEST(PinContact, MatchesTheClosedForm) {
  // For beta = 0 the truncation error is far below rounding; the root finder
  // stops at 3e-14 of theta0.
  AccuracyReport angle("theta0, deg", 1e-11);
  AccuracyReport pressure("p / peak", 1e-13);
  AccuracyReport ratio("S", 1e-13);
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    const PinContact pin = PinContact::from_dundurs(share, 0);
    const PinClosedForm closed(share);
    for (const double lambda :
         {1e-12, 1e-6, 1e-3, 0.1, 1.0, 10.0, 1e4, 1e8, infinity}) {
      const ExactHalfAngle expected = closed.half_angle(lambda);
      // w_2 = 0 runs to 180 deg.
      if (expected.half_angle > 120 * degree) continue;
      const std::string label = "w2 = " + std::to_string(share) +
                                ", lambda = " + std::to_string(lambda);
      const ExactHalfAngle result = pin.half_angle(lambda);
      EXPECT_EQ(result.status, Status::ok) << label;
      EXPECT_LE(result.evaluations, 14) << label;
      angle.add_error(
          std::abs(result.half_angle - expected.half_angle) / degree, label);
      const double theta0 = expected.half_angle;
      const ContactPressure p = pin.pressure(theta0);
      ratio.add(p.force_ratio(), PinClosedForm::force_ratio(theta0), label);
      for (const double t : {0.0, 0.2, 0.5, 0.8, 0.95, 0.999}) {
        pressure.add_error(
            std::abs(p.pressure(t * theta0) -
                     PinClosedForm::pressure(t * theta0, theta0)) /
                p.peak(),
            label + ", theta/theta0 = " + std::to_string(t));
      }
    }
  }
}

// Error of 1/lambda with n unknowns, relative to 1/lambda or to 1.
double truncation_error(double beta, double half_angle, int unknowns,
                        double exact) {
  const double coarse =
      PinContact::from_dundurs(0.5, beta, unknowns).reciprocal_load(half_angle);
  return std::abs(coarse - exact) / std::max(exact, 1.0);
}

TEST(PinContact, ConvergesSpectrallyForBetaZero) {
  // The solution is analytic but for poles at s = +-i/b: the error of 1/lambda
  // is tan(theta0/4)^(4 n) times a power of n.
  for (const double theta0_deg : {100.0, 115.0}) {
    const double theta0 = theta0_deg * degree;
    const double exact = PinClosedForm(0.5).reciprocal_load(theta0);
    const double e8 = truncation_error(0, theta0, 8, exact);
    const double e10 = truncation_error(0, theta0, 10, exact);
    const double e12 = truncation_error(0, theta0, 12, exact);
    const double rate = std::pow(std::tan(theta0 / 4), 8);  // per 2 unknowns
    // The power of n: (10/8)^4 at most.
    EXPECT_LT(e10, e8 * rate * 2.5) << theta0_deg;
    EXPECT_LT(e12, e10 * rate * 2.5) << theta0_deg;
    EXPECT_GT(e8, 1e-10) << "too small to show a rate";
  }
}

TEST(PinContact, ConvergesWithSixthOrderOtherwise) {
  // A term (1 - s)^(3/2) ln(1 - s) at the edge: coefficients fall like k^-4,
  // the error of 1/lambda like n^-6.
  for (const double beta : {-0.5, -0.25, 0.25, 0.5}) {
    for (const double theta0_deg : {30.0, 60.0, 90.0}) {
      const double theta0 = theta0_deg * degree;
      const double exact =
          PinContact::from_dundurs(0.5, beta, 32).reciprocal_load(theta0);
      double before = truncation_error(beta, theta0, 8, exact);
      for (const int n : {12, 16, 20}) {
        const double now = truncation_error(beta, theta0, n, exact);
        // Order 6 with a margin for the small powers beside it: (n/(n-4))^5.
        EXPECT_LT(now, before * std::pow((n - 4.0) / n, 5))
            << beta << " " << theta0_deg << " " << n;
        before = now;
      }
      // The documented accuracy, against twice the unknowns.
      EXPECT_LT(truncation_error(beta, theta0, 16, exact), 1e-9);
    }
  }
}

TEST(PinContact, ErrorEstimateIsAnUpperBound) {
  for (const double beta : {-0.5, -0.2, 0.3}) {
    for (const double theta0_deg : {1.0, 30.0, 70.0, 110.0}) {
      const double theta0 = theta0_deg * degree;
      const ExactLoad load =
          PinContact::from_dundurs(0.1, beta).load_parameter(theta0);
      if (load.status != Status::ok) continue;
      const double exact =
          PinContact::from_dundurs(0.1, beta, 32).reciprocal_load(theta0);
      // Rounding: 1e-14 of 1/lambda.
      EXPECT_LE(std::abs(1 / load.load_parameter - exact),
                load.reciprocal_error + 1e-14 * exact)
          << beta << " " << theta0_deg;
    }
  }
}

TEST(PinContact, ReproducesTheFunctionsAandB) {
  const ReferenceTable table("conforming/cylinder_ab.csv");
  // 1/(2 lambda) = a - w_2 b. The table has ten digits: 5e-10 of the leading
  // one at most. a passes through 0: with 16 unknowns its error is measured
  // against 0.1 there.
  AccuracyReport a_report("a, 32 unknowns", 1e-9);
  AccuracyReport a_default("a, 16 unknowns", 1e-9);
  AccuracyReport b_report("b", 1e-9);
  for (const ReferenceTable::Row row : table) {
    const double theta0 = row.value("theta0_deg") * degree;
    const double beta = row.value("beta");
    const double expected = row.value("a");
    const std::string label = row.label();
    const double a =
        PinContact::from_dundurs(0, beta, 32).reciprocal_load(theta0) / 2;
    a_report.add(a, expected, label);
    const double a16 =
        PinContact::from_dundurs(0, beta).reciprocal_load(theta0) / 2;
    a_default.add_error(std::abs(a16 - expected) / std::max(expected, 0.1),
                        label);
    // b = p_0/p_1 = S/2, and by the definition.
    const ContactPressure p =
        PinContact::from_dundurs(0.7, beta).pressure(theta0);
    b_report.add(p.force_ratio() / 2, row.value("b"), label);
    const double difference =
        a16 - PinContact::from_dundurs(1, beta).reciprocal_load(theta0) / 2;
    EXPECT_NEAR(difference, p.force_ratio() / 2, 1e-14 * std::max(a, 10.0));
  }
}

// ∫ f over the contact; sin substitution against the square-root edge.
template <class F>
double integrate_contact(const F& f, double half_angle) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      [&](double u) {
        return f(half_angle * std::sin(u)) * half_angle * std::cos(u);
      },
      -pi / 2, pi / 2, 5, 1e-12);
}

TEST(ContactPressure, CarriesTheLoadAndKnowsItsSumAndSlope) {
  for (const double beta : {-0.4, 0.0, 0.3}) {
    for (const double theta0_deg : {1e-3, 20.0, 80.0, 115.0}) {
      const double theta0 = theta0_deg * degree;
      const ContactPressure p =
          PinContact::from_dundurs(0.5, beta).pressure(theta0);
      const double force = integrate_contact(
          [&p](double t) { return p.pressure(t) * std::cos(t); }, theta0);
      const double sum =
          integrate_contact([&p](double t) { return p.pressure(t); }, theta0);
      // Truncation of the coefficients beyond the 32nd.
      EXPECT_NEAR(force, 1, 1e-9) << beta << " " << theta0_deg;
      EXPECT_NEAR(sum, p.force_ratio(), 1e-9) << beta << " " << theta0_deg;
      for (const double share : {0.1, 0.5, 0.9}) {
        const double t = share * theta0;
        const double h = 1e-4 * theta0;
        const double difference =
            (p.pressure(t - h) - p.pressure(t + h)) / (2 * h);
        // Central difference: h^2/6 times the third derivative.
        EXPECT_NEAR(difference, p.slope(t), 1e-6 * p.slope(t));
      }
      EXPECT_EQ(p.pressure(-0.3 * theta0), p.pressure(0.3 * theta0));
      EXPECT_EQ(p.slope(-0.3 * theta0), -p.slope(0.3 * theta0));
      EXPECT_EQ(p.pressure(theta0), 0);
      EXPECT_EQ(p.pressure(std::nextafter(theta0, 4)), 0);
      EXPECT_EQ(p.slope(std::nextafter(theta0, 4)), 0);
      EXPECT_GT(p.pressure(std::nextafter(theta0, 0)), 0);
      EXPECT_EQ(p.slope(0), 0);
      EXPECT_EQ(p.peak(), p.pressure(0));
      EXPECT_TRUE(all_nan({p.pressure(nan), p.slope(nan)}));
    }
  }
}

TEST(PinContact, BadArguments) {
  EXPECT_THROW(PinContact::from_dundurs(0.5, 0, 7), Error);
  EXPECT_THROW(PinContact::from_dundurs(0.5, 0, 33), Error);
  EXPECT_THROW(PinContact::from_dundurs(-0.1, 0), Error);
  EXPECT_THROW(PinContact::from_dundurs(0.5, 0.51), Error);
  EXPECT_THROW(PinContact::from_dundurs(nan, 0), Error);
  EXPECT_THROW(PinContact::from_dundurs(0, nan), Error);
  for (const double bad : {-0.1, 1.6, nan}) {
    EXPECT_THROW(InnerLoading::back(bad), Error);
  }
}

}  // namespace
}  // namespace contact::test::pin_test
