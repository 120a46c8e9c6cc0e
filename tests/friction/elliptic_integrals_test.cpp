#include "libcontact/friction/elliptic/integrals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/friction/elliptic/integrals_real.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::elliptic_integrals_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

template <class Number>
void check_table(double budget) {
  const ReferenceTable table("elliptic.csv");
  const auto check = [&](const char* column, auto function) {
    AccuracyReport report(column, budget);
    for (const ReferenceTable::Row row : table) {
      // The inputs are doubles, also for the comparison at 50 digits.
      const Number p = row.value("p"), x = row.value("x");
      report.add(Number(function(p, x)), row.value<Number>(column),
                 row.label());
    }
  };
  using N = Number;
  check("K", [](const N&, const N& x) { return elliptic_k(x); });
  check("E", [](const N&, const N& x) { return elliptic_e(x); });
  check("Pi", [](const N& p, const N& x) { return elliptic_pi(p, x); });
  check("K_cosine", [](const N&, const N& x) { return elliptic_k_cosine(x); });
  check("K_sine", [](const N&, const N& x) { return elliptic_k_sine(x); });
  check("Pi_cosine",
        [](const N& p, const N& x) { return elliptic_pi_cosine(p, x); });
  check("Pi_sine",
        [](const N& p, const N& x) { return elliptic_pi_sine(p, x); });
}

TEST(Elliptic, AgreesWithTheReferenceInDouble) {
  // 1e-15, the documented bound: Carlson's duplication rounds some 20 times.
  check_table<double>(1e-15);
}

TEST(Elliptic, AgreesWithTheReferenceToItsLastDigits) {
  // The table has 25 digits: half a unit of the last one.
  check_table<Real>(5e-25);
}

// Double against 50 digits where the reference table has no points: a dense
// sweep over both arguments.
TEST(Elliptic, DoubleAgreesWithFiftyDigits) {
  AccuracyReport report("all seven", 1e-15);
  const auto add = [&](double computed, const Real& expected, double p,
                       double x) {
    report.add(Real(computed), expected,
               "p=" + std::to_string(p) + " x=" + std::to_string(x));
  };
  for (double px = -12; px <= 3; px += 1.37) {
    for (double xx = -18; xx <= 3; xx += 0.83) {
      const double p = std::pow(10, px), x = std::pow(10, xx);
      const Real rp = p, rx = x;
      add(elliptic_k(x), elliptic_k(rx), p, x);
      add(elliptic_e(x), elliptic_e(rx), p, x);
      add(elliptic_k_cosine(x), elliptic_k_cosine(rx), p, x);
      add(elliptic_k_sine(x), elliptic_k_sine(rx), p, x);
      add(elliptic_pi(p, x), elliptic_pi(rp, rx), p, x);
      add(elliptic_pi_cosine(p, x), elliptic_pi_cosine(rp, rx), p, x);
      add(elliptic_pi_sine(p, x), elliptic_pi_sine(rp, rx), p, x);
    }
  }
}

TEST(Elliptic, LegendreRelation) {
  for (const double x : {1e-12, 1e-3, 0.2, 0.5, 0.7}) {
    const Real k = elliptic_k(Real(x)), e = elliptic_e(Real(x));
    const Real k1 = elliptic_k(Real(1 - Real(x)));
    const Real e1 = elliptic_e(Real(1 - Real(x)));
    const Real& half_pi = boost::math::constants::half_pi<Real>();
    // 50 digits less one for the differences of terms up to 15.
    EXPECT_LT(abs(Real(e * k1 + e1 * k - k * k1 - half_pi)), 1e-48) << x;
  }
}

TEST(Elliptic, PartsAddUp) {
  for (const double x : {1e-20, 1e-3, 0.25, 0.5, 1.0, 4.0}) {
    const double k = elliptic_k_cosine(x) + elliptic_k_sine(x);
    const double e = elliptic_k_cosine(x) + x * elliptic_k_sine(x);
    // Each term to 1e-15, one rounding of the sum.
    EXPECT_NEAR(k / elliptic_k(x), 1, 2e-15) << x;
    EXPECT_NEAR(e / elliptic_e(x), 1, 2e-15) << x;
    for (const double p : {1e-6, 0.5, 2.0}) {
      const double pi = elliptic_pi_cosine(p, x) + elliptic_pi_sine(p, x);
      EXPECT_NEAR(pi / elliptic_pi(p, x), 1, 2e-15) << p << ' ' << x;
    }
  }
}

