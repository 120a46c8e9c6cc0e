#include "libcontact/conforming/ball.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <vector>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/conforming/back_displacement.hpp"
#include "libcontact/conforming/kernel/ball_kernel.hpp"
#include "libcontact/conforming/legendre_galerkin.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::ball_test {
namespace {

double kernel_value(const detail::BallKernel& kernel, double x) {
  double value = 0;
  kernel.evaluate({&x, 1}, {&value, 1});
  return value;
}

constexpr detail::BallConstants constants[] = {
    {1, 0, 0, 0.3}, {0, 0.3, 1, 0}, {0.4, 0.2, 0.6, 0.35}, {1, 0.5, 0, 0}};

// (n + 1/2)(w_1 s_n + w_2 e_n) - 1 from the compliances themselves.
double harmonic(const detail::BallConstants& c, int n) {
  if (n == 1) return 0;
  return (n + 0.5) *
             (c.inner_share * detail::ball_compliance(n, c.inner_poisson) +
              c.outer_share * detail::cavity_compliance(n, c.outer_poisson)) -
         1;
}

TEST(BallKernel, IsTheSumOfItsHarmonics) {
  // The sum ends in a smooth taper instead of a cut: its error falls faster
  // than any power of terms x. Rounding of 2e5 terms: 1e-13.
  constexpr int terms = 200000;
  for (const detail::BallConstants& c : constants) {
    const detail::BallKernel kernel(c);
    for (const double x : {0.01, 0.3, 1.5, 3.0, 3.3, 6.0, 6.27}) {
      double sum = 0;
      for (int n = 0; n < terms; ++n) {
        sum += harmonic(c, n) * std::cos((n + 0.5) * x) *
               std::erfc(12.0 * (2.0 * n / terms - 1)) / 2;
      }
      EXPECT_NEAR(kernel_value(kernel, x), sum, 2e-12) << x;
    }
    // Both sides of the fold at pi.
    EXPECT_NEAR(kernel_value(kernel, std::nextafter(pi, 0)), 0, 1e-12);
    EXPECT_NEAR(kernel_value(kernel, std::nextafter(pi, 4)), 0, 1e-12);
  }
}

// Partial fractions of d_n, sum e^(iNx)/(N - r) by Lerch's integral, in 30
// digits (mpmath); x = 0.3, 1.5, 3.
TEST(BallKernel, IsExactToItsLastDigits) {
  constexpr double expected[][3] = {
      {-0.689072207884992508, -0.645679661826412009, -0.00232563031983970126},
      {-0.897976245676133162, -0.567689891660720366, -0.105005913623470626},
      {-0.787240276776852002, -0.628368375469262995, -0.0457400541327817196},
      {-0.746257368564249564, -0.905590732752613539, 0.0052576390283812046}};
  for (int i = 0; i < 4; ++i) {
    const detail::BallKernel kernel(constants[i]);
    int j = 0;
    for (const double x : {0.3, 1.5, 3.0}) {
      // Terms up to 5: their roundings.
      EXPECT_NEAR(kernel_value(kernel, x), expected[i][j], 1e-14) << x;
      ++j;
    }
  }
}

TEST(BallKernel, IsALogarithmAtZero) {
  // kappa(x) = -A ln x + const + O(x ln x), A = w_1 a(nu_1) - w_2 a(nu_2),
  // a(v) = (1-2v)^2/(2(1-v)).
  for (const detail::BallConstants& c : constants) {
    const auto a = [](double v) {
      return (1 - 2 * v) * (1 - 2 * v) / (2 * (1 - v));
    };
    const double slope =
        c.inner_share * a(c.inner_poisson) - c.outer_share * a(c.outer_poisson);
    const detail::BallKernel kernel(c);
    const double difference =
        kernel_value(kernel, 1e-14) - kernel_value(kernel, 1e-12);
    EXPECT_NEAR(difference, slope * std::log(100.0), 1e-10);
    EXPECT_NEAR(kernel.log_coefficient(), slope, 1e-15);
  }
}

TEST(LegendreGalerkin, MatchesSphericalBesselSums) {
  // ∬ P_2i P_2j kappa(theta0 (v - w)) = sum d_n c_ni c_nj,
  // c_ni = ∫ P_2i(v) cos((n+1/2) theta0 v) dv = 2 (-1)^i j_2i((n+1/2) theta0):
  // the sum of the sheet that the method does not form. What 20000 terms
  // leave falls like n^-2 and oscillates: 1e-9.
  const detail::LegendreGalerkin& table = detail::LegendreGalerkin::table(16);
  const detail::BallConstants& c = constants[2];
  const detail::BallKernel kernel(c);
  const double theta0 = 1.1;
  Eigen::VectorXd x = theta0 * table.node;
  Eigen::VectorXd kappa(x.size());
  kernel.evaluate({x.data(), static_cast<std::size_t>(x.size())},
                  {kappa.data(), static_cast<std::size_t>(x.size())});
  const Eigen::VectorXd packed = table.correlation * kappa;
  for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {3, 1}, {12, 12}}) {
    double sum = 0;
    for (int n = 0; n < 20000; ++n) {
      const double argument = (n + 0.5) * theta0;
      sum += harmonic(c, n) * 4 * ((i + j) % 2 == 0 ? 1 : -1) *
             boost::math::sph_bessel(2 * i, argument) *
             boost::math::sph_bessel(2 * j, argument);
    }
    EXPECT_NEAR(packed(i * (i + 1) / 2 + j), sum, 2e-9) << i << " " << j;
  }
}

