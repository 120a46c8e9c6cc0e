// The rules for pressures with a logarithm against closed forms.

#include "libcontact/friction/kernel/arc_rule.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <cmath>
#include <string>
#include <tuple>

#include "libcontact/tools/reference/friction_rules.hpp"
#include "support/accuracy_report.hpp"

namespace contact::test::arc_rule_test {
namespace {

using boost::math::beta;
using boost::math::digamma;
using detail::CapRule;
using detail::large_logarithm_arc_rules;
using detail::logarithm_arc_rules;

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

std::string label(std::size_t index, int j) {
  return "rule " + std::to_string(index) + ", T^" + std::to_string(j);
}

// The leading logarithm, for moduli from 0 to the last that an arc takes.
TEST(ArcRule, LogarithmAlongAnArc) {
  for (const auto& [rules, name, budget] :
       {std::tuple{logarithm_arc_rules, "logarithm", 6e-11},
        {large_logarithm_arc_rules, "large logarithm", 2e-11}}) {
    AccuracyReport report(name, budget);
    for (std::size_t index = 0; index < rules.size(); ++index) {
      const CapRule& rule = rules[index];
      // cos^2j over [0, pi/2].
      for (int j = 1; j <= 2; ++j) {
        report.add(sum(rule, j, 1, false), beta(j + 0.5, 0.5) / 2,
                   label(index, j));
      }
      report.add(sum(rule, 2, 1, true), log_moment(2.5, 0.5, 2.5),
                 label(index, 2) + " ln T");
    }
  }
}

// Without a modulus all corrected powers are exact.
TEST(ArcRule, CorrectedLogarithmsAreExact) {
  AccuracyReport report("corrected", 1e-14);
  for (int index = 0; index < 3; ++index) {
    // Gauss' rule in x = sn u: (1 - x^2)^j over [0, 1].
    const CapRule& rule = detail::chord_rules[index];
    for (int j = 2; j <= 7; ++j) {
      report.add(sum(rule, j, 0, true), log_moment(0.5, j + 1.0, j + 1.0),
                 label(index, j) + " ln T");
    }
  }
}

using detail::CapRules;
using reference::RuleNodes;

struct Family {
  const char* name;
  CapRules rules;
  RuleNodes (*reference)(int index, int size);
};
const Family families[] = {
    {"cap", detail::cap_rules, reference::midpoint_rule},
    {"short", detail::short_rules, reference::midpoint_rule},
    {"smooth arc", detail::smooth_arc_rules, reference::arc_rule},
    {"logarithm arc", logarithm_arc_rules, reference::arc_rule},
    {"large logarithm arc", large_logarithm_arc_rules, reference::arc_rule},
    {"high order arc", detail::high_order_arc_rules, reference::arc_rule},
    {"high order short", detail::high_order_short_rules,
     reference::midpoint_rule},
    {"high order chord", detail::high_order_chord_rules, reference::chord_rule},
    {"high order whole chord", detail::high_order_whole_chord_rules,
     reference::whole_chord_rule},
    {"chord", detail::chord_rules, reference::chord_rule},
    {"whole chord", detail::whole_chord_rules, reference::whole_chord_rule}};

// Every number of the generated tables against 50 digits.
TEST(FrictionRules, AreTheNearestDoubles) {
  for (const auto& [name, rules, reference] : families) {
    ASSERT_FALSE(rules.empty());
    for (std::size_t index = 0; index < rules.size(); ++index) {
      const CapRule& rule = rules[index];
      const RuleNodes nodes = reference(static_cast<int>(index), rule.size);
      for (int i = 0; i < rule.size; ++i) {
        SCOPED_TRACE(name + std::string(", node ") + std::to_string(i) +
                     " of rule " + std::to_string(index));
        EXPECT_EQ(rule.cosine_squared[i], nodes[i].cosine_squared);
        EXPECT_EQ(rule.sine_squared[i], nodes[i].sine_squared);
        EXPECT_EQ(rule.weight[i], nodes[i].weight);
        EXPECT_EQ(rule.log_cosine_squared[i], nodes[i].log_cosine_squared);
      }
    }
  }
}

// Repeated nodes in the padding of a rule count nothing.
TEST(FrictionRules, PaddingHasNoWeight) {
  for (const Family& family : families) {
    for (const CapRule& rule : family.rules) {
      ASSERT_EQ(rule.padded_size % CapRule::lanes, 0);
      for (int i = rule.size; i < rule.padded_size; ++i) {
        EXPECT_EQ(rule.weight[i], 0);
        EXPECT_GT(rule.cosine_squared[i], 0);
      }
    }
  }
}

}  // namespace
}  // namespace contact::test::arc_rule_test
