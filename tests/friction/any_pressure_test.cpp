#include "libcontact/base/instruction_set.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/expansion.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/pressure/mixture.hpp"
#include "libcontact/pressure/sqrt.hpp"
#include "libcontact/tools/reference/quadrature.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/friction_reference.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::any_pressure_test {
namespace {

constexpr JointKind ball = JointKind::ball;

ElasticPair unlike_pair() {
  return ElasticPair::from_modulus_ratio(7, 0.3, 0.4);
}

std::unique_ptr<PressureLaw> law_of(const std::string& name) {
  return make_pressure_law(name, ball, unlike_pair());
}

const std::vector<std::string>& other_names() {
  static const std::vector<std::string> names = {"sqrt_tan", "sqrt_theta",
                                                 "mixture", "exact", "worn"};
  return names;
}

// The worn pressure alone, at 90 deg.
bool ends_before(const PressureLaw& law, double half_angle) {
  return law.name() == "worn" && half_angle > law.largest_half_angle();
}

// The requested accuracy.
constexpr double budget = 1e-10;

struct NamedLaw {
  std::string name;
  std::unique_ptr<PressureLaw> law;
};

// All of them, and exact pressures with the largest logarithms of both signs,
// with none, of materials that reach beyond 120 deg, and with logarithms of
// both sides of the size from which finer rules are taken.
std::vector<NamedLaw> laws_to_integrate() {
  std::vector<NamedLaw> laws;
  for (const std::string& name : other_names()) {
    laws.push_back({name, law_of(name)});
  }
  for (const auto& [ratio, inner, outer] : {std::array{0.0, 0.0, 0.3},
                                            {infinity, 0.3, 0.0},
                                            {1.0, 0.3, 0.3},
                                            {0.02, 0.48, 0.2},
                                            {0.0, 0.49, 0.3},
                                            {7.0, 0.3, 0.3},
                                            {20.0, 0.3, 0.3}}) {
    laws.push_back(
        {"exact " + std::to_string(ratio) + ' ' + std::to_string(inner) + ' ' +
             std::to_string(outer),
         std::make_unique<ExactPressure>(
             ball, ElasticPair::from_modulus_ratio(ratio, inner, outer))});
  }
  return laws;
}

std::string label(const std::string& law, double theta0_deg, double alpha_deg) {
  return law + " theta0 = " + std::to_string(theta0_deg) +
         " deg, a = " + std::to_string(alpha_deg) + " deg";
}

// By parts with rules so fine that they need no thought: both ends of each
// piece between poles are approached like u^4. Shares the area integrals with
// the method, and nothing else.
FrictionTriple by_parts(const PressureLaw& law, double theta0, SlipAxis axis) {
  using Rule = boost::math::quadrature::gauss<double, 150>;
  const double b = std::tan(theta0 / 2);
  const double sum = 1 + std::abs(axis.sin);
  std::vector<double> cuts = {0};
  for (const double s : {sum / (axis.cos * b), axis.cos / (sum * b)}) {
    if (s < 1) cuts.push_back(std::acos(s));
  }
  cuts.push_back(pi / 2);
  FrictionTriple total{0, 0, 0};
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double length = cuts[i + 1] - cuts[i];
    const auto integrand = [&](double u, double FrictionTriple::*role) {
      const double y = u * u * u * u * (35 + u * (-84 + u * (70 - 20 * u)));
      const double dy = 140 * std::pow(u * (1 - u), 3);
      const double x = std::sin(cuts[i] + length * y);
      const double s = std::cos(cuts[i] + length * y);
      double slope = 0;
      law.edge_slopes(theta0, {&x, 1}, {&slope, 1});
      const FrictionIntegrals area =
          friction_integrals(2 * std::atan(b * s), axis);
      return dy * length * s * slope * area.area.*role;
    };
    for (const auto role : {&FrictionTriple::force, &FrictionTriple::sliding,
                            &FrictionTriple::spinning}) {
      total.*role += Rule::integrate(
          [&](double u) { return integrand(u, role); }, 0.0, 1.0);
    }
  }
  const double edge = law.pressure(theta0, theta0);
  const FrictionTriple area = friction_integrals(theta0, axis).area;
  return {total.force + edge * area.force, total.sliding + edge * area.sliding,
          total.spinning + edge * area.spinning};
}