TEST(Elliptic, LimitsAndInvalidArguments) {
  EXPECT_EQ(elliptic_k(0.0), infinity);
  EXPECT_EQ(elliptic_e(0.0), 1);
  EXPECT_EQ(elliptic_k_cosine(0.0), 1);
  EXPECT_EQ(elliptic_k_sine(0.0), infinity);
  EXPECT_EQ(elliptic_pi(0.5, 0.0), infinity);
  EXPECT_EQ(elliptic_pi(0.0, 0.5), infinity);
  EXPECT_EQ(elliptic_pi_sine(0.5, 0.0), infinity);
  EXPECT_EQ(elliptic_pi_sine(0.0, 0.5), infinity);
  EXPECT_EQ(elliptic_pi_cosine(0.0, 0.5), elliptic_k(0.5));
  // int cos/(1 - n sin^2) = atanh(sqrt n)/sqrt n
  EXPECT_NEAR(elliptic_pi_cosine(0.5, 0.0),
              std::atanh(std::sqrt(0.5)) / std::sqrt(0.5), 1e-15);
  // pi/2 and pi/4 within the documented 1e-15.
  EXPECT_NEAR(elliptic_k(1.0), std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(elliptic_k_cosine(1.0), std::numbers::pi / 4, 1e-15);
  EXPECT_NEAR(elliptic_k_sine(1.0), std::numbers::pi / 4, 1e-15);
  for (const double bad : {nan, -0.1, infinity, -infinity}) {
    EXPECT_TRUE(all_nan(
        {elliptic_k(bad), elliptic_e(bad), elliptic_k_cosine(bad),
         elliptic_k_sine(bad), elliptic_pi(0.5, bad), elliptic_pi(bad, 0.5),
         elliptic_pi_cosine(0.5, bad), elliptic_pi_cosine(bad, 0.5),
         elliptic_pi_sine(0.5, bad), elliptic_pi_sine(bad, 0.5)}));
  }
}

TEST(Elliptic, NoJumpAcrossTheSwitches) {
  const double root_epsilon = 0x1p-26;
  for (const double x : {elliptic_policy::parts_switch, root_epsilon / 16}) {
    const double below = std::nextafter(x, 0.0);
    // One step of x moves nothing by more than its rounding, 1e-15 each.
    EXPECT_NEAR(elliptic_e(below) / elliptic_e(x), 1, 2e-15);
    EXPECT_NEAR(elliptic_k_cosine(below) / elliptic_k_cosine(x), 1, 2e-15);
    EXPECT_NEAR(elliptic_k_sine(below) / elliptic_k_sine(x), 1, 2e-15);
  }
  const double negligible = std::numeric_limits<double>::epsilon() / 128;
  for (const double p : {0.01, 1.0, 50.0}) {
    const double x = negligible * std::min(p, 1.0);
    EXPECT_NEAR(elliptic_pi_cosine(p, std::nextafter(x, 0.0)) /
                    elliptic_pi_cosine(p, std::nextafter(x, 1.0)),
                1, 2e-15)
        << p;
  }
  const double below = std::nextafter(1.0, 0.0);
  const double above = std::nextafter(1.0, 2.0);
  EXPECT_NEAR(elliptic_pi(below, 0.3) / elliptic_pi(above, 0.3), 1, 2e-15);
}

/// Largest relative error on x = 10^-u, 0 <= u <= 300, dense near x = 1.
template <class Approximation, class Exact>
double largest_error(Approximation approximation, Exact exact) {
  double largest = 0;
  const auto add = [&](double x) {
    largest = std::max(largest, std::abs(approximation(x) / exact(x) - 1));
  };
  for (int i = 1; i <= 4000; ++i) add(std::pow(i / 4000.0, 4));
  for (int i = 4; i <= 300; ++i) add(std::pow(10.0, -i));
  return largest;
}

double exact_k(double x) { return elliptic_k(x); }
double exact_e(double x) { return elliptic_e(x); }

TEST(EllipticChebyshev, HasTheErrorsOfThePaper) {
  // The paper promises about 0.3 %; recomputed 0.11 % and 0.27 %.
  const double k = largest_error(elliptic_k_chebyshev, exact_k);
  const double e = largest_error(elliptic_e_chebyshev, exact_e);
  EXPECT_NEAR(k, 0.0011, 0.00005);
  EXPECT_NEAR(e, 0.0027, 0.00005);
  EXPECT_EQ(elliptic_e_chebyshev(0.0), 1);
  EXPECT_TRUE(all_nan({elliptic_k_chebyshev(nan), elliptic_e_chebyshev(nan)}));
}

}  // namespace
}  // namespace contact::test::elliptic_integrals_test
