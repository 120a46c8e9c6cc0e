#include "libcontact/half_angle/paper_laws.hpp"
#include "libcontact/half_angle/factory.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "libcontact/base/units.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::paper_laws_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

const Real real_pi = boost::math::constants::pi<Real>();

// --- The laws as the paper writes them, in 50 digits -----------------------

Real x_of(JointKind kind, const Real& load) {
  return kind == JointKind::ball ? Real(cbrt(load)) : Real(2 * sqrt(load));
}

Real load_of(JointKind kind, const Real& x) {
  return kind == JointKind::ball ? Real(x * x * x) : Real(x * x / 4);
}

// theta0/theta0* of k (2.3) + (1 - k) (2.4) at xi = x/theta0*.
Real ratio_of(double k, const Real& xi) {
  return k * (2 / real_pi) * atan(real_pi / 2 * xi) + (1 - k) * tanh(xi);
}

// Its derivative.
Real slope_of(double k, const Real& xi) {
  const Real cosh_xi = cosh(xi);
  return k / (1 + real_pi * real_pi / 4 * xi * xi) +
         (1 - k) / (cosh_xi * cosh_xi);
}

// Inverse of ratio_of() at theta0/theta0* = ratio by Newton's method in ln xi,
// on the ratio where it is small and on its complement where that is.
Real xi_of(double k, const Real& ratio, double start) {
  Real v = log(Real(start));
  for (int i = 0; i < 60; ++i) {
    const Real xi = exp(v);
    const Real rest = k * (2 / real_pi) * atan(2 / (real_pi * xi)) +
                      (1 - k) * 2 / (exp(2 * xi) + 1);
    const Real residual =
        ratio < 0.5 ? Real(ratio - ratio_of(k, xi)) : Real(rest - (1 - ratio));
    const Real step = residual / (slope_of(k, xi) * xi);
    v += step;
    // Quadratic: the next step would be below 1e-32.
    if (abs(step) < 1e-16) return exp(v);
  }
  return nan;
}

struct NamedShare {
  double arctan_share;
  std::unique_ptr<HalfAngleLaw> law;
};

// tanh, arctan and blends of one joint, with the inverse's error budget.
std::vector<NamedShare> saturating_laws(JointKind kind, LimitHalfAngle limit) {
  std::vector<NamedShare> laws;
  laws.push_back({0, std::make_unique<TanhLaw>(kind, limit)});
  laws.push_back({1, std::make_unique<ArctanLaw>(kind, limit)});
  for (const double k : {0.0, 1e-12, 0.03, 0.5, 1.0}) {
    laws.push_back({k, std::make_unique<BlendLaw>(kind, limit, k)});
  }
  return laws;
}

std::vector<double> limits() {
  return {80.33 * degree, 84.85 * degree, 111.8 * degree};
}

std::vector<double> loads() {
  std::vector<double> values;
  for (double load = 1e-30; load < 1e30; load *= 2.37) values.push_back(load);
  return values;
}

// Angles from tiny to the double next below the limit, and the neighbours of
// the point where the inverses change their form.
std::vector<double> angles(double limit) {
  std::vector<double> values;
  for (double share = 1e-100; share < 0.01; share *= 47) {
    values.push_back(share * limit);
  }
  for (int i = 1; i < 60; ++i) values.push_back(i / 60.0 * limit);
  for (int bits = 8; bits <= 52; bits += 2) {
    values.push_back(limit * (1 - std::ldexp(1, -bits)));
  }
  values.push_back(std::nextafter(limit, 0));
  values.push_back(std::nextafter(limit / 2, 0));
  values.push_back(std::nextafter(limit / 2, 2));
  return values;
}

// Calls visit(k, law) for all of these of both joints.
template <class Visit>
void for_all(const Visit& visit) {
  for (const JointKind kind : kinds) {
    for (const double limit : limits()) {
      for (const auto& [k, law] :
           saturating_laws(kind, LimitHalfAngle::given(limit))) {
        visit(k, *law);
      }
    }
  }
}

