#include "libcontact/half_angle/fitted.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/coefficients.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/fitted_relation.hpp"
#include "libcontact/tools/reference/half_angle_fit.hpp"
#include "support/accuracy_report.hpp"
#include "support/elastic_cases.hpp"
#include "support/numbers.hpp"

namespace contact::test::fitted_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

std::string label(JointKind kind, const PairCase& pair, double load) {
  return to_string(kind) + ", " + pair.label() + ", load " +
         std::to_string(load);
}

// Pairs at random, none of them on the grid of the fit; every tenth with a
// rigid body.
std::vector<PairCase> random_pairs(int count, double smallest_nu,
                                   double largest_nu) {
  std::mt19937 generator(2005);
  std::uniform_real_distribution<> uniform(0, 1);
  std::vector<PairCase> pairs;
  for (int i = 0; i < count; ++i) {
    const double ratio = std::pow(10, -2 + 4 * uniform(generator));
    const double width = largest_nu - smallest_nu;
    const double nu1 = smallest_nu + width * uniform(generator);
    const double nu2 = smallest_nu + width * uniform(generator);
    pairs.push_back({i % 20 == 0   ? 0
                     : i % 20 == 1 ? infinity
                                   : ratio,
                     nu1, nu2});
  }
  return pairs;
}

// Tenths of decades from where Hertz holds to where the limit does.
std::vector<double> loads() {
  std::vector<double> values;
  for (int i = -80; i <= 80; ++i) values.push_back(std::pow(10, i / 10.0));
  values.push_back(infinity);
  return values;
}

void compare(const HalfAngleLaw& law, const PairCase& pair,
             AccuracyReport& report) {
  const JointKind kind = law.joint_kind();
  const ExactLaw exact(kind, pair.elastic());
  for (const double load : loads()) {
    const HalfAngleResult result = law.half_angle(load);
    ASSERT_EQ(result.status, Status::ok) << label(kind, pair, load);
    report.add(result.half_angle, exact.half_angle(load).half_angle,
               label(kind, pair, load));
  }
}

// --- Accuracy of the laws ---------------------------------------------------

TEST(FittedLaw, AgainstExactOnPairsTheFitDidNotSee) {
  // Budgets: the largest errors found, rounded up.
  AccuracyReport pin("fitted pin, nu 0.2 to 0.49", 1.5e-4);
  AccuracyReport ball("fitted ball, nu 0.2 to 0.49", 5e-4);
  for (const PairCase& pair : random_pairs(400, 0.2, 0.49)) {
    compare(FittedLaw(JointKind::pin, pair.elastic()), pair, pin);
    compare(FittedLaw(JointKind::ball, pair.elastic()), pair, ball);
  }
}

TEST(FittedLaw, AgainstExactOnEveryPair) {
  // nu from 0 to 0.5, and the corners of everything. The exact ball ends at
  // 175 deg and the exact pin at 163 deg: there they are left out.
  AccuracyReport pin("fitted pin, nu 0 to 0.5", 2.1e-4);
  AccuracyReport ball("fitted ball, nu 0 to 0.5", 7e-4);
  std::vector<PairCase> pairs = random_pairs(200, 0, 0.5);
  for (const double ratio : {0.0, 1e-6, 1e-2, 1.0, 1e2, 1e6, infinity}) {
    for (const double nu1 : {0.0, 0.2, 0.3, 0.49, 0.495, 0.5}) {
      for (const double nu2 : {0.0, 0.2, 0.3, 0.49, 0.5}) {
        pairs.push_back({ratio, nu1, nu2});
      }
    }
  }
  for (const PairCase& pair : pairs) {
    const ElasticPair elastic = pair.elastic();
    for (const JointKind kind : kinds) {
      if (!ExactLaw(kind, elastic).validity_notes(elastic).empty()) continue;
      compare(FittedLaw(kind, elastic), pair,
              kind == JointKind::pin ? pin : ball);
    }
  }
}

TEST(FittedLaw, IsThePinsClosedFormForBetaZero) {
  for (const PairCase& pair :
       {PairCase{1, 0.3, 0.3}, PairCase{0.01, 0.5, 0.5}}) {
    const FittedLaw law(JointKind::pin, pair.elastic());
    const ExactLaw exact(JointKind::pin, pair.elastic());
    for (const double load : loads()) {
      EXPECT_NEAR(law.half_angle(load).half_angle,
                  exact.half_angle(load).half_angle, 1e-14);
    }
  }
  // 180 deg, where the contact closes up.
  EXPECT_EQ(FittedLaw(JointKind::pin, PairCase{0, 0.5, 0.3}.elastic())
                .limit_half_angle(),
            180 * degree);
}