TEST(FrictionPressure, AgreesWithQuadratureOfTheDefinition) {
  for (const auto& [name, law] : laws_to_integrate()) {
    // GSL's 1e-10 beside the budget.
    AccuracyReport report(name, budget + 1e-10);
    for (const auto& [theta0_deg, alpha_deg] : {std::array{5.0, 20.0},
                                                {30.0, 45.0},
                                                {60.0, 50.0},
                                                {85.0, 20.0},
                                                {100.0, 40.0},
                                                {115.0, 10.0}}) {
      if (ends_before(*law, theta0_deg * degree)) continue;
      const SlipAxis axis = SlipAxis::from_degrees(alpha_deg);
      const auto expected = reference::quadrature_friction_integrals(
          *law, theta0_deg * degree, axis, 1e-10);
      const auto computed = friction_integrals(*law, theta0_deg * degree, axis);
      const std::string row = label(name, theta0_deg, alpha_deg);
      add_integrals(report, computed, expected.value, row);
    }
  }
}

TEST(FrictionPressure, AgreesWithIntegrationByParts) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto logarithmic = [&](double decades) {
    return std::pow(10, -decades * uniform(random));
  };
  for (const NamedLaw& each : laws_to_integrate()) {
    const PressureLaw& law = *each.law;
    AccuracyReport report(each.name, budget);
    const auto add = [&](double theta0_deg, double complement_deg) {
      if (ends_before(law, theta0_deg * degree)) return;
      const double b = std::min(std::max(complement_deg, 1e-7), 90 - 1e-7);
      const SlipAxis axis = SlipAxis::from_complement(b * degree);
      add_triple(report,
                 friction_integrals(law, theta0_deg * degree, axis).coefficient,
                 by_parts(law, theta0_deg * degree, axis),
                 label(each.name, theta0_deg, 90 - b));
    };
    for (int i = 0; i < 40; ++i) {
      add(120 * uniform(random), 90 * uniform(random));
      const double theta0_deg = 90 * uniform(random);
      // The pole near the edge, outside and inside; near the centre.
      add(theta0_deg, theta0_deg * (1 + logarithmic(8)));
      add(theta0_deg, theta0_deg * (1 - logarithmic(8)));
      add(theta0_deg, theta0_deg * logarithmic(7));
      // Beyond the hemisphere, the second pole near the edge; two poles that
      // almost meet.
      const double wide_deg = 90 + 30 * uniform(random);
      add(wide_deg, 90 - (wide_deg - 90) * (1 + logarithmic(7)));
      add(wide_deg, 90 - (wide_deg - 90) * (1 - logarithmic(7)));
      add(88 + 30 * uniform(random), 90 - logarithmic(6));
      // Small contacts about as wide as the pole is far.
      const double small_deg = logarithmic(6);
      add(small_deg, small_deg * std::pow(10, 4 * uniform(random) - 2));
    }
    // Both sides of 90 deg.
    add(90, 30);
    add(std::nextafter(90, 91), 30);
  }
}

TEST(FrictionPressure, CosineIsTheExactMethod) {
  const CosinePressure law(ball);
  for (const auto& row : friction_reference()) {
    const auto computed = friction_integrals(law, row.half_angle, row.axis);
    const auto expected = friction_integrals(row.half_angle, row.axis);
    for (const auto& quantity : friction_quantities()) {
      EXPECT_EQ(quantity.of(computed), quantity.of(expected)) << row.label;
    }
  }
}

TEST(FrictionPressure, AgreesWithTheTabulatedCoefficients) {
  // Printed to six decimals, half-angles to 1e-4 deg.
  constexpr double digits = 2e-6;
  const ReferenceTable table("conforming/pressure_friction.csv");
  for (const ReferenceTable::Row row : table) {
    if (row.text("joint") != "sphere") continue;
    const ExactPressure exact(
        ball, ElasticPair::from_modulus_ratio(
                  row.value("Ebar"), row.value("nu"), row.value("nu")));
    const SqrtTanPressure sqrt_tan(ball);
    const SqrtThetaPressure sqrt_theta(ball);
    const double half_angle = row.value("theta0_deg") * degree;
    const auto check = [&](const PressureLaw& law, const std::string& column) {
      const auto r = friction_integrals(law, half_angle, SlipAxis{0, 1});
      EXPECT_NEAR(r.coefficient.force, row.value("chi_" + column), digits)
          << row.label();
      EXPECT_NEAR(r.coefficient.sliding, row.value("sigmaY_" + column), digits)
          << row.label();
    };
    check(exact, "exact");
    check(sqrt_tan, "sqrt");
    check(sqrt_theta, "sqrt_theta");
  }
}