std::string label(const HalfAngleLaw& law, double argument) {
  std::ostringstream text;
  text.precision(17);
  text << law.name() << " " << to_string(law.joint_kind()) << " limit "
       << law.limit_half_angle() << " at " << argument;
  return text.str();
}

TEST(SaturatingLaws, ForwardAgreesWithFiftyDigits) {
  // Root, quotient, tanh or atan (2 ulp in glibc), two products: 5 roundings.
  AccuracyReport report("theta0(load)", 1e-15);
  // dln(theta0)/dln(load) = power xi g'/g: a slope and a ratio with some
  // roundings each; absolute, since tanh's slope is 1 - g^2 with g near 1.
  AccuracyReport slopes("dln(theta0)/dln(load), absolute", 1e-15);
  for_all([&](double k, const HalfAngleLaw& law) {
    const JointKind kind = law.joint_kind();
    const double power = kind == JointKind::ball ? 1.0 / 3 : 0.5;
    for (const double load : loads()) {
      const auto result = law.half_angle(load);
      EXPECT_EQ(result.status, Status::ok);
      const Real xi = x_of(kind, load) / law.limit_half_angle();
      report.add(Real(result.half_angle),
                 Real(law.limit_half_angle() * ratio_of(k, xi)),
                 label(law, load));
      const Real expected = power * xi * slope_of(k, xi) / ratio_of(k, xi);
      slopes.add_error(double(abs(result.log_slope - expected)),
                       label(law, load));
    }
  });
}

TEST(SaturatingLaws, InverseAgreesWithFiftyDigits) {
  // tanh, arctan: log1p or tan of an argument with 1.5 roundings, a product,
  // the power 3 multiplies by 3: measured 1.2e-15. Blend: the root of a
  // residual with the same roundings, measured 1.7e-15.
  AccuracyReport closed("load(theta0), tanh and arctan", 2e-15);
  AccuracyReport blend("load(theta0), blend", 3e-15);
  for_all([&](double k, const HalfAngleLaw& law) {
    AccuracyReport& report = law.name().starts_with("blend") ? blend : closed;
    const JointKind kind = law.joint_kind();
    const double limit = law.limit_half_angle();
    for (const double angle : angles(limit)) {
      const auto result = law.load_parameter(angle);
      EXPECT_EQ(result.status, Status::ok);
      // Loads below the smallest normal number have fewer digits.
      if (load_of(kind, angle) < 1e-300) continue;
      const double start = contact::LoadScale::x_from_load_parameter(
                               kind, result.load_parameter) /
                           limit;
      const Real xi = xi_of(k, Real(angle) / limit, start);
      report.add(Real(result.load_parameter), load_of(kind, xi * limit),
                 label(law, angle));
    }
  });
}

TEST(SaturatingLaws, RoundTrips) {
  // Angle to load to angle is well conditioned: the errors of both laws.
  AccuracyReport angle_report("theta0 -> load -> theta0", 2e-15);
  // Load to angle to load multiplies the rounding of theta0 by
  // dln(load)/dln(theta0), which grows without bound near the limit.
  AccuracyReport load_report("load -> theta0 -> load, over condition", 2e-15);
  for (const JointKind kind : kinds) {
    const double power = kind == JointKind::ball ? 3 : 2;
    const double limit = 84.85 * degree;
    for (const auto& [k, law] :
         saturating_laws(kind, LimitHalfAngle::given(limit))) {
      for (const double angle : angles(limit)) {
        const double load = law->load_parameter(angle).load_parameter;
        if (load < 1e-300) continue;
        angle_report.add(law->half_angle(load).half_angle, angle,
                         label(*law, angle));
      }
      for (const double load : loads()) {
        const double angle = law->half_angle(load).half_angle;
        const double back = law->load_parameter(angle).load_parameter;
        if (angle == limit) {
          EXPECT_EQ(back, infinity);
          continue;
        }
        const Real xi = x_of(kind, load) / limit;
        const double condition =
            1 + double(power * ratio_of(k, xi) / (xi * slope_of(k, xi)));
        if (condition * epsilon > 0.1) continue;
        load_report.add_error(std::abs(back / load - 1) / condition,
                              label(*law, load));
      }
    }
  }
}

