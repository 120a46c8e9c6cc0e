// The rules for pressures with a logarithm against closed forms.

#include "libcontact/friction/kernel/arc_rule.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <cmath>
#include <string>
#include <tuple>

#include "support/accuracy_report.hpp"

namespace {

using boost::math::beta;
using boost::math::digamma;
using contact::detail::ArcTerms;
using contact::detail::CapRule;
using contact::test::AccuracyReport;

// sum of weight T^(j - held) ln T; `held` powers are in the weights.
double sum(const CapRule& rule, int j, int held, bool with_logarithm) {
  double result = 0;
  for (int i = 0; i < rule.size; ++i) {
    const double t = rule.cosine_squared[i];
    result += rule.weight[i] * std::pow(t, j - held) *
              (with_logarithm ? rule.log_cosine_squared[i] : 1);
  }
  return result;
}

// ∫ T^j ln T, from ∫ T^j = B(x, y)/2 by the derivative with respect to j.
double log_moment(double x, double y, double differentiated) {
  return beta(x, y) / 2 * (digamma(differentiated) - digamma(x + y));
}

std::string label(int index, int j) {
  return "rule " + std::to_string(index) + ", T^" + std::to_string(j);
}

// The leading logarithm, for moduli from 0 to the last that an arc takes.
TEST(ArcRule, LogarithmAlongAnArc) {
  for (const auto& [terms, name, budget] :
       {std::tuple{ArcTerms::logarithm, "logarithm", 6e-11},
        {ArcTerms::large_logarithm, "large logarithm", 2e-11}}) {
    AccuracyReport report(name, budget);
    for (int index = 0; index < 14; ++index) {
      const CapRule& rule = arc_rules(terms)[index];
      // cos^2j over [0, pi/2].
      for (int j = 1; j <= 2; ++j) {
        report.add(sum(rule, j, 1, false), beta(j + 0.5, 0.5) / 2,
                   label(index, j));
      }
      report.add(sum(rule, 2, 1, true), log_moment(2.5, 0.5, 2.5),
                 label(index, 2) + " ln T");
    }
    report.check();
  }
}

// Without a modulus all corrected powers are exact.
TEST(ArcRule, CorrectedLogarithmsAreExact) {
  AccuracyReport report("corrected", 1e-14);
  for (int index = 0; index < 3; ++index) {
    // Gauss' rule in x = sn u: (1 - x^2)^j over [0, 1].
    const CapRule& rule = contact::detail::chord_rules(ArcTerms::smooth)[index];
    for (int j = 2; j <= 7; ++j) {
      report.add(sum(rule, j, 0, true), log_moment(0.5, j + 1.0, j + 1.0),
                 label(index, j) + " ln T");
    }
  }
  report.check();
}

// What the padding of a rule repeats counts nothing.
TEST(ArcRule, PaddingHasNoWeight) {
  for (int index = 0; index < contact::detail::cap_rule_count; ++index) {
    for (const CapRule* rule :
         {&contact::detail::short_rules(ArcTerms::smooth)[index],
          &contact::detail::chord_rules(ArcTerms::smooth)[index],
          &contact::detail::whole_chord_rules(ArcTerms::smooth)[index],
          &arc_rules(ArcTerms::smooth)[index]}) {
      ASSERT_EQ(rule->padded_size % CapRule::lanes, 0);
      for (int i = rule->size; i < rule->padded_size; ++i) {
        EXPECT_EQ(rule->weight[i], 0);
        EXPECT_GT(rule->cosine_squared[i], 0);
      }
    }
  }
}

}  // namespace
