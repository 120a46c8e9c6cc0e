// Properties common to the exact solutions of balls and pins: each test is one
// of both.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::exact_contact_test {
namespace {

struct Ball : BallContact {
  using BallContact::BallContact;
  static constexpr const char* name = "sphere";  // in the tables
  static constexpr const char* load = "mu";
  // The tables' own: differences up to 1.7e-4 deg at nu_2 = 0.45 and 0.49,
  // where this solution is converged to 1e-7 deg.
  static constexpr double angle_deg = 1e-4;
  static constexpr double limit_deg = 2e-4;
  static constexpr double carried = 1e-7;
  static double weight(double theta) { return 2 * pi * std::sin(theta); }
  // Near a limit of 180 deg the curve is flat (1/mu = 1e-7 at 173 deg) and its
  // rounding shows; elsewhere the root's own tolerance.
  static double inverse(double theta0) { return theta0 < 2.5 ? 1e-12 : 1e-8; }
  // theta0* - theta0 at a load of 1e8 goes like 1/load, by less than 10 rad.
  static constexpr double near_limit = 1e-7;
  static constexpr double largest_near_limit = 2;
  // An incompressible ball in a rigid seat: the limit is 180 deg.
  static bool is_endless(double ratio, double inner_poisson) {
    return ratio == 0 && inner_poisson == 0.5;
  }
  static constexpr double endless_load = 1e6;
  // The load parameter and the pressure of Hertz' theory, and how far from
  // them: the next term is of the order A x ln x with A <= 0.5/pi.
  static double hertz_angle(double mu) { return std::cbrt(mu); }
  static double hertz_peak(double theta0) {
    return 3 / (2 * pi * theta0 * theta0);
  }
  static constexpr double hertz_loads[] = {1e-24, 1e-17, 1e-9};
  static double hertz_error(double x) { return 0.3 * x * std::log(1 / x); }
  static double hertz_pressure_error(double theta0) {
    return theta0 * std::log(1 / theta0);
  }
};

struct Pin : PinContact {
  using PinContact::PinContact;
  static constexpr const char* name = "cylinder";
  static constexpr const char* load = "lambda";
  static constexpr double angle_deg = 1e-5;    // five decimals
  static constexpr double limit_deg = 5.1e-5;  // four decimals
  static constexpr double carried = 1e-9;
  static double weight(double) { return 2; }
  static double inverse(double) { return 1e-13; }
  static constexpr double near_limit = 1e-8;  // less than 1 rad
  static constexpr double largest_near_limit = 4;
  // With Ebar = 1e-6 still beyond what 16 unknowns resolve.
  static bool is_endless(double ratio, double inner_poisson) {
    return ratio <= 1e-6 && inner_poisson == 0.5;
  }
  static constexpr double endless_load = 100;
  static double hertz_angle(double lambda) { return 2 * std::sqrt(lambda); }
  static double hertz_peak(double theta0) { return 2 / (pi * theta0); }
  static constexpr double hertz_loads[] = {1e-16, 1e-12, 1e-8};
  // The next term is of the order beta x: 0.5 x at most.
  static double hertz_error(double x) { return 0.6 * x; }
  static double hertz_pressure_error(double theta0) { return theta0; }
};

// 10^(k/10) for the k whose rounded print is the argument.
double decade_tenth(double printed) {
  return std::pow(10, std::round(10 * std::log10(printed)) / 10);
}

template <class Contact>
class ExactContact : public testing::Test {
 protected:
  static std::string file(const std::string& of) {
    return std::string("conforming/") + Contact::name + "_" + of + ".csv";
  }
  static Contact of(double ratio, double nu1, double nu2) {
    return Contact(ElasticPair::from_modulus_ratio(ratio, nu1, nu2));
  }
  // ∬ p cos theta: 1 if the pressure carries the load. The sine is for the
  // square-root edge.
  static double carried_load(const ContactPressure& p, double theta0) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        [&](double u) {
          const double t = theta0 * std::sin(u);
          return p.pressure(t) * std::cos(t) * Contact::weight(t) * theta0 *
                 std::cos(u);
        },
        0.0, pi / 2, 5, 1e-12);
  }
};

struct Names {
  template <class Contact>
  static std::string GetName(int) {
    return Contact::name;
  }
};
using BallAndPin = testing::Types<Ball, Pin>;
TYPED_TEST_SUITE(ExactContact, BallAndPin, Names);