TEST(FrictionPressure, SpinningDiffersByTenToTwentyPercent) {
  // Why the choice matters: sigma_Z at a = 90 deg of the cosine pressure
  // against the exact one, up to the limit half-angle of equal materials.
  const auto pair = ElasticPair::from_modulus_ratio(1, 0.3, 0.3);
  const ExactPressure exact(ball, pair);
  const CosinePressure cosine(ball);
  for (double theta0_deg = 1; theta0_deg <= 88; theta0_deg += 3) {
    const auto sigma = [&](const PressureLaw& law) {
      return friction_integrals(law, theta0_deg * degree, SlipAxis{1, 0})
          .coefficient.spinning;
    };
    const double excess = sigma(exact) / sigma(cosine) - 1;
    EXPECT_GT(excess, 0.09) << theta0_deg;
    EXPECT_LT(excess, 0.21) << theta0_deg;
    // Hertz' disc has 3 pi/16 theta0, the paraboloid 8/15 theta0.
    if (theta0_deg == 1) {
      EXPECT_NEAR(1 + excess, 3 * pi / 16 * 15 / 8, 1e-4);
    }
  }
}

TEST(FrictionPressure, SpecialAxes) {
  for (const std::string& name : other_names()) {
    const auto law = law_of(name);
    for (const double theta0_deg : {10.0, 89.0, 90.0, 100.0, 119.0}) {
      const double half_angle = theta0_deg * degree;
      if (ends_before(*law, half_angle)) continue;
      const auto slide = friction_integrals(*law, half_angle, SlipAxis{0, 1});
      EXPECT_EQ(slide.coefficient.spinning, 0) << name;
      const auto spin = friction_integrals(*law, half_angle, SlipAxis{1, 0});
      EXPECT_EQ(spin.coefficient.force, 0) << name;
      EXPECT_EQ(spin.coefficient.sliding, 0) << name;
      const auto one =
          friction_integrals(*law, half_angle, SlipAxis::from_degrees(40));
      const auto other =
          friction_integrals(*law, half_angle, SlipAxis::from_degrees(-40));
      EXPECT_EQ(one.coefficient.force, other.coefficient.force);
      EXPECT_EQ(one.coefficient.sliding, other.coefficient.sliding);
      EXPECT_EQ(one.coefficient.spinning, -other.coefficient.spinning);
    }
    const auto none = friction_integrals(*law, 0, SlipAxis::from_degrees(40));
    EXPECT_EQ(none.coefficient.force, 1);
    EXPECT_EQ(none.coefficient.sliding, 1);
    EXPECT_EQ(none.coefficient.spinning, 0);
    EXPECT_EQ(none.normal, 0);
    for (const double tiny : {1e-100, 1e-139, 1e-141, 1e-300}) {
      const auto r = friction_integrals(*law, tiny, SlipAxis::from_degrees(40));
      EXPECT_NEAR(r.coefficient.force, 1, 1e-9) << name << tiny;
      EXPECT_NEAR(r.coefficient.sliding, 1, 1e-9) << name << tiny;
    }
  }
}

// M_t is the gradient of the potential Phi = A0(a) |Dw|, so dA0/da follows
// from the moments.
TEST(FrictionPressure, MomentsHaveAPotential) {
  for (const std::string& name : other_names()) {
    const auto law = law_of(name);
    // Errors of some 1e-12 (2e-12 at 95 and 5 deg, where the pole lies on the
    // edge and the method changes; 8e-12 of the exact pressure) over h.
    AccuracyReport report(name + ": dPhi/da", name == "exact" ? 8e-8 : 1e-8);
    for (const double theta0_deg : {20.0, 70.0, 95.0}) {
      if (ends_before(*law, theta0_deg * degree)) continue;
      for (const double alpha_deg : {5.0, 35.0, 80.0}) {
        const auto triple = [&](double a) {
          return friction_integrals(*law, theta0_deg * degree,
                                    SlipAxis::from_angle(a))
              .coefficient;
        };
        const auto potential = [&](double a) {
          const FrictionTriple c = triple(a);
          return c.sliding * std::cos(a) + c.spinning * std::sin(a);
        };
        const double a = alpha_deg * degree;
        const double h = 1e-4;
        const FrictionTriple c = triple(a);
        // Central differences of fourth order; over the potential.
        const double slope = (8 * (potential(a + h) - potential(a - h)) -
                              (potential(a + 2 * h) - potential(a - 2 * h))) /
                             (12 * h);
        report.add_error(std::abs(slope - (c.spinning * std::cos(a) -
                                           c.sliding * std::sin(a))) /
                             potential(a),
                         label(name, theta0_deg, alpha_deg));
      }
    }
  }
}

