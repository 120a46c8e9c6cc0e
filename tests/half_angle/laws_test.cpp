// Properties of every half-angle law, however it is made; names and notes.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/half_angle/fitted.hpp"
#include "libcontact/half_angle/paper_laws.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/elastic_cases.hpp"
#include "support/numbers.hpp"

namespace contact::test::laws_test {
namespace {

// A law, and its rounding error.
struct Tested {
  std::string label;
  std::shared_ptr<const HalfAngleLaw> law;
  int order = 1;          // next order in x after Hertz' for small loads
  double rounding = 0;    // error of theta0 near the limit, rad
  double steepest = 1e7;  // load up to which ln(theta0) has a small third
                          // derivative over ln(load)
};

// Fitted laws round F, a sum of terms up to 30, over its slope, which vanishes
// where the contact closes up.
double rounding_of_fitted(double limit) { return limit < 3 ? 1e-11 : 1e-2; }

std::vector<Tested> tested(JointKind kind) {
  std::vector<Tested> laws;
  for (const PairCase& pair : fitted_pairs) {
    const auto law = std::make_shared<FittedLaw>(kind, pair.elastic());
    EXPECT_TRUE(law->validity_notes(pair.elastic()).empty()) << pair.label();
    const double limit = law->limit_half_angle();
    laws.push_back({"fitted, " + pair.label(), law, 1,
                    rounding_of_fitted(limit), limit < 3 ? 1e7 : 1e4});
  }
  for (const PairCase& pair : exact_pairs) {
    laws.push_back({"exact, " + pair.label(),
                    std::make_shared<ExactLaw>(kind, pair.elastic()), 1, 0,
                    1e10});
  }
  for (const double limit_deg : {80.33, 84.85, 111.8}) {
    const auto limit = LimitHalfAngle::given(limit_deg * degree);
    const auto add = [&](std::shared_ptr<const HalfAngleLaw> law) {
      laws.push_back({law->name() + ", " + std::to_string(limit_deg), law, 2});
      EXPECT_EQ(law->limit_half_angle(), limit_deg * degree);
    };
    add(std::make_shared<TanhLaw>(kind, limit));
    add(std::make_shared<ArctanLaw>(kind, limit));
    for (const double k : {0.0, 1e-12, 0.03, 0.5, 1.0}) {
      add(std::make_shared<BlendLaw>(kind, limit, k));
    }
  }
  return laws;
}

TEST(HalfAngleLaws, Limits) {
  for (const JointKind kind : kinds) {
    const double exponent = kind == JointKind::ball ? 1.0 / 3 : 0.5;
    for (const auto& [label, law, order, rounding, steepest] : tested(kind)) {
      SCOPED_TRACE(to_string(kind) + ", " + label);
      const double limit = law->limit_half_angle();
      EXPECT_EQ(law->half_angle(0).half_angle, 0);
      EXPECT_EQ(law->half_angle(0).log_slope, exponent);
      EXPECT_EQ(law->load_parameter(0).load_parameter, 0);
      // Exactly the limit.
      EXPECT_EQ(law->half_angle(infinity).half_angle, limit);
      EXPECT_EQ(law->half_angle(infinity).log_slope, 0);
      EXPECT_EQ(law->load_parameter(limit).load_parameter, infinity);
      EXPECT_EQ(law->load_parameter(limit).status, Status::ok);
      // Hertz as the load tends to 0: the next term of exact laws is below x
      // (|beta| <= 1/2 and the like).
      for (const double load : {5e-324, 1e-200, 1e-40, 1e-30, 1e-12}) {
        const double x = contact::LoadScale::x_from_load_parameter(kind, load);
        const HalfAngleResult result = law->half_angle(load);
        EXPECT_NEAR(result.half_angle / x, 1, std::pow(x, order) + 8 * epsilon)
            << load;
        EXPECT_NEAR(result.log_slope, exponent, x + 1e-14) << load;
      }
      // From below, and in the end there.
      double last = 0;
      for (double load = 1e-300; load < 1e300; load *= 1e3) {
        const auto [angle, status, log_slope] = law->half_angle(load);
        EXPECT_EQ(status, Status::ok);
        EXPECT_GE(log_slope, 0);
        EXPECT_GE(angle, last - rounding) << load;
        EXPECT_LE(angle, limit) << load;
        last = angle;
      }
      EXPECT_NEAR(law->half_angle(1e300).half_angle, limit,
                  std::max(rounding, 1e-14 * limit));
    }
  }
  // A pin of incompressible material in a rigid hole closes up.
  const PairCase closing{0, 0.5, 0.3};
  EXPECT_EQ(ExactLaw(JointKind::pin, closing.elastic()).limit_half_angle(),
            180 * degree);
}

TEST(HalfAngleLaws, LogSlopeIsTheDerivative) {
  // Central difference over +-1e-4 in ln(load): 1e-8/6 of the third
  // derivative, and rounding 1e-16/1e-4.
  AccuracyReport report("dln(theta0)/dln(load), absolute", 1e-8);
  for (const JointKind kind : kinds) {
    for (const Tested& each : tested(kind)) {
      for (double load = 1e-12; load < each.steepest; load *= 5.3) {
        const double h = 1e-4;
        const auto log_angle = [&](double shift) {
          return std::log(
              each.law->half_angle(load * std::exp(shift)).half_angle);
        };
        report.add_error(std::abs((log_angle(h) - log_angle(-h)) / (2 * h) -
                                  each.law->half_angle(load).log_slope),
                         each.label + ", load " + std::to_string(load));
      }
    }
  }
}

TEST(HalfAngleLaws, NanAndWhatIsOutOfRange) {
  const auto pair = ElasticPair::from_modulus_ratio(1, 0.3, 0.3);
  for (const JointKind kind : kinds) {
    for (const std::string& name : half_angle_law_names()) {
      const auto law = make_half_angle_law(name, kind, pair);
      const bool knows_interference = !std::isnan(law->closing_load());
      EXPECT_EQ(knows_interference, name == "exact");
      for (const double load : {nan, -1.0, -infinity, -1e-300}) {
        if (knows_interference && load < 0) continue;
        EXPECT_TRUE(std::isnan(law->half_angle(load).half_angle)) << name;
        EXPECT_EQ(law->half_angle(load).status, Status::out_of_range) << name;
      }
      EXPECT_TRUE(std::isnan(law->half_angle(nan).log_slope)) << name;
      for (const double angle :
           {nan, -1.0, -infinity, infinity,
            knows_interference ? 3.2
                               : std::nextafter(law->limit_half_angle(), 4)}) {
        EXPECT_TRUE(std::isnan(law->load_parameter(angle).load_parameter));
        EXPECT_EQ(law->load_parameter(angle).status, Status::out_of_range);
      }
    }
  }
}

TEST(HalfAngleLaws, DoNotAllocate) {
  for (const JointKind kind : kinds) {
    for (const double outer_nu : {0.3, 0.4}) {
      const auto pair = ElasticPair::from_modulus_ratio(1, 0.3, outer_nu);
      for (const std::string& name : half_angle_law_names()) {
        const auto law = make_half_angle_law(name, kind, pair);
        const std::size_t before = allocation_count();
        double sum = 0;
        for (double angle = 0.01; angle < 1.45; angle += 0.01) {
          sum += law->half_angle(law->load_parameter(angle).load_parameter)
                     .half_angle;
        }
        EXPECT_EQ(allocation_count(), before) << name;
        EXPECT_GT(sum, 0);
      }
    }
  }
}

TEST(MakeHalfAngleLaw, KnowsEveryName) {
  const auto pair = ElasticPair::from_modulus_ratio(1, 0.3, 0.3);
  const auto name = [&](const char* asked, JointKind kind) {
    return make_half_angle_law(asked, kind, pair)->name();
  };
  EXPECT_EQ(name("hertz", JointKind::ball), "hertz");
  EXPECT_EQ(name("arctan", JointKind::ball), "arctan");
  EXPECT_EQ(name("tanh", JointKind::pin), "tanh");
  EXPECT_EQ(name("blend", JointKind::pin), "blend:0.5");
  EXPECT_EQ(name("blend", JointKind::ball), "blend:0");
  EXPECT_EQ(name("blend:0.25", JointKind::ball), "blend:0.25");
  EXPECT_EQ(name("blend:1", JointKind::ball), "blend:1");
  EXPECT_EQ(name("paper", JointKind::pin), "blend:0.5");
  EXPECT_EQ(name("paper", JointKind::ball), "tanh");
  for (const char* law : {"fitted", "exact"}) {
    EXPECT_EQ(name(law, JointKind::ball), law);
    EXPECT_EQ(name(law, JointKind::pin), law);
    EXPECT_FALSE(takes_half_angle_options(law));
  }
  for (const char* law : {"arctan", "tanh", "blend", "blend:0.2", "paper"}) {
    EXPECT_TRUE(takes_half_angle_options(law));
  }
  EXPECT_FALSE(takes_half_angle_options("hertz"));
  EXPECT_EQ(make_half_angle_law("tanh", JointKind::ball, pair)->joint_kind(),
            JointKind::ball);
}

TEST(MakeHalfAngleLaw, LimitByFormulaLineOrValue) {
  const auto pair = ElasticPair::from_modulus_ratio(2, 0.3, 0.3);
  const auto limit_deg = [&](const HalfAngleOptions& options) {
    return make_half_angle_law("arctan", JointKind::pin, pair, options)
               ->limit_half_angle() /
           degree;
  };
  EXPECT_NEAR(limit_deg({}), 84.85 - 2.88 * std::atan(0.711), 1e-13);
  EXPECT_NEAR(limit_deg({.linear_limit = true}), 82.85, 1e-13);
  EXPECT_NEAR(limit_deg({.limit_half_angle = 1.2}), 1.2 / degree, 1e-13);
}

TEST(ValidityNotes, SayWhatIsOutsideTheRange) {
  using Notes = std::vector<std::string>;
  const auto notes = [](const char* name, JointKind kind, double ratio,
                        double nu1, double nu2,
                        const HalfAngleOptions& options = {}) {
    const auto pair = ElasticPair::from_modulus_ratio(ratio, nu1, nu2);
    return make_half_angle_law(name, kind, pair, options)->validity_notes(pair);
  };
  const JointKind pin = JointKind::pin;
  const JointKind ball = JointKind::ball;
  const std::string of_a_pin =
      "the limit half-angle is for pins; a ball's is up to 5 % larger";

  EXPECT_EQ(notes("paper", pin, 1, 0.3, 0.29), Notes{});
  EXPECT_EQ(notes("tanh", pin, 1, 0.33, 0.45),
            (Notes{"the limit half-angle is a formula for Poisson's ratio "
                   "0.3; the inner body has 0.33",
                   "the limit half-angle is a formula for Poisson's ratio "
                   "0.3; the outer body has 0.45"}));
  // A rigid body's Poisson's ratio does not matter.
  EXPECT_EQ(notes("tanh", pin, 0, 0.3, 0.45), Notes{});
  EXPECT_EQ(notes("tanh", pin, infinity, 0.45, 0.3), Notes{});
  EXPECT_EQ(notes("paper", ball, 1, 0.3, 0.3), Notes{of_a_pin});
  EXPECT_EQ(notes("blend:0.5", ball, 1, 0.3, 0.3),
            (Notes{of_a_pin,
                   "a blend is recommended for pins only; tanh for balls"}));
  const std::string ratio_note =
      "a blend is recommended for modulus ratios between 0.5 and 2; this pair "
      "has ";
  EXPECT_EQ(notes("paper", pin, 0.5, 0.3, 0.3), Notes{ratio_note + "0.5"});
  EXPECT_EQ(notes("paper", pin, 2, 0.3, 0.3), Notes{ratio_note + "2"});
  EXPECT_EQ(notes("paper", pin, infinity, 0.3, 0.3), Notes{ratio_note + "inf"});
  EXPECT_EQ(notes("paper", pin, std::nextafter(2.0, 0), 0.3, 0.3), Notes{});
  // A limit half-angle given by the user is used unchanged.
  EXPECT_EQ(notes("tanh", ball, 1, 0.2, 0.45, {.limit_half_angle = 1.4}),
            Notes{});
}

}  // namespace
}  // namespace contact::test::laws_test