TYPED_TEST(ExactContact, ReproducesTheHalfAngles) {
  const ReferenceTable table(this->file("theta0"));
  AccuracyReport report("theta0, deg", TypeParam::angle_deg);
  for (const ReferenceTable::Row row : table) {
    // The loads are tenths of decades, printed with six digits.
    const ExactHalfAngle result =
        this->of(row.value("Ebar"), 0.3, 0.3)
            .half_angle(decade_tenth(row.value(TypeParam::load)));
    EXPECT_EQ(result.status, Status::ok) << row.label();
    EXPECT_LE(result.evaluations, 20) << row.label();
    report.add_error(
        std::abs(result.half_angle / degree - row.value("theta0_deg")),
        row.label());
  }
}

TYPED_TEST(ExactContact, ReproducesTheLimitAngles) {
  const ReferenceTable table(this->file("limit_angle"));
  AccuracyReport report("theta0*, deg", TypeParam::limit_deg);
  for (const ReferenceTable::Row row : table) {
    const auto contact =
        this->of(row.value("Ebar"), row.value("nu1"), row.value("nu2"));
    report.add_error(std::abs(contact.limit_half_angle().half_angle / degree -
                              row.value("theta_lim_exact_deg")),
                     row.label());
  }
}

TYPED_TEST(ExactContact, ReproducesThePressures) {
  const ReferenceTable table("conforming/pressure_profiles.csv");
  AccuracyReport report("p / peak", 1e-6);  // asked for
  for (const ReferenceTable::Row row : table) {
    if (row.text("joint") != TypeParam::name) continue;
    const auto contact = this->of(row.value("Ebar"), 0.3, 0.3);
    // The last profile of each pair is at the limit angle, printed with four
    // decimals of a degree like its angles.
    double theta0 = row.value("theta0_deg") * degree;
    const double limit = contact.limit_half_angle().half_angle;
    double tolerance = 0;
    if (std::abs(theta0 - limit) < 1e-4 * degree) {
      theta0 = limit;
      tolerance = 5e-5 * degree;  // times the slope
    }
    const double theta = row.value("theta_deg") * degree;
    // At the edge itself the slope is infinite and p is 0.
    if (theta > 0.9999 * theta0) continue;
    const ContactPressure p = contact.pressure(theta0);
    const double expected =
        row.value("p_exact*rho^2/Rn (sphere) or p*rho/P (cyl)");
    const double error = std::abs(p.pressure(theta) - expected);
    report.add_error(
        std::max(0.0, error - tolerance * p.slope(theta)) / p.peak(),
        row.label());
  }
}

TYPED_TEST(ExactContact, ReproducesSAndThePeakPressure) {
  const ReferenceTable table("conforming/pressure_friction.csv");
  AccuracyReport ratio("S", 1e-6);    // six decimals of 1
  AccuracyReport peak("peak", 2e-6);  // six decimals of 0.6 to 60
  for (const ReferenceTable::Row row : table) {
    if (row.text("joint") != TypeParam::name) continue;
    const double nu = row.value("nu");
    const auto contact = this->of(row.value("Ebar"), nu, nu);
    double theta0 = row.value("theta0_deg") * degree;
    const double limit = contact.limit_half_angle().half_angle;
    if (std::abs(theta0 - limit) < 1e-4 * degree) theta0 = limit;
    const ContactPressure p = contact.pressure(theta0);
    ratio.add(p.force_ratio(), row.value("S_exact"), row.label());
    peak.add(p.peak(), row.value("pmax_exact"), row.label());
  }
}

TYPED_TEST(ExactContact, TendsToHertz) {
  // The first two have Dundurs' beta at its ends, -0.5 and 0.5.
  for (const auto& [ratio, nu1, nu2] : {std::array{0.0, 0.0, 0.0},
                                        {infinity, 0.0, 0.0},
                                        {0.0, 0.1, 0.4},
                                        {1.0, 0.1, 0.4},
                                        {infinity, 0.1, 0.4}}) {
    const auto contact = this->of(ratio, nu1, nu2);
    for (const double load : TypeParam::hertz_loads) {
      const double x = TypeParam::hertz_angle(load);
      const double theta0 = contact.half_angle(load).half_angle;
      EXPECT_NEAR(theta0, x, (TypeParam::hertz_error(x) + 1e-13) * x)
          << ratio << " " << nu1 << " " << load;
      const ContactPressure p = contact.pressure(theta0);
      for (const double share : {0.0, 0.6, 0.99}) {
        const double hertz = TypeParam::hertz_peak(theta0) *
                             std::sqrt((1 - share) * (1 + share));
        EXPECT_NEAR(p.pressure(share * theta0) / hertz, 1,
                    TypeParam::hertz_pressure_error(theta0) + 1e-12);
      }
    }
  }
}