TEST(FrictionPressure, NanAndAllocations) {
  for (const std::string& name : other_names()) {
    const auto law = law_of(name);
    for (const double bad : {nan, -0.1, 3.2}) {
      const auto r = friction_integrals(*law, bad, SlipAxis::from_degrees(30));
      EXPECT_TRUE(all_nan({r.coefficient.force, r.coefficient.spinning}))
          << name;
    }
    const auto r = friction_integrals(*law, 0.5, SlipAxis{nan, nan});
    EXPECT_TRUE(std::isnan(r.coefficient.force)) << name;
    std::vector<double> half_angles, sines(200, 0.6), cosines(200, 0.8);
    for (int i = 0; i < 200; ++i) half_angles.push_back(0.01 * (i + 1));
    std::vector<double> force(200);
    const std::size_t before = allocation_count();
    for (const double half_angle : {0.5, 1.2, 1.8}) {
      for (const double a_deg : {3.0, 40.0}) {  // poles outside, inside, two
        friction_integrals(*law, half_angle, SlipAxis::from_degrees(a_deg));
      }
    }
    friction_integrals(*law, {half_angles, sines, cosines},
                       {{}, {}, {}, {}, {}, {}, {}, force, {}, {}});
    EXPECT_EQ(allocation_count(), before) << name;
  }
}

using Input = std::array<std::vector<double>, 3>;

// Batches interpolate the pressure between half-angles and take for each point
// the rule of a neighbour that needs more nodes, so that they differ from the
// scalar call by the errors of both.
double batch_budget(const std::string& name) {
  if (name == "exact") return budget;
  return name == "cosine" ? 2e-14 : 4e-11;
}

void check_batch(const Input& in) {
  const std::size_t count = in[0].size();
  std::array<std::vector<double>, 10> r;
  for (auto& column : r) column.resize(count);
  using enum InstructionSet;
  for (const auto set : {baseline, avx2, avx512}) {
    if (!is_supported(set)) continue;
    const contact::detail::WithInstructionSet with(set);
    for (const std::string& name : pressure_law_names()) {
      const auto law = law_of(name);
      friction_integrals(
          *law, {in[0], in[1], in[2]},
          {r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], r[9]});
      AccuracyReport report(name, batch_budget(name));
      for (std::size_t i = 0; i < count; ++i) {
        const FrictionIntegrals one =
            friction_integrals(*law, in[0][i], {in[1][i], in[2][i]});
        if (std::isnan(one.coefficient.sliding)) {
          EXPECT_TRUE(std::isnan(r[7][i]) && std::isnan(r[9][i]));
          continue;
        }
        const std::string row = label(name, in[0][i] / degree, in[1][i]);
        add_integrals(report,
                      {r[0][i],
                       {r[1][i], r[2][i], r[3][i]},
                       {r[4][i], r[5][i], r[6][i]},
                       {r[7][i], r[8][i], r[9][i]}},
                      one, row);
      }
      if (ends_before(*law, std::ranges::min(in[0]))) report.may_be_empty();
      // Columns that are not wanted.
      for (const std::size_t column : {1, 8}) {
        std::vector<double> only(count);
        FrictionBatchOutput out{};
        (column == 1 ? out.force_pressure : out.sliding) = only;
        friction_integrals(*law, {in[0], in[1], in[2]}, out);
        for (std::size_t i = 0; i < count; ++i) {
          if (std::isnan(r[column][i])) continue;
          EXPECT_EQ(only[i], r[column][i]);
        }
      }
    }
  }
}

TEST(FrictionPressure, BatchIsTheScalarCall) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  // With tables and without, up to 90 deg and beyond.
  for (const std::size_t count : {60, 300, 3000}) {
    for (const double largest_deg : {90, 119}) {
      Input in;
      for (std::size_t i = 0; i < count; ++i) {
        const double a = pi * (uniform(random) - 0.5);
        const double theta0 = largest_deg * degree * uniform(random);
        in[0].push_back(
            i % 3 == 0 ? theta0 * std::pow(10, -0.01 * static_cast<double>(i))
                       : theta0);
        in[1].push_back(std::sin(a));
        in[2].push_back(std::cos(a));
      }
      // Values outside every table.
      in[0][5] = 0;
      in[0][6] = 1e-150;
      in[0][7] = nan;
      in[0][8] = -0.1;
      in[0][9] = 3.1;
      in[0][10] = 130 * degree;
      in[1][11] = in[2][11] = nan;
      check_batch(in);
    }
  }
}