// --- The coefficients -------------------------------------------------------

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  const std::regex number(R"(-?\d+\.\d+)");
  for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end;
       ++i) {
    numbers.push_back(std::stod(i->str()));
  }
  return numbers;
}

TEST(HalfAngleFit, ReproducesTheCommittedCoefficients) {
  std::ifstream file(std::string(CONTACT_DATA_DIR) +
                     "/../libcontact/half_angle/coefficients.hpp");
  std::stringstream committed;
  committed << file.rdbuf();
  const std::string made = reference::half_angle_coefficients_header();
  const std::vector<double> expected = numbers_of(committed.str());
  const std::vector<double> found = numbers_of(made);
  // 2 x 5 and 4 x 5, and the two errors in comments.
  ASSERT_EQ(expected.size(), 32U);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    // The optimum is flat: another order of rounding moves the last printed
    // digits, seen 3e-5. The committed ones are of a kernel of balls that was
    // exact to 7e-13, today's to 6e-15: 1.04e-3, and the errors in the comments
    // are the same.
    EXPECT_NEAR(found[i], expected[i], 2e-3);
  }
  if (found == expected) {
    EXPECT_EQ(made, committed.str());
  }
}

// --- The code ---------------------------------------------------------------

TEST(FittedLaw, ClosedFormsAgreeWithFiftyDigits) {
  AccuracyReport report("closed forms of the fitted laws", 1e-14);
  for (const double theta :
       {1e-100, 1e-12, 1e-4, 0.01, 0.3, std::nextafter(0.5, 0), 0.5,
        std::nextafter(0.5, 1), 0.7, 1.0, 1.5}) {
    const Real t = theta;
    const Real s = sin(t / 2);
    const Real c = cos(t / 2) * cos(t / 2);
    for (const double constant : {-1.0, -0.8, 0.0, 0.3, 1.0}) {
      const auto value = [&](JointKind kind) {
        return detail::fitted_closed_form(kind, constant, theta,
                                          std::sin(theta / 2),
                                          std::cos(theta / 2))
            .value;
      };
      const std::string name =
          std::to_string(theta) + " " + std::to_string(constant);
      // Both kinds as docs/internals/fitted_laws.md writes them; absolute where
      // F changes its sign. Below 1e-12 fifty digits cancel as well.
      const Real pin = c * c - constant * (2 * s * s * s * s - c * c * log(c));
      report.add_error(double(abs(value(JointKind::pin) - pin)), name);
      if (theta < 1e-12) continue;
      const Real& pi = boost::math::constants::pi<Real>();
      const Real disc = t - sin(t) * cos(t);
      const Real h1 = disc / 2 + sin(t) * sin(t) * sin(t) / 3;
      const Real h0 = disc / 2 + sin(t) - t * cos(t);
      const Real ball = Real(16) / 3 * s * s * s / h1 *
                        (2 * cos(t) - 1 - 2 / pi * constant * h0);
      report.add_error(double(abs(value(JointKind::ball) - ball)), name);
    }
  }
}

// theta0 -> load -> theta0, close to both ends and at the switch of the
// power series (0.5 rad).
TEST(FittedLaw, RoundTrips) {
  AccuracyReport report("fitted theta0 -> load -> theta0, over the limit",
                        1e-14);
  for (const JointKind kind : kinds) {
    for (const PairCase& pair : fitted_pairs) {
      const FittedLaw law(kind, pair.elastic());
      const double limit = law.limit_half_angle();
      for (const double angle :
           {1e-200, 1e-9, 1e-4 * degree, 0.01, 0.2, std::nextafter(0.5, 0), 0.5,
            std::nextafter(0.5, 1), 1.0, 1.2, limit - 1e-3 * degree,
            std::nextafter(limit, 0)}) {
        // (At 180 deg F has a zero of fourth order and theta0 few digits.)
        if (angle > limit || (limit > 3.1 && angle > 3.1)) continue;
        const LoadParameterResult load = law.load_parameter(angle);
        EXPECT_EQ(load.status, Status::ok);
        if (!(load.load_parameter >= 1e-307)) continue;
        report.add_error(
            std::abs(law.half_angle(load.load_parameter).half_angle - angle) /
                limit,
            label(kind, pair, load.load_parameter));
      }
    }
  }
}

}  // namespace
}  // namespace contact::test::fitted_test