TEST(SaturatingLaws, InverseHasNoJumpWhereItsFormChanges) {
  for_all([](double, const HalfAngleLaw& law) {
    const auto load = [&](double angle) {
      return law.load_parameter(angle).load_parameter;
    };
    const double middle = law.limit_half_angle() / 2;
    // Both sides are within the inverse's budget of the same curve, which
    // moves by 4 epsilon (condition 4 for the cube) between neighbours.
    EXPECT_NEAR(load(std::nextafter(middle, 0)) / load(middle), 1, 1.2e-14)
        << law.name();
    EXPECT_NEAR(load(std::nextafter(middle, 2)) / load(middle), 1, 1.2e-14)
        << law.name();
  });
}

TEST(SaturatingLaws, GrowWithLoadAndTanhLeads) {
  // The bracket of the blend's inverse rests on arctan <= blend <= tanh.
  for (const JointKind kind : kinds) {
    const auto limit = LimitHalfAngle::given(84.85 * degree);
    const ArctanLaw arctan(kind, limit);
    const TanhLaw tanh_law(kind, limit);
    const BlendLaw blend(kind, limit, 0.5);
    double last = 0;
    for (const double load : loads()) {
      const double low = arctan.half_angle(load).half_angle;
      const double middle = blend.half_angle(load).half_angle;
      const double high = tanh_law.half_angle(load).half_angle;
      EXPECT_LE(low, middle * (1 + 4 * epsilon));
      EXPECT_LE(middle, high * (1 + 4 * epsilon));
      EXPECT_GE(middle, last);
      EXPECT_LE(high, limit.value());
      last = middle;
    }
  }
}

TEST(SaturatingLaws, InitialSlopeScalesTheLoad) {
  // m x in place of x: m^3 mu or m^2 lambda gives the same angle.
  const auto limit = LimitHalfAngle::given(1.5);
  const double m = 1.25;
  for (const JointKind kind : kinds) {
    const double scale = kind == JointKind::ball ? m * m * m : m * m;
    for (const double load : {1e-6, 0.3, 40.0}) {
      const BlendLaw one(kind, limit, 0.5);
      const BlendLaw steeper(kind, limit, 0.5, m);
      const double angle = steeper.half_angle(load).half_angle;
      EXPECT_NEAR(one.half_angle(load * scale).half_angle / angle, 1,
                  4 * epsilon);
      EXPECT_NEAR(steeper.load_parameter(angle).load_parameter / load, 1,
                  1e-13);
    }
  }
}

// --- Hertz ------------------------------------------------------------------

TEST(HertzLaw, BothWaysAgreeWithFiftyDigits) {
  // Root, 1 - x^2 from exact differences, root, atan2: 4 roundings, less one
  // half from the root.
  AccuracyReport forward("hertz theta0(load)", 1e-15);
  // A sine and its power.
  AccuracyReport back("hertz load(theta0)", 1e-15);
  for (const JointKind kind : kinds) {
    const HertzLaw law(kind);
    const double largest = kind == JointKind::ball ? 1 : 0.25;
    std::vector<double> values = {largest, std::nextafter(largest, 0)};
    for (double load = 1e-200; load < largest; load *= 1.7) {
      values.push_back(load);
      if (load > 1e-15) values.push_back(largest - load);
    }
    for (const double load : values) {
      forward.add(Real(law.half_angle(load).half_angle),
                  Real(asin(x_of(kind, load))), label(law, load));
    }
    for (const double angle : angles(90 * degree)) {
      if (load_of(kind, angle) < 1e-300) continue;
      back.add(Real(law.load_parameter(angle).load_parameter),
               load_of(kind, sin(Real(angle))), label(law, angle));
    }
  }
}

