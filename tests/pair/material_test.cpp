#include "libcontact/pair/material.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/accuracy_report.hpp"

namespace {

using contact::ElasticPair;
using contact::Material;
using contact::test::AccuracyReport;
using Real = boost::multiprecision::cpp_bin_float_50;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<ElasticPair> pairs() {
  const std::vector<double> moduli = {1e3, 0.8e9, 1.1e11, 2.1e11, 1e13};
  const std::vector<double> ratios = {0, 0.2, 0.3, 0.46, 0.5};
  std::vector<ElasticPair> result;
  for (const double e1 : moduli) {
    for (const double e2 : moduli) {
      for (const double nu1 : ratios) {
        for (const double nu2 : ratios) {
          result.push_back(ElasticPair({e1, nu1}, {e2, nu2}));
        }
      }
    }
  }
  return result;
}

std::string label(const ElasticPair& pair) {
  std::ostringstream text;
  text << pair.inner().youngs_modulus << "," << pair.inner().poissons_ratio
       << "," << pair.outer().youngs_modulus << ","
       << pair.outer().poissons_ratio;
  return text.str();
}

TEST(ElasticPair, AgreesWithFiftyDigits) {
  // 5 to 7 roundings of at most 1.1e-16, measured 2.9e-16.
  AccuracyReport modulus("effective_modulus", 5e-16);
  AccuracyReport contact_modulus("contact_modulus", 5e-16);
  AccuracyReport ratio("modulus_ratio", 5e-16);
  AccuracyReport w1("inner_compliance_share", 5e-16);
  AccuracyReport w2("outer_compliance_share", 5e-16);
  // Differences of numbers up to 1: absolute errors.
  AccuracyReport alpha("dundurs_alpha, absolute", 4e-16);
  AccuracyReport beta("dundurs_beta, absolute", 4e-16);
  for (const ElasticPair& pair : pairs()) {
    const Real e1 = pair.inner().youngs_modulus;
    const Real e2 = pair.outer().youngs_modulus;
    const Real nu1 = pair.inner().poissons_ratio;
    const Real nu2 = pair.outer().poissons_ratio;
    const Real c1 = (1 - nu1 * nu1) / e1;
    const Real c2 = (1 - nu2 * nu2) / e2;
    // Dundurs' own definition, by the shear moduli and Kolosov's constants.
    const Real g1 = e1 / (2 * (1 + nu1));
    const Real g2 = e2 / (2 * (1 + nu2));
    const Real k1 = 3 - 4 * nu1;
    const Real k2 = 3 - 4 * nu2;
    const Real below = g1 * (k2 + 1) + g2 * (k1 + 1);
    const Real exact_alpha = (g1 * (k2 + 1) - g2 * (k1 + 1)) / below;
    const Real exact_beta = (g1 * (k2 - 1) - g2 * (k1 - 1)) / below;
    const std::string row = label(pair);
    modulus.add(Real(pair.effective_modulus()), Real(2 / (c1 + c2)), row);
    contact_modulus.add(Real(pair.contact_modulus()), Real(1 / (c1 + c2)), row);
    ratio.add(Real(pair.modulus_ratio()), Real(e1 / e2), row);
    w1.add(Real(pair.inner_compliance_share()), Real(c1 / (c1 + c2)), row);
    w2.add(Real(pair.outer_compliance_share()), Real(c2 / (c1 + c2)), row);
    alpha.add_error(double(abs(pair.dundurs_alpha() - exact_alpha)), row);
    beta.add_error(double(abs(pair.dundurs_beta() - exact_beta)), row);
  }
  modulus.check();
  contact_modulus.check();
  ratio.check();
  w1.check();
  w2.check();
  alpha.check();
  beta.check();
}

TEST(ElasticPair, ReducedModulusIsTwiceTheContactModulus) {
  // Equal bodies: E = E1/(1 - nu^2) in the paper's convention, E* half of it.
  const ElasticPair pair({2e11, 0.3}, {2e11, 0.3});
  EXPECT_DOUBLE_EQ(pair.effective_modulus(), 2e11 / 0.91);
  EXPECT_DOUBLE_EQ(pair.contact_modulus(), 1e11 / 0.91);
  EXPECT_TRUE(pair.identical());
  EXPECT_EQ(pair.dundurs_alpha(), 0);
  EXPECT_EQ(pair.dundurs_beta(), 0);
}

TEST(ElasticPair, ExchangingTheBodiesMirrorsTheMismatch) {
  for (const ElasticPair& pair : pairs()) {
    const ElasticPair swapped(pair.outer(), pair.inner());
    EXPECT_EQ(swapped.effective_modulus(), pair.effective_modulus());
    EXPECT_EQ(swapped.inner_compliance_share(), pair.outer_compliance_share());
    EXPECT_EQ(swapped.dundurs_alpha(), -pair.dundurs_alpha());
    EXPECT_EQ(swapped.dundurs_beta(), -pair.dundurs_beta());
  }
}

TEST(ElasticPair, RigidBodies) {
  const Material soft{2e9, 0.4, "polymer"};
  for (const double nu : {0.0, 0.3, 0.5}) {
    const ElasticPair seat(soft, {infinity, nu, "rigid"});
    EXPECT_EQ(seat.modulus_ratio(), 0);
    EXPECT_EQ(seat.dundurs_alpha(), -1);
    EXPECT_EQ(seat.outer_compliance_share(), 0);
    EXPECT_DOUBLE_EQ(seat.contact_modulus(), 2e9 / 0.84);
    // The rigid body's Poisson's ratio has no influence.
    EXPECT_DOUBLE_EQ(seat.dundurs_beta(), -0.2 / 1.2);
    const ElasticPair ball({infinity, nu, "rigid"}, soft);
    EXPECT_EQ(ball.modulus_ratio(), infinity);
    EXPECT_EQ(ball.dundurs_alpha(), 1);
    EXPECT_DOUBLE_EQ(ball.dundurs_beta(), 0.2 / 1.2);
  }
}

TEST(ElasticPair, DimensionlessPairHasReducedModulusOne) {
  for (const double ratio :
       {0.0, 1e-310, 1e-6, 0.5, 1.0, 2.0, 1e6, 1e300, infinity}) {
    for (const double nu1 : {0.0, 0.3, 0.5}) {
      for (const double nu2 : {0.2, 0.45}) {
        const auto pair = ElasticPair::from_modulus_ratio(ratio, nu1, nu2);
        EXPECT_EQ(pair.modulus_ratio(), ratio);
        EXPECT_EQ(pair.inner().poissons_ratio, nu1);
        EXPECT_EQ(pair.outer().poissons_ratio, nu2);
        EXPECT_NEAR(pair.effective_modulus(), 1, 1e-15);  // 5 roundings
        const double share =
            pair.inner_compliance_share() + pair.outer_compliance_share();
        EXPECT_NEAR(share, 1, 2.3e-16);  // one rounding of each share
      }
    }
  }
  const auto pair = ElasticPair::from_modulus_ratio(0.5, 0.3, 0.3);
  const ElasticPair same({1e11, 0.3}, {2e11, 0.3});
  EXPECT_NEAR(pair.dundurs_alpha(), same.dundurs_alpha(), 1e-15);
  EXPECT_NEAR(pair.dundurs_beta(), same.dundurs_beta(), 1e-15);
}

}  // namespace