TEST(FrictionPressure, BatchOfOneHalfAngle) {
  for (const double theta0_deg : {1e-3, 45.0, 90.0, 100.0}) {
    Input in;
    for (int i = 0; i <= 200; ++i) {
      const SlipAxis axis = SlipAxis::from_degrees(0.45 * i);
      in[0].push_back(theta0_deg * degree);
      in[1].push_back(axis.sin);
      in[2].push_back(axis.cos);
    }
    check_batch(in);
  }
}

// A pressure with every part that a PressureExpansion can have.
class MixedPressure final : public PressureLaw {
 public:
  MixedPressure() : PressureLaw(ball) {}
  std::string name() const override { return "mixed"; }
  double largest_half_angle() const noexcept override { return 2.2; }
  double force_ratio(double) const noexcept override { return 1; }
  double peak(double) const noexcept override { return 1; }
  double slope(double, double) const noexcept override { return nan; }
  // At the edge.
  double pressure(double, double) const noexcept override { return 0; }
  PressureExpansion expansion(double half_angle) const noexcept override {
    return {.cosine_share = 0.3,
            .edge_constant = 1 + 2 * std::cos(half_angle / 2),
            .size = 2,
            .coefficient = {0.9, 0.2},
            .logarithmic = {0.3, -0.2, 0.1}};
  }
  // dp/dy, y^2 = 1 - tan^2(t/2)/tan^2(theta0/2).
  void edge_slopes(double half_angle, std::span<const double> y,
                   std::span<double> out) const noexcept override {
    const CosinePressure cosine(ball);
    const double c = std::cos(half_angle / 2);
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double y2 = y[i] * y[i];
      const double share = c / (1 - (1 - c) * y2);  // x^2/y^2
      const double x = y[i] * std::sqrt(share);
      const double x2 = x * x;
      // d/dx of 0.9 x + 0.2 x (2 x^2 - 1) and of x^3 ln X (...),
      // X^2 = c x^2/(1 - (1 - c) x^2)
      const double smooth = 0.7 + 1.2 * x2;
      const double rest = 1 - (1 - c) * x2;
      const double log_X = std::log(c * x2 / rest) / 2;
      const double logarithm =
          x2 * ((3 * 0.3 - x2 * (5 * 0.2 - x2 * 7 * 0.1)) * log_X +
                (0.3 - x2 * (0.2 - x2 * 0.1)) / rest);
      double part = 0;
      cosine.edge_slopes(half_angle, y.subspan(i, 1), {&part, 1});
      out[i] = (smooth + logarithm) * share * std::sqrt(share) / c + 0.3 * part;
    }
  }
};

TEST(FrictionPressure, LogarithmsAreResolved) {
  const MixedPressure law;
  // Their factor is analytic, and the rules have it by the terms that they
  // resolve.
  AccuracyReport report("logarithms", 1e-10);
  AccuracyReport batch("logarithms, batch", 4e-11);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  Input in;
  for (int i = 0; i < 200; ++i) {
    const double theta0 = (i % 2 == 0 ? 90 : 120) * degree * uniform(random);
    const SlipAxis axis = SlipAxis::from_degrees(90 * uniform(random));
    in[0].push_back(theta0);
    in[1].push_back(axis.sin);
    in[2].push_back(axis.cos);
    add_triple(report, friction_integrals(law, theta0, axis).coefficient,
               by_parts(law, theta0, axis),
               label("mixed", theta0 / degree, std::asin(axis.sin) / degree));
  }
  std::array<std::vector<double>, 3> r;
  for (auto& column : r) column.resize(in[0].size());
  friction_integrals(law, {in[0], in[1], in[2]},
                     {{}, {}, {}, {}, {}, {}, {}, r[0], r[1], r[2]});
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    add_triple(
        batch, {r[0][i], r[1][i], r[2][i]},
        friction_integrals(law, in[0][i], {in[1][i], in[2][i]}).coefficient,
        std::to_string(i));
  }
}