TEST(EvenLegendreSlope, MatchesTheDerivative) {
  const std::vector<double> u = {0.3, -1.2, 0.7, 0.05, -0.4};
  const Eigen::VectorXd series =
      detail::even_legendre_slope(static_cast<int>(u.size())) *
      Eigen::VectorXd::Map(u.data(), static_cast<Eigen::Index>(u.size()));
  for (const double v : {1e-12, 0.1, 0.5, 0.99, 1.0}) {
    double expected = 0;
    for (std::size_t j = 1; j < u.size(); ++j) {
      expected +=
          u[j] * boost::math::legendre_p_prime(static_cast<int>(2 * j), v) / v;
    }
    double slope = 0;
    for (int k = 0; k < series.size(); ++k) {
      slope += series(k) * std::cos(2 * k * std::acos(v));
    }
    // Derivatives of size 40 with alternating signs.
    EXPECT_NEAR(slope, expected, 1e-13 * 40) << v;
  }
}

TEST(BackDisplacement, IsTheSumOfItsHarmonics) {
  for (const double nu : {0.0, 0.3, 0.5}) {
    for (const double psi : {0.2, 1.0, pi / 2}) {
      const detail::BackDisplacement back(nu, psi);
      const double c = std::cos(psi);
      for (const double share : {0.0, 0.3, 0.79, 0.81, 0.9}) {
        const double f = share * (pi - psi);
        // Tapered like the kernel above; the terms fall like n^-2.5.
        constexpr int terms = 20000;
        double sum = 0;
        double before = 1;
        double now = 1;
        double next = c;
        for (int n = 0; n < terms; ++n) {
          // q_n of a unit pi rho^2: (-1)^n (P_{n-1} - P_{n+1})/(2 sin^2 psi).
          const double q =
              (n % 2 == 0 ? 1 : -1) * (before - next) / (2 * (1 - c * c));
          if (n != 1) {
            sum += detail::ball_compliance(n, nu) * q *
                   std::cos((n + 0.5) * f) *
                   std::erfc(6.0 * (2.0 * n / terms - 1)) / 2;
          }
          before = now;
          now = next;
          next = boost::math::legendre_next(n + 1, c, now, before);
        }
        // Rounding of the Legendre recurrence.
        EXPECT_NEAR(back(f), 2 / pi * sum, 1e-12)
            << nu << " " << psi << " " << share;
      }
      // Both sides of the switch between series and quadrature.
      EXPECT_NEAR(back(std::nextafter(back.series_end(), 0)),
                  back(std::nextafter(back.series_end(), 4)), 2e-13);
      EXPECT_EQ(back(0.3), back(-0.3));
    }
  }
  // A point force: sum of (-1)^n cos((n+1/2) f)/... has no series that ends;
  // the limit of small patches.
  EXPECT_NEAR(detail::BackDisplacement(0.3, 0)(1.0),
              detail::BackDisplacement(0.3, 1e-7)(1.0), 1e-13);
}