TEST(HertzLaw, LogSlopeAgreesWithFiftyDigits) {
  AccuracyReport report("hertz dln(theta0)/dln(load)", 2e-15);
  for (const JointKind kind : kinds) {
    const HertzLaw law(kind);
    const Real power = kind == JointKind::ball ? Real(1) / 3 : Real(0.5);
    const double largest = kind == JointKind::ball ? 1 : 0.25;
    for (double load = 1e-200; load < largest; load *= 1.7) {
      const Real x = x_of(kind, load);
      const Real expected = power * x / (sqrt((1 - x) * (1 + x)) * asin(x));
      report.add(Real(law.half_angle(load).log_slope), expected,
                 label(law, load));
    }
    EXPECT_EQ(law.half_angle(largest).log_slope, infinity);
  }
}

TEST(HertzLaw, EndsAtXOne) {
  for (const JointKind kind : kinds) {
    const HertzLaw law(kind);
    const double largest = kind == JointKind::ball ? 1 : 0.25;
    EXPECT_EQ(law.half_angle(largest).half_angle, 90 * degree);
    EXPECT_EQ(law.load_parameter(90 * degree).load_parameter, largest);
    EXPECT_EQ(law.limit_half_angle(), 90 * degree);
    for (const double load : {std::nextafter(largest, 2), 7.0, infinity}) {
      EXPECT_TRUE(std::isnan(law.half_angle(load).half_angle));
      EXPECT_EQ(law.half_angle(load).status, Status::out_of_range);
    }
    EXPECT_TRUE(law.validity_notes(ElasticPair::from_modulus_ratio(9, 0.1, 0.4))
                    .empty());
  }
}

// --- The limit half-angle ---------------------------------------------------

TEST(LimitHalfAngle, FormulasAgreeWithFiftyDigits) {
  AccuracyReport arctan("arctan_formula", 4e-16);  // three roundings
  AccuracyReport linear("linear_formula", 4e-16);
  for (double ratio = 1e-12; ratio < 1e12; ratio *= 1.9) {
    const Real y = ratio <= 1 ? Real(1 / Real(ratio)) : Real(ratio);
    const Real exact = ratio <= 1 ? Real(84.85 + 4.89 * atan(0.436 * (y - 1)))
                                  : Real(84.85 - 2.88 * atan(0.711 * (y - 1)));
    arctan.add(Real(LimitHalfAngle::arctan_formula(ratio).value()),
               Real(exact * real_pi / 180), std::to_string(ratio));
    if (y > 2) continue;
    const Real line =
        ratio <= 1 ? Real(84.85 + 2 * (y - 1)) : Real(84.85 - 2 * (y - 1));
    linear.add(Real(LimitHalfAngle::linear_formula(ratio).value()),
               Real(line * real_pi / 180), std::to_string(ratio));
  }
}

TEST(LimitHalfAngle, EndsAndMiddle) {
  const auto value_deg = [](double ratio) {
    return LimitHalfAngle::arctan_formula(ratio).value() / degree;
  };
  EXPECT_NEAR(value_deg(1), 84.85, 1e-13);
  // 84.85 + 4.89 pi/2 and 84.85 - 2.88 pi/2.
  EXPECT_NEAR(value_deg(0), 92.531194, 1e-6);
  EXPECT_NEAR(value_deg(infinity), 80.326107, 1e-6);
  // Both branches start from the same value at Ebar = 1, both decrease.
  EXPECT_NEAR(value_deg(std::nextafter(1.0, 0)), 84.85, 1e-13);
  EXPECT_NEAR(value_deg(std::nextafter(1.0, 2)), 84.85, 1e-13);
  double last = value_deg(0);
  for (double ratio = 1e-6; ratio < 1e6; ratio *= 1.3) {
    EXPECT_LT(value_deg(ratio), last);
    last = value_deg(ratio);
  }
}