// Rigid and nearly rigid bodies, Poisson's ratio from end to end, loads up to
// 1e8, half-angles from 1e-4 deg to 1e-3 deg from the limit: there and back
// again.
TYPED_TEST(ExactContact, ReachesTheExtremes) {
  for (const double ratio : {0.0, 1e-6, 1.0, 1e6, infinity}) {
    for (const double nu1 : {0.0, 0.3, 0.5}) {
      for (const double nu2 : {0.0, 0.3, 0.5}) {
        const auto contact = this->of(ratio, nu1, nu2);
        const std::string label = std::to_string(ratio) + " " +
                                  std::to_string(nu1) + " " +
                                  std::to_string(nu2);
        const ExactHalfAngle limit = contact.limit_half_angle();
        if (TypeParam::is_endless(ratio, nu1)) {
          EXPECT_EQ(limit.status, Status::not_converged) << label;
          EXPECT_EQ(limit.half_angle, contact.largest()) << label;
          EXPECT_EQ(contact.half_angle(TypeParam::endless_load).status,
                    Status::ok)
              << label;
          continue;
        }
        EXPECT_EQ(limit.status, Status::ok) << label;
        for (const double theta0 :
             {1e-4 * degree, 1.0, limit.half_angle - 1e-3 * degree}) {
          const ExactLoad load = contact.load_parameter(theta0);
          ASSERT_EQ(load.status, Status::ok) << label;
          const ExactHalfAngle back = contact.half_angle(load.load_parameter);
          EXPECT_EQ(back.status, Status::ok) << label;
          EXPECT_NEAR(back.half_angle, theta0,
                      TypeParam::inverse(theta0) * theta0)
              << label;
        }
        const double theta8 = contact.half_angle(1e8).half_angle;
        EXPECT_LT(theta8, limit.half_angle) << label;
        if (limit.half_angle < TypeParam::largest_near_limit) {
          EXPECT_GT(theta8, limit.half_angle - TypeParam::near_limit) << label;
        }
      }
    }
  }
}

// The ball or pin is flattened: the contact is wider than under a centre force,
// and the wider the smaller the patch.
TYPED_TEST(ExactContact, LoadThroughTheBack) {
  const ElasticPair pair = ElasticPair::from_modulus_ratio(0, 0.3, 0.3);
  // A rigid body is the same under every loading.
  const ElasticPair rigid = ElasticPair::from_modulus_ratio(infinity, 0.3, 0.3);
  EXPECT_EQ(TypeParam(rigid, InnerLoading::back(0.5)).reciprocal_load(1),
            TypeParam(rigid).reciprocal_load(1));
  for (const double load : {0.01, 1.0, 100.0}) {
    double before = TypeParam(pair).half_angle(load).half_angle;
    for (const double psi : {1.2, 0.8, 0.4, 0.1, 0.0}) {
      const TypeParam contact(pair, InnerLoading::back(psi));
      const double theta0 = contact.half_angle(load).half_angle;
      EXPECT_GT(theta0, before) << load << " " << psi;
      before = theta0;
      EXPECT_NEAR(this->carried_load(contact.pressure(theta0), theta0), 1,
                  TypeParam::carried);
    }
    // A point force is the limit of small patches, quadratic in psi.
    const double tiny =
        TypeParam(pair, InnerLoading::back(1e-6)).half_angle(load).half_angle;
    EXPECT_NEAR(tiny, before, 1e-11);
  }
  const TypeParam wide(pair, InnerLoading::back(pi / 2));
  EXPECT_LT(wide.largest(), pi / 2);
  EXPECT_TRUE(std::isnan(wide.reciprocal_load(pi / 2)));
}

TYPED_TEST(ExactContact, BadArguments) {
  const ElasticPair pair = ElasticPair::from_modulus_ratio(1, 0.3, 0.2);
  for (const int unknowns : {7, 33}) {
    EXPECT_THROW(TypeParam(pair, InnerLoading::centre(), unknowns), Error);
  }
  const TypeParam contact(pair);
  EXPECT_EQ(contact.half_angle(0).half_angle, 0);
  EXPECT_EQ(contact.load_parameter(0).load_parameter, 0);
  const double limit = contact.limit_half_angle().half_angle;
  EXPECT_EQ(contact.load_parameter(limit + 1e-6).status, Status::out_of_range);
  for (const double bad : {nan, -1.0}) {
    EXPECT_EQ(contact.half_angle(bad).status, Status::out_of_range);
    EXPECT_TRUE(std::isnan(contact.half_angle(bad).half_angle));
    EXPECT_EQ(contact.load_parameter(bad).status, Status::out_of_range);
    EXPECT_TRUE(
        all_nan({contact.load_parameter(bad).load_parameter,
                 contact.reciprocal_load(bad), contact.pressure(bad).peak(),
                 contact.pressure(bad).force_ratio()}));
  }
}

}  // namespace
}  // namespace contact::test::exact_contact_test