TEST(BallContact, Converges) {
  // Against 32 unknowns: the error of 1/mu, over the larger of 1/mu and 1,
  // falls like n^-6 or better.
  double worst_16 = 0;
  double worst_8 = 0;
  for (const double ratio : {0.0, 0.3, 1.0, infinity}) {
    for (const double nu : {0.0, 0.25, 0.5}) {
      const ElasticPair pair =
          ElasticPair::from_modulus_ratio(ratio, nu, 0.4 * nu);
      const auto ball = [&pair](int unknowns) {
        return BallContact(pair, InnerLoading::centre(), unknowns);
      };
      for (const double theta0_deg : {0.01, 10.0, 45.0, 90.0, 120.0}) {
        const double theta0 = theta0_deg * degree;
        const double exact = ball(32).reciprocal_load(theta0);
        const auto error = [&](int unknowns) {
          return std::abs(ball(unknowns).reciprocal_load(theta0) - exact) /
                 std::max(exact, 1.0);
        };
        const double e8 = error(8);
        const double e16 = error(16);
        worst_8 = std::max(worst_8, e8);
        worst_16 = std::max(worst_16, e16);
        // 2^-5, down to rounding.
        EXPECT_LT(e16, e8 / 32 + 2e-13)
            << ratio << " " << nu << " " << theta0_deg;
      }
    }
  }
  // The documented accuracies; 5e-8 and 5e-10 are measured.
  EXPECT_LT(worst_8, 1e-6);
  EXPECT_LT(worst_16, 1e-8);
  EXPECT_GT(worst_8, 1e-12) << "too small to show a rate";
}

TEST(BallContact, ErrorEstimateIsAnUpperBound) {
  for (const double ratio : {0.0, 1.0, infinity}) {
    for (const double nu : {0.0, 0.3, 0.5}) {
      const ElasticPair pair = ElasticPair::from_modulus_ratio(ratio, nu, 0.1);
      for (const int unknowns : {8, 12, 16}) {
        for (const double theta0_deg : {1.0, 40.0, 75.0}) {
          const double theta0 = theta0_deg * degree;
          const ExactLoad load =
              BallContact(pair, InnerLoading::centre(), unknowns)
                  .load_parameter(theta0);
          ASSERT_EQ(load.status, Status::ok);
          const double exact = BallContact(pair, InnerLoading::centre(), 32)
                                   .reciprocal_load(theta0);
          // Rounding: 5e-14 of 1/mu.
          EXPECT_LE(std::abs(1 / load.load_parameter - exact),
                    load.reciprocal_error + 5e-14 * exact)
              << ratio << " " << nu << " " << unknowns << " " << theta0_deg;
        }
      }
    }
  }
}

TEST(BallContact, ReproducesTheLoads) {
  const ReferenceTable table("conforming/sphere_mu_of_theta0.csv");
  // The table's half-angles are good to 1e-4 deg.
  AccuracyReport report("theta0 at mu, deg", 1e-4);
  for (const ReferenceTable::Row row : table) {
    const BallContact ball(ElasticPair::from_modulus_ratio(
        row.value("Ebar"), row.value("nu1"), row.value("nu2")));
    const ExactHalfAngle result = ball.half_angle(row.value("mu"));
    report.add_error(
        std::abs(result.half_angle / degree - row.value("theta0_deg")),
        row.label());
  }
}

// ∫ f over [0, theta0]; sin substitution against the square-root edge.
template <class F>
double integrate_contact(const F& f, double half_angle) {
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      [&](double u) {
        return f(half_angle * std::sin(u)) * half_angle * std::cos(u);
      },
      0.0, pi / 2, 5, 1e-12);
}