TEST(LimitHalfAngle, LinearFormulaIsWithinThreePerMille) {
  // The paper's own statement for y <= 2.
  for (double ratio = 0.5; ratio <= 2; ratio += 0.01) {
    EXPECT_NEAR(LimitHalfAngle::linear_formula(ratio).value() /
                    LimitHalfAngle::arctan_formula(ratio).value(),
                1, 0.003);
  }
}

TEST(LimitHalfAngle, FormulaAgainstExactSolutions) {
  // Budgets: the largest differences found, rounded up.
  AccuracyReport pin("limit formula against exact pins, nu = 0.3", 0.007);
  AccuracyReport ball("limit formula against exact balls, nu = 0.3", 0.044);
  const auto compare = [](const char* file, AccuracyReport& report) {
    const ReferenceTable table(file);
    for (const ReferenceTable::Row row : table) {
      const double ratio = row.value("Ebar");
      const double formula_deg =
          LimitHalfAngle::arctan_formula(ratio).value() / degree;
      // The file's own evaluation of the formula, printed to 1e-4 deg.
      EXPECT_NEAR(formula_deg, row.value("paper_fit_nu0.3_deg"), 6e-5);
      if (row.value("nu1") != 0.3 || row.value("nu2") != 0.3) {
        continue;
      }
      report.add(formula_deg, row.value("theta_lim_exact_deg"), row.label());
    }
  };
  compare("conforming/cylinder_limit_angle.csv", pin);
  compare("conforming/sphere_limit_angle.csv", ball);
}

// --- Accuracy of the laws ---------------------------------------------------

// Largest relative error of a law against the exact half-angles at nu = 0.3.
double largest_error(const char* file, const char* load_column,
                     const char* law_name, JointKind kind, double ratio,
                     double largest_load = infinity) {
  const ReferenceTable table(file);
  const auto pair = ElasticPair::from_modulus_ratio(ratio, 0.3, 0.3);
  const auto law = make_half_angle_law(law_name, kind, pair);
  double largest = 0;
  std::size_t rows = 0;
  for (const ReferenceTable::Row row : table) {
    const double load = row.value(load_column);
    if (row.value("Ebar") != ratio || load > largest_load) continue;
    const double exact = row.value("theta0_deg") * degree;
    const double error = law->half_angle(load).half_angle / exact - 1;
    largest = std::max(largest, std::abs(error));
    ++rows;
  }
  EXPECT_GT(rows, 10u);
  return largest;
}

// The paper's laws in percent, on the loads of the reference tables;
// docs/explanation/half_angle.md has more loads and laws
// (apps/hinge_angle_test.cpp).
struct LargestErrors {
  double modulus_ratio;
  double arctan;
  double tanh;
  double blend;
};

void check_errors(const char* file, const char* load_column, JointKind kind,
                  const std::vector<LargestErrors>& table) {
  for (const LargestErrors& row : table) {
    const auto error = [&](const char* law) {
      return 100 *
             largest_error(file, load_column, law, kind, row.modulus_ratio);
    };
    // Half of the last printed digit.
    EXPECT_NEAR(error("arctan"), row.arctan, 0.05) << row.modulus_ratio;
    EXPECT_NEAR(error("tanh"), row.tanh, 0.05) << row.modulus_ratio;
    EXPECT_NEAR(error("blend:0.5"), row.blend, 0.05) << row.modulus_ratio;
  }
}