// A law without a term of the kind x B_k: the cosine pressure or a
// part of it.
class OnlyCosine final : public PressureLaw {
 public:
  explicit OnlyCosine(double share)
      : PressureLaw(ball), cosine_(ball), share_(share) {}
  std::string name() const override { return "only cosine"; }
  double largest_half_angle() const noexcept override {
    return cosine_.largest_half_angle();
  }
  double force_ratio(double half_angle) const noexcept override {
    return cosine_.force_ratio(half_angle);
  }
  double peak(double half_angle) const noexcept override {
    return cosine_.peak(half_angle);
  }
  double slope(double theta, double half_angle) const noexcept override {
    return cosine_.slope(theta, half_angle);
  }
  double pressure(double theta, double half_angle) const noexcept override {
    return cosine_.pressure(theta, half_angle);
  }
  PressureExpansion expansion(double half_angle) const noexcept override {
    auto result = detail::expansion_of(cosine_, half_angle);
    result.cosine_share *= share_;
    return result;
  }
  void edge_slopes(double half_angle, std::span<const double> y,
                   std::span<double> out) const noexcept override {
    cosine_.edge_slopes(half_angle, y, out);
  }

 private:
  CosinePressure cosine_;
  double share_;
};

TEST(FrictionPressure, ExpansionsMayHaveNoTerms) {
  AccuracyReport report("a share of the cosine pressure alone", 1e-13);
  Input in;
  for (int i = 1; i <= 120; ++i) {
    const SlipAxis axis = SlipAxis::from_degrees(0.7 * i);
    in[0].push_back(i * degree);
    in[1].push_back(axis.sin);
    in[2].push_back(axis.cos);
  }
  std::array<std::vector<double>, 3> r;
  for (auto& column : r) column.resize(in[0].size());
  for (const double share : {1.0, 0.5}) {
    const OnlyCosine law(share);
    friction_integrals(law, {in[0], in[1], in[2]},
                       {{}, {}, {}, {}, {}, {}, {}, r[0], r[1], r[2]});
    for (std::size_t i = 0; i < in[0].size(); ++i) {
      const SlipAxis axis{in[1][i], in[2][i]};
      const FrictionTriple whole =
          friction_integrals(in[0][i], axis).coefficient;
      const FrictionTriple expected = {
          share * whole.force, share * whole.sliding, share * whole.spinning};
      add_triple(report, friction_integrals(law, in[0][i], axis).coefficient,
                 expected, std::to_string(i));
      add_triple(report, {r[0][i], r[1][i], r[2][i]}, expected,
                 std::to_string(i) + ", batch");
    }
  }
}

TEST(FrictionPressure, ViscousAnalogueIsItsDefinition) {
  using Rule = boost::math::quadrature::gauss<double, 60>;
  auto laws = laws_to_integrate();
  laws.push_back({"cosine", law_of("cosine")});
  for (const NamedLaw& each : laws) {
    const PressureLaw& law = *each.law;
    AccuracyReport report(each.name, 1e-11);
    for (const double theta0_deg : {1.0, 40.0, 90.0, 119.0}) {
      const double theta0 = theta0_deg * degree;
      if (ends_before(law, theta0)) continue;
      const double b = std::tan(theta0 / 2);
      // 2 pi ∫ p f(t) sin t dt in the angle of the edge variable.
      const auto integral = [&](auto f) {
        return Rule::integrate(
            [&](double phi) {
              const double tangent = b * std::cos(phi);
              const double t = 2 * std::atan(tangent);
              return 2 * pi * law.pressure(t, theta0) * f(t) * std::sin(t) * 2 *
                     b * std::sin(phi) / (1 + tangent * tangent);
            },
            0.0, pi / 2);
      };
      const SlipAxis axis = SlipAxis::from_degrees(35);
      const double sine2 =
          integral([](double t) { return std::sin(t) * std::sin(t); });
      const double sum = integral([](double) { return 1; });
      const FrictionIntegrals r = viscous_friction_integrals(law, theta0, axis);
      const std::string row = label(each.name, theta0_deg, 35);
      add_triple(report, r.coefficient,
                 {axis.cos, (sum - sine2 / 2) * axis.cos, sine2 * axis.sin},
                 row);
    }
    EXPECT_TRUE(std::isnan(viscous_friction_integrals(law, nan, SlipAxis{0, 1})
                               .coefficient.force));
  }
}

}  // namespace
}  // namespace contact::test::any_pressure_test