TEST(BallContact, ReproducesTheFrictionCoefficients) {
  const ReferenceTable table("conforming/pressure_friction.csv");
  AccuracyReport chi("chi", 2e-6);  // six decimals of 1, at a = 0
  AccuracyReport sliding("sigma_Y", 2e-6);
  for (const ReferenceTable::Row row : table) {
    if (row.text("joint") != "sphere") continue;
    const double nu = row.value("nu");
    const BallContact ball(
        ElasticPair::from_modulus_ratio(row.value("Ebar"), nu, nu));
    double theta0 = row.value("theta0_deg") * degree;
    const double limit = ball.limit_half_angle().half_angle;
    if (std::abs(theta0 - limit) < 1e-4 * degree) theta0 = limit;
    const ContactPressure p = ball.pressure(theta0);
    // a = 0: with k = sin t the inner integrals over f are
    // 4 cos t K(k) and 4 E(k).
    chi.add(integrate_contact(
                [&p](double t) {
                  return p.pressure(t) * std::sin(t) * 4 * std::cos(t) *
                         boost::math::ellint_1(std::sin(t));
                },
                theta0),
            row.value("chi_exact"), row.label());
    sliding.add(integrate_contact(
                    [&p](double t) {
                      return p.pressure(t) * std::sin(t) * 4 *
                             boost::math::ellint_2(std::sin(t));
                    },
                    theta0),
                row.value("sigmaY_exact"), row.label());
  }
}

TEST(BallContact, PressureCarriesTheLoad) {
  for (const double ratio : {0.0, 1.0, infinity}) {
    for (const double nu : {0.0, 0.3, 0.5}) {
      const BallContact ball(ElasticPair::from_modulus_ratio(ratio, nu, nu));
      for (const double theta0_deg : {1e-3, 20.0, 80.0, 115.0}) {
        const double theta0 = theta0_deg * degree;
        const ContactPressure p = ball.pressure(theta0);
        const double force = integrate_contact(
            [&p](double t) {
              return 2 * pi * p.pressure(t) * std::cos(t) * std::sin(t);
            },
            theta0);
        const double sum = integrate_contact(
            [&p](double t) { return 2 * pi * p.pressure(t) * std::sin(t); },
            theta0);
        // Two ways from h to the force, and the quadrature of the pressure:
        // the documented accuracy.
        EXPECT_NEAR(force, 1, 3e-7) << ratio << " " << nu << " " << theta0_deg;
        EXPECT_NEAR(sum, p.force_ratio(), 3e-7)
            << ratio << " " << nu << " " << theta0_deg;
      }
    }
  }
}

TEST(BallContact, PressureConverges) {
  // Against 32 unknowns; nu = 0 is the worst case.
  double worst = 0;
  for (const double ratio : {0.0, infinity}) {
    const ElasticPair pair = ElasticPair::from_modulus_ratio(ratio, 0, 0);
    const auto pressure = [&pair](int unknowns, double theta0) {
      return BallContact(pair, InnerLoading::centre(), unknowns)
          .pressure(theta0);
    };
    for (const double theta0 : {1e-3, 0.5, 1.5, 2.0}) {
      const ContactPressure fine = pressure(32, theta0);
      const ContactPressure usual = pressure(16, theta0);
      const ContactPressure coarse = pressure(8, theta0);
      double usual_error = 0;
      double coarse_error = 0;
      for (int i = 0; i < 1000; ++i) {
        const double t = theta0 * i / 1000;
        const double p = fine.pressure(t);
        usual_error = std::max(usual_error, std::abs(usual.pressure(t) - p));
        coarse_error = std::max(coarse_error, std::abs(coarse.pressure(t) - p));
      }
      EXPECT_LT(usual_error, coarse_error / 16) << ratio << " " << theta0;
      worst = std::max(worst, usual_error / fine.peak());
    }
  }
  EXPECT_LT(worst, 5e-7);  // the documented accuracy
  RecordProperty("max_error", std::to_string(1e9 * worst) + "e-9");
}

// Published values of a ball in a rigid seat at mu = 3, to their digits: 66.6
// deg by a centre force, 71.6 to 73.1 deg from patches of 60 to 20 deg.
TEST(BallContact, LoadThroughTheBack) {
  const ElasticPair pair = ElasticPair::from_modulus_ratio(0, 0.3, 0.3);
  const auto angle_deg = [&pair](InnerLoading loading) {
    return BallContact(pair, loading).half_angle(3).half_angle / degree;
  };
  EXPECT_NEAR(angle_deg(InnerLoading::centre()), 66.6, 0.06);
  EXPECT_NEAR(angle_deg(InnerLoading::back(60 * degree)), 71.6, 0.05);
  EXPECT_NEAR(angle_deg(InnerLoading::back(20 * degree)), 73.1, 0.05);
}

}  // namespace
}  // namespace contact::test::ball_test