TEST(PaperLaws, LargestErrorsAgainstExactPins) {
  check_errors("conforming/cylinder_theta0.csv", "lambda", JointKind::pin,
               {{0.01, 6.9, 15.0, 5.7},
                {0.1, 6.9, 14.5, 5.0},
                {0.5, 8.4, 11.9, 2.4},
                {1, 9.0, 10.8, 1.8},
                {2, 9.7, 9.8, 2.0},
                {10, 10.8, 8.4, 2.7},
                {100, 10.9, 8.3, 3.2}});
}

TEST(PaperLaws, LargestErrorsAgainstExactBalls) {
  check_errors("conforming/sphere_theta0.csv", "mu", JointKind::ball,
               {{0, 17.5, 1.1, 8.8},
                {0.1, 17.7, 0.9, 8.9},
                {0.5, 18.7, 3.1, 10.0},
                {1, 18.9, 3.6, 10.1},
                {2, 18.9, 4.0, 10.2},
                {10, 18.8, 4.2, 10.1},
                {100, 18.6, 3.9, 9.8}});
  // Moderate loads only.
  EXPECT_NEAR(100 * largest_error("conforming/sphere_theta0.csv", "mu", "tanh",
                                  JointKind::ball, 1, 10),
              1.4, 0.05);
}

TEST(PaperLaws, HertzIsFivePercentTooLargeAtLambdaThreeHundredths) {
  // The docstring's statement, from the exact pin with Ebar = 1: between the
  // rows on both sides of lambda = 0.03, theta0 = 19 deg.
  const ReferenceTable table("conforming/cylinder_theta0.csv");
  const HertzLaw law(JointKind::pin);
  double below = 0;
  double above = 0;
  for (const ReferenceTable::Row row : table) {
    if (row.value("Ebar") != 1) continue;
    const double lambda = row.value("lambda");
    const double exact = row.value("theta0_deg") * degree;
    const double error = law.half_angle(lambda).half_angle / exact - 1;
    if (lambda <= 0.03) below = error;
    if (lambda > 0.03 && above == 0) above = error;
  }
  EXPECT_GT(below, 0.04);
  EXPECT_LT(below, 0.05);
  EXPECT_GT(above, 0.05);
  EXPECT_LT(above, 0.06);
}

// The paper's examples, both with theta0* = 84.85 deg and its 57.3 degrees
// per radian. First number: recomputed (last digit 1e-3 or 1e-2 deg); second:
// as the paper prints it, from tables of four digits.
TEST(PaperLaws, ExamplesOneAndTwo) {
  const ElasticPair steel({2e11, 0.3}, {2e11, 0.3});
  const auto joint = JointGeometry::ball(0.05, 5e-5);
  const LoadScale scale(joint, steel);
  const auto law = make_half_angle_law(
      "tanh", joint.kind(), steel,
      {.limit_half_angle = 84.85 * degree, .initial_slope = 57.3 * degree});
  const auto angle_deg = [&](double force) {
    const double load = scale.load_parameter(joint.load_from_force(force));
    return law->half_angle(load).half_angle / degree;
  };
  for (const auto& [force, expected_deg, digit] :
       {std::tuple{2e5, 42.593, 5e-4},
        {2e5, 42.6, 0.05},
        {2.63e5, 45.85, 5e-3},
        {2.63e5, 46.0, 0.2},
        {2.096e5, 43.14, 5e-3},
        {2.019e5, 42.70, 5e-3},
        {1.1676e6, 64.40, 5e-3},
        {1.1676e6, 64.4, 0.05},
        {3.077e5, 47.77, 5e-3},
        {2.5214e5, 45.34, 5e-3},
        {2.53e5, 45.4, 0.05}}) {
    EXPECT_NEAR(angle_deg(force), expected_deg, digit) << force;
  }
  // With a true radian the first is 0.0026 deg smaller.
  const TanhLaw exact(JointKind::ball, LimitHalfAngle::given(84.85 * degree));
  EXPECT_NEAR(exact.half_angle(0.546).half_angle / degree, 42.59049, 5e-6);
}

}  // namespace
}  // namespace contact::test::paper_laws_test
