// Properties of every pressure law, and the members beside CosinePressure.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/half_angle/fitted.hpp"
#include "libcontact/half_angle/paper_laws.hpp"
#include "libcontact/half_angle/worn.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/pressure/expanded.hpp"
#include "libcontact/pressure/factory.hpp"
#include "libcontact/pressure/hertz.hpp"
#include "libcontact/pressure/mixture.hpp"
#include "libcontact/pressure/mixture_coefficients.hpp"
#include "libcontact/pressure/sqrt.hpp"
#include "libcontact/pressure/validity.hpp"
#include "libcontact/pressure/worn.hpp"
#include "libcontact/tools/reference/pressure_mixture_fit.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::family_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

ElasticPair steel_in_polymer() {
  return ElasticPair::from_modulus_ratio(7, 0.3, 0.4);
}

std::vector<std::unique_ptr<PressureLaw>> laws(JointKind kind) {
  std::vector<std::unique_ptr<PressureLaw>> result;
  for (const std::string& name : pressure_law_names()) {
    result.push_back(make_pressure_law(name, kind, steel_in_polymer()));
  }
  return result;
}

std::string label(const PressureLaw& law, double half_angle) {
  return law.name() + " " + to_string(law.joint_kind()) +
         ", theta0 = " + std::to_string(half_angle / degree) + " deg";
}

// The worn pressure alone, at 90 deg.
bool ends_before(const PressureLaw& law, double half_angle) {
  return law.name() == "worn" && half_angle > law.largest_half_angle();
}

// Calls visit(law, half-angle) for every law of both joints.
template <class Visit>
void for_every_law(std::initializer_list<double> half_angles_deg,
                   const Visit& visit) {
  for (const JointKind kind : kinds) {
    for (const auto& law : laws(kind)) {
      for (const double half_angle_deg : half_angles_deg) {
        const double half_angle = half_angle_deg * degree;
        if (!ends_before(*law, half_angle)) visit(*law, half_angle);
      }
    }
  }
}

// ∫ f(t, p(t)) over [0, theta0] in the edge variable's angle phi, in which
// every law is smooth.
template <class F>
double over_contact(const PressureLaw& law, double half_angle, F f) {
  using Rule = boost::math::quadrature::gauss<double, 60>;
  const double b = std::tan(half_angle / 2);
  return Rule::integrate(
      [&](double phi) {
        const double s = std::cos(phi);
        const double t = 2 * std::atan(b * s);
        const double dt = 2 * b * std::sin(phi) / (1 + b * b * s * s);
        return f(t, law.pressure(t, half_angle)) * dt;
      },
      0.0, pi / 2);
}

TEST(PressureLaw, CarriesTheLoadAndSumsUpToTheForceRatio) {
  // The exact law interpolates between half-angles; the others: rounding of
  // angles near the edge, which the cosine pressure does not feel.
  AccuracyReport load("load carried", 2e-12);
  AccuracyReport sum("force_ratio", 1e-12);
  AccuracyReport cosine("load and force_ratio, cosine", 1e-14);
  for_every_law(
      {0.01, 3, 23, 40, 69, 77, 89.9, 92, 95, 119, 119.7},
      [&](const PressureLaw& law, double half_angle) {
        const auto weight = [&](double t) {
          return law.joint_kind() == JointKind::ball ? 2 * pi * std::sin(t)
                                                     : 2.0;
        };
        const bool is_cosine = law.name() == "cosine";
        (is_cosine ? cosine : load)
            .add(over_contact(law, half_angle,
                              [&](double t, double p) {
                                return p * std::cos(t) * weight(t);
                              }),
                 1.0, label(law, half_angle));
        (is_cosine ? cosine : sum)
            .add(
                over_contact(law, half_angle,
                             [&](double t, double p) { return p * weight(t); }),
                law.force_ratio(half_angle), label(law, half_angle));
      });
}

TEST(PressureLaw, SlopesAreDerivativesOfThePressure) {
  // Central differences with steps of 1e-4 of the distance from the edge.
  AccuracyReport slope("slope", 1e-6);
  AccuracyReport edge("edge_slopes", 1e-6);
  for_every_law(
      {1, 30, 80, 110}, [&](const PressureLaw& law, double half_angle) {
        const double b = std::tan(half_angle / 2);
        for (const double x : {0.1, 0.35, 0.8, 0.97}) {
          const auto theta = [&](double edge_variable) {
            return 2 * std::atan(b * std::sqrt((1 - edge_variable) *
                                               (1 + edge_variable)));
          };
          const auto p = [&](double t) { return law.pressure(t, half_angle); };
          const double t = theta(x);
          const double h = 1e-4 * x * x * half_angle;
          slope.add(law.slope(t, half_angle), (p(t - h) - p(t + h)) / (2 * h),
                    label(law, half_angle));
          double found = 0;
          law.edge_slopes(half_angle, {&x, 1}, {&found, 1});
          edge.add(found, (p(theta(x + 1e-4)) - p(theta(x - 1e-4))) / 2e-4,
                   label(law, half_angle));
        }
      });
}

TEST(PressureLaw, EdgeSlopesAddUpToThePeak) {
  using Rule = boost::math::quadrature::gauss<double, 60>;
  AccuracyReport report("integral of edge_slopes over the peak", 1e-13);
  for_every_law({1e-6, 5, 60, 90, 119}, [&](const PressureLaw& law,
                                            double half_angle) {
    // x = u^2, since exact pressures have x^2 ln x.
    const double sum = Rule::integrate(
        [&](double u) {
          const double x = u * u;
          double value = 0;
          law.edge_slopes(half_angle, {&x, 1}, {&value, 1});
          return 2 * u * value;
        },
        0.0, 1.0);
    const double edge = law.pressure(half_angle, half_angle);
    const double peak = law.peak(half_angle);
    report.add_error(std::abs(sum - (peak - edge)) / peak,
                     label(law, half_angle));
    // Both ends of the interval.
    for (const double x : {0.0, 1.0}) {
      double slope = -1;
      law.edge_slopes(half_angle, {&x, 1}, {&slope, 1});
      EXPECT_TRUE(std::isfinite(slope) && slope >= 0) << label(law, half_angle);
    }
  });
}

// The expansion of a law is the law, and so are its slopes.
TEST(ExpandedPressure, IsTheLaw) {
  // Terms below 1e-13 are left out; slopes have them times their degree.
  AccuracyReport values("pressures, of the peak", 1e-12);
  AccuracyReport slopes("slopes, of peak/theta0", 1e-11);
  for_every_law({0.01, 3, 40, 77, 89.9}, [&](const PressureLaw& law,
                                             double half_angle) {
    const detail::ExpandedPressure expanded(law, half_angle);
    ASSERT_FALSE(expanded.is_empty()) << law.name();
    const double peak = law.peak(half_angle);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 0.999}) {
      const double t = share * half_angle;
      const auto [pressure, slope] = expanded.at(t);
      values.add_error(std::abs(pressure - law.pressure(t, half_angle)) / peak,
                       label(law, half_angle));
      slopes.add_error(
          std::abs(slope - law.slope(t, half_angle)) * half_angle / peak,
          label(law, half_angle));
    }
  });
}

TEST(PressureLaw, SymmetryAndEdge) {
  for_every_law(
      {1e-5 / degree, 0.7 / degree, 1.9 / degree, 2 / degree},
      [](const PressureLaw& law, double half_angle) {
        SCOPED_TRACE(label(law, half_angle));
        const double t = 0.6 * half_angle;
        EXPECT_EQ(law.pressure(-t, half_angle), law.pressure(t, half_angle));
        EXPECT_EQ(law.slope(-t, half_angle), -law.slope(t, half_angle));
        EXPECT_EQ(law.pressure(0, half_angle), law.peak(half_angle));
        if (law.name() != "worn") {
          EXPECT_EQ(law.pressure(half_angle, half_angle), 0);
        }
        EXPECT_GT(law.slope(half_angle, half_angle), 0);
        EXPECT_EQ(law.slope(0, half_angle), 0);
        const double outside = std::nextafter(half_angle, 4);
        EXPECT_EQ(law.pressure(outside, half_angle), 0);
        EXPECT_EQ(law.pressure(-outside, half_angle), 0);
        EXPECT_EQ(law.slope(outside, half_angle), 0);
        EXPECT_EQ(law.slope(-outside, half_angle), 0);
      });
}

TEST(PressureLaw, NanAndWhatIsOutOfRange) {
  for_every_law({0}, [](const PressureLaw& law, double) {
    SCOPED_TRACE(label(law, 0));
    for (const double bad :
         {nan, -1e-300, -1.0, 3.1415926535897936, 3.2, infinity}) {
      const double x = 0.5;
      double slope = 0;
      law.edge_slopes(bad, {&x, 1}, {&slope, 1});
      EXPECT_TRUE(
          all_nan({law.pressure(0.1, bad), law.slope(0.1, bad), law.peak(bad),
                   law.mean(bad), law.force_ratio(bad), slope}))
          << bad;
    }
    EXPECT_TRUE(all_nan({law.pressure(nan, 1), law.slope(nan, 1)}));
    EXPECT_EQ(law.peak(0), infinity);
    EXPECT_NEAR(law.force_ratio(0), 1, 1e-11);
  });
}

TEST(PressureLaw, DoesNotAllocate) {
  for (const JointKind kind : kinds) {
    const auto members = laws(kind);
    const std::size_t before = allocation_count();
    double sum = 0;
    for (const auto& law : members) {
      std::array<double, 3> x{0.1, 0.5, 0.9};
      std::array<double, 3> out{};
      law->edge_slopes(1, x, out);
      sum += law->pressure(0.3, 1) + law->slope(0.3, 1) + law->mean(1) +
             law->peak(1) + law->force_ratio(1) + out[0];
    }
    EXPECT_EQ(allocation_count(), before);
    EXPECT_GT(sum, 0);
  }
}

TEST(MakePressureLaw, KnowsItsNames) {
  for (const std::string& name : pressure_law_names()) {
    const auto law =
        make_pressure_law(name, JointKind::pin, steel_in_polymer());
    EXPECT_EQ(law->name(), name);
    EXPECT_EQ(law->joint_kind(), JointKind::pin);
  }
}

TEST(MakePressureLaw, FollowsTheLoadingOrRefusesIt) {
  const ElasticPair pair = steel_in_polymer();
  const auto back = InnerLoading::back(25 * degree);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    for (const std::string& name : pressure_law_names()) {
      if (!pressure_law_allows(name, {back})) continue;
      const double peak = make_pressure_law(name, kind, pair, {back})->peak(1);
      const double at_centre = make_pressure_law(name, kind, pair)->peak(1);
      if (name == "exact") {
        EXPECT_EQ(peak, ExactPressure(kind, pair, back).peak(1));
        EXPECT_NE(peak, at_centre);
      } else {
        EXPECT_EQ(peak, at_centre) << name;
      }
    }
  }
  EXPECT_ERROR(
      make_pressure_law("mixture", JointKind::ball, pair, {back}),
      "pressure law mixture must be cosine, sqrt_tan, sqrt_theta, exact or "
      "worn with loading back:25");
}

// Normalisation by quadrature of the definition in 50 digits.
struct Definition {
  Real normal;
  Real sum;
};

Definition definition(JointKind kind, bool tangent, double half_angle) {
  using std::sqrt;
  using Rule = boost::math::quadrature::gauss<Real, 100>;
  const Real t0 = half_angle;
  const Real b = tan(t0 / 2);
  const bool ball = kind == JointKind::ball;
  // theta = theta0 cos(phi), or tan(theta/2) = b cos(phi).
  const auto integral = [&](bool with_cosine) {
    return Rule::integrate(
        [&](const Real& phi) {
          const Real s = cos(phi);
          const Real x = sin(phi);
          const Real t = tangent ? Real(2 * atan(b * s)) : Real(t0 * s);
          const Real dt =
              tangent ? Real(2 * b * x / (1 + b * b * s * s)) : Real(t0 * x);
          const Real area =
              ball ? Real(2 * boost::math::constants::pi<Real>() * sin(t))
                   : Real(2);
          return Real(x * dt * area * (with_cosine ? cos(t) : Real(1)));
        },
        Real(0), boost::math::constants::half_pi<Real>());
  };
  return {integral(true), integral(false)};
}

TEST(SqrtPressures, AgreeWithTheirDefinitionInHighPrecision) {
  // Some 20 roundings; Struve's series loses a digit at 150 deg.
  AccuracyReport peak("peak", 1e-14);
  AccuracyReport force("force_ratio", 1e-14);
  std::vector<double> angles_deg = {1e-8, 1e-3,     0.3, 5,  20,  45,  59.99999,
                                    60.0, 60.00001, 75,  90, 105, 120, 150};
  for (const JointKind kind : kinds) {
    const SqrtTanPressure sqrt_tan(kind);
    const SqrtThetaPressure sqrt_theta(kind);
    for (const double theta0_deg : angles_deg) {
      const double half_angle = theta0_deg * degree;
      for (const PressureLaw* law :
           std::initializer_list<const PressureLaw*>{&sqrt_tan, &sqrt_theta}) {
        const Definition d = definition(kind, law == &sqrt_tan, half_angle);
        peak.add(Real(law->peak(half_angle)), Real(1 / d.normal),
                 label(*law, half_angle));
        force.add(Real(law->force_ratio(half_angle)), Real(d.sum / d.normal),
                  label(*law, half_angle));
      }
    }
  }
}

// Against the definition by quadrature in 50 digits. Some 10 roundings; near 90
// deg the rounding of the angle dominates cos theta.
TEST(WornPressure, AgreesWithItsDefinitionInHighPrecision) {
  using Rule = boost::math::quadrature::gauss<Real, 60>;
  AccuracyReport peak("peak", 2e-15);
  AccuracyReport force("force_ratio", 2e-15);
  AccuracyReport slope("edge_slopes", 3e-15);
  for (const JointKind kind : kinds) {
    const WornPressure law(kind);
    for (const double theta0_deg : {1e-6, 0.3, 5.0, 20.0, 60.0, 89.999, 90.0}) {
      const double half_angle = theta0_deg * degree;
      const auto integral = [&](auto weight) {
        return Rule::integrate(
            [&](const Real& t) -> Real {
              const Real& turn = boost::math::constants::two_pi<Real>();
              return weight(t) *
                     (kind == JointKind::ball ? Real(turn * sin(t)) : Real(2));
            },
            Real(0), Real(half_angle));
      };
      const Real normal =
          integral([](const Real& t) -> Real { return cos(t) * cos(t); });
      const Real sum = integral([](const Real& t) -> Real { return cos(t); });
      const std::string row = label(law, half_angle);
      peak.add(Real(law.peak(half_angle)), Real(1 / normal), row);
      force.add(Real(law.force_ratio(half_angle)), Real(sum / normal), row);
      // cos theta = (1 - u)/(1 + u), u = b^2 (1 - x^2)
      const double x = 0.4;
      double found = 0;
      law.edge_slopes(half_angle, {&x, 1}, {&found, 1});
      const Real b = tan(Real(half_angle) / 2);
      const Real u = b * b * (1 - Real(x) * x);
      slope.add(Real(found), Real(4 * b * b * x / ((1 + u) * (1 + u)) / normal),
                row);
    }
  }
}

// The edge is at 90 deg.
TEST(WornPressure, IsTheCosinePressureAt90Degrees) {
  for (const JointKind kind : kinds) {
    const WornPressure worn(kind);
    const CosinePressure cosine(kind);
    const double edge = worn.largest_half_angle();
    for (const double t : {0.0, 0.4, 1.5}) {
      EXPECT_NEAR(worn.pressure(t, edge) / cosine.pressure(t, edge), 1, 1e-14);
    }
  }
}

TEST(SqrtPressures, BecomeHertz) {
  const double t = 1e-40;
  for (const char* name : {"sqrt_tan", "sqrt_theta", "mixture", "exact"}) {
    const auto ball =
        make_pressure_law(name, JointKind::ball, steel_in_polymer());
    const auto pin =
        make_pressure_law(name, JointKind::pin, steel_in_polymer());
    // Peak 3/2 and 4/pi of the mean. The expansion of the exact pressure is
    // off by 1e-11 at its end.
    EXPECT_NEAR(ball->peak(t) * 2 * pi / 3 * t * t, 1, 1e-11) << name;
    EXPECT_NEAR(pin->peak(t) * pi / 2 * t, 1, 1e-11) << name;
    EXPECT_NEAR(ball->pressure(0.6 * t, t) / ball->peak(t), 0.8, 1e-11);
    EXPECT_NEAR(pin->pressure(0.6 * t, t) / pin->peak(t), 0.8, 1e-11);
  }
}

// nu is 0.3 in the tables.
std::unique_ptr<PressureLaw> law_of_row(const std::string& name,
                                        const ReferenceTable::Row& row) {
  return make_pressure_law(
      name, row.text("joint") == "sphere" ? JointKind::ball : JointKind::pin,
      ElasticPair::from_modulus_ratio(row.value("Ebar"), 0.3, 0.3));
}

TEST(PressureLaw, ForceRatiosAndPeaksOfTheTable) {
  const struct {
    std::string law, column;
    double digit;
  } laws[] = {// Last printed digit: 6 decimals.
              {"cosine", "paper3.3", 6e-7},
              // And half-angles printed to 1e-4 deg: 9e-7 rad.
              {"sqrt_tan", "sqrt", 2e-6},
              {"sqrt_theta", "sqrt_theta", 2e-6}};
  const ReferenceTable table("conforming/pressure_friction.csv");
  for (const ReferenceTable::Row row : table) {
    const double half_angle = row.value("theta0_deg") * degree;
    for (const auto& [name, column, digit] : laws) {
      SCOPED_TRACE(row.label() + ", " + name);
      const auto law = law_of_row(name, row);
      EXPECT_NEAR(law->force_ratio(half_angle), row.value("S_" + column),
                  digit);
      EXPECT_NEAR(law->peak(half_angle), row.value("pmax_" + column), digit);
    }
  }
}

TEST(PressureLaw, AgreesWithTheTabulatedProfiles) {
  const struct {
    const char *law, *column;
    double budget;
  } laws[] = {
      // Angles are printed to 1e-4 deg: 5e-5 deg, 8.7e-7 rad, of both theta and
      // theta0 times a slope of at most 1 peak per rad there.
      {"cosine", "p_paper_3.3", 1.8e-6},
      // 1e-6 of the peak, and the rounding of half-angles to 1e-4 deg.
      {"exact", "p_exact*rho^2/Rn (sphere) or p*rho/P (cyl)", 3e-6}};
  const ReferenceTable table("conforming/pressure_profiles.csv");
  for (const auto& [name, column, budget] : laws) {
    AccuracyReport report(std::string(name) + " against profiles, of the peak",
                          budget);
    std::unique_ptr<PressureLaw> law;
    std::string last;
    for (const ReferenceTable::Row row : table) {
      const std::string key = row.text("joint") + row.text("Ebar");
      if (key != last) law = law_of_row(name, row);
      last = key;
      const double half_angle = row.value("theta0_deg") * degree;
      const double difference =
          law->pressure(row.value("theta_deg") * degree, half_angle) -
          row.value(column);
      report.add_error(std::abs(difference) / law->peak(half_angle),
                       row.label());
    }
  }
}

// A law's pressures and force ratio against the solver.
template <class Contact>
void compare(const ExactPressure& law, const Contact& solver, double half_angle,
             AccuracyReport& pressure, AccuracyReport& force) {
  const ContactPressure solved = solver.pressure(half_angle);
  for (double s = 0; s < 1; s += 0.037) {
    pressure.add_error(std::abs(law.pressure(s * half_angle, half_angle) -
                                solved.pressure(s * half_angle)) /
                           solved.peak(),
                       label(law, half_angle));
  }
  force.add(law.force_ratio(half_angle), solved.force_ratio(),
            label(law, half_angle));
}

// Both joints of a pair, with the law and with the solver.
struct SolvedPair {
  explicit SolvedPair(const ElasticPair& pair)
      : ball_contact(pair, InnerLoading::centre(), 32),
        pin_contact(pair, InnerLoading::centre(), 32),
        ball_law(JointKind::ball, pair),
        pin_law(JointKind::pin, pair) {}
  BallContact ball_contact;
  PinContact pin_contact;
  ExactPressure ball_law, pin_law;
};

TEST(ExactPressure, AgreesWithTheSolvers) {
  // 12 sines and three logarithms, worst for a rigid body on one with nu = 0.
  AccuracyReport ball("ball, over the peak", 1e-7);
  AccuracyReport pin("pin, over the peak", 1e-8);
  AccuracyReport force("force_ratio", 1e-8);
  for (const auto& [ratio, inner, outer] : {std::array{1.0, 0.3, 0.3},
                                            {0.0, 0.3, 0.3},
                                            {infinity, 0.3, 0.3},
                                            {0.0, 0.0, 0.3},
                                            {infinity, 0.3, 0.0},
                                            {0.02, 0.48, 0.2}}) {
    const auto pair = ElasticPair::from_modulus_ratio(ratio, inner, outer);
    const SolvedPair solved(pair);
    for (double theta0_deg = 0.05; theta0_deg < 120; theta0_deg *= 1.37) {
      const double half_angle = theta0_deg * degree;
      compare(solved.ball_law, solved.ball_contact, half_angle, ball, force);
      compare(solved.pin_law, solved.pin_contact, half_angle, pin, force);
    }
  }
}

TEST(ExactPressure, AgreesWithTheSolversBeyond120Degrees) {
  // 32 sines; nearest to where the solvers end 64 half-angles do not resolve
  // more.
  AccuracyReport ball("ball, over the peak", 2e-7);
  AccuracyReport pin("pin, over the peak", 2e-8);
  AccuracyReport force("force_ratio", 1e-7);
  for (const auto& [ratio, inner] : {std::array{0.0, 0.49},
                                     {0.0, 0.499},
                                     {1e-3, 0.5},
                                     {1e-2, 0.5},
                                     {0.0, 0.5}}) {
    const auto pair = ElasticPair::from_modulus_ratio(ratio, inner, 0.2);
    const SolvedPair solved(pair);
    for (double share = 0.02; share <= 1; share += 0.049) {
      compare(solved.ball_law, solved.ball_contact,
              share * solved.ball_law.largest_half_angle(), ball, force);
      compare(solved.pin_law, solved.pin_contact,
              share * solved.pin_law.largest_half_angle(), pin, force);
    }
  }
}

TEST(ExactPressure, LoadedThroughTheBack) {
  const auto pair = ElasticPair::from_modulus_ratio(0.2, 0.3, 0.35);
  const auto loading = InnerLoading::back(25 * degree);
  const BallContact ball_contact(pair, loading);
  const PinContact pin_contact(pair, loading, 32);
  const ExactPressure ball(JointKind::ball, pair, loading);
  const ExactPressure pin(JointKind::pin, pair, loading);
  const ExactPressure centre(JointKind::ball, pair);
  for (const double theta0_deg : {2.0, 40.0, 75.0}) {
    const double half_angle = theta0_deg * degree;
    // As for loads at the centre.
    EXPECT_NEAR(
        ball.peak(half_angle) / ball_contact.pressure(half_angle).peak(), 1,
        1e-5);
    EXPECT_NEAR(pin.peak(half_angle) / pin_contact.pressure(half_angle).peak(),
                1, 1e-5);
  }
  EXPECT_GT(std::abs(ball.peak(1.2) / centre.peak(1.2) - 1), 1e-3);
}

TEST(ExactPressure, FallsFromTheCentreToTheEdgeForAnyPair) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 60; ++i) {
    const double ratio = i < 6    ? 0
                         : i < 12 ? infinity
                                  : std::pow(10, 12 * uniform(random) - 6);
    const double inner = i % 7 == 0 ? 0.5 : 0.5 * uniform(random);
    const double outer = i % 5 == 0 ? 0.5 : 0.5 * uniform(random);
    const auto pair = ElasticPair::from_modulus_ratio(ratio, inner, outer);
    for (const JointKind kind : kinds) {
      const ExactPressure exact(kind, pair);
      const MixturePressure mixture(kind, pair);
      const double limit = ExactLaw(kind, pair).limit_half_angle();
      const double largest = std::min(limit, 120 * degree);
      for (double share = 1e-6; share <= 1; share *= 2) {
        const double half_angle = share * largest;
        for (const PressureLaw* law :
             std::initializer_list<const PressureLaw*>{&exact, &mixture}) {
          for (double x = 0; x <= 1; x += 0.05) {
            double slope = -1;
            law->edge_slopes(half_angle, {&x, 1}, {&slope, 1});
            EXPECT_GE(slope, 0) << label(*law, half_angle) << ' ' << ratio
                                << ' ' << inner << ' ' << outer;
          }
          EXPECT_GE(law->force_ratio(half_angle), 1 - 1e-9)
              << label(*law, half_angle) << ' ' << ratio << ' ' << inner << ' '
              << outer << ' ' << limit;
        }
      }
    }
  }
}

TEST(ExactPressure, IsTheClosedFormOfAPinOfEqualMaterials) {
  const ExactPressure law(JointKind::pin,
                          ElasticPair::from_modulus_ratio(1, 0.3, 0.3));
  // 12 terms, at 119 deg.
  AccuracyReport report("against the closed form, over the peak", 1e-9);
  for (const double theta0_deg : {0.1, 10.0, 50.0, 84.8, 119.0}) {
    const double half_angle = theta0_deg * degree;
    for (double s = 0; s < 1; s += 0.05) {
      report.add_error(
          std::abs(law.pressure(s * half_angle, half_angle) -
                   PinClosedForm::pressure(s * half_angle, half_angle)) /
              law.peak(half_angle),
          label(law, half_angle));
    }
  }
}

TEST(ExactPressure, ReachesTheLimitOfNearlyIncompressibleBodies) {
  for (const JointKind kind : kinds) {
    const auto pair = ElasticPair::from_modulus_ratio(0, 0.49, 0.3);
    const ExactPressure law(kind, pair);
    const double limit = ExactLaw(kind, pair).limit_half_angle();
    EXPECT_GT(limit, 120 * degree);
    EXPECT_DOUBLE_EQ(law.largest_half_angle(), limit);
    EXPECT_GT(law.peak(limit), 0);
  }
}

TEST(MixturePressure, IsWithinItsErrorsOfTheExactPressure) {
  // Pairs that are not on the grid of the fit; docs/explanation/pressure.md.
  AccuracyReport ball_sum("S, ball", 0.012);
  AccuracyReport ball_peak("peak, ball", 0.04);
  AccuracyReport pin_sum("S, pin", 0.001);
  AccuracyReport pin_peak("peak, pin", 0.008);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto compare = [&](const ElasticPair& pair) {
    for (const JointKind kind : kinds) {
      const bool ball = kind == JointKind::ball;
      const ExactPressure exact(kind, pair);
      const MixturePressure mixture(kind, pair);
      const double limit = std::min(ExactLaw(kind, pair).limit_half_angle(),
                                    exact.largest_half_angle());
      for (double share = 0.05; share <= 1; share += 0.05) {
        const double half_angle = share * limit;
        (ball ? ball_sum : pin_sum)
            .add(mixture.force_ratio(half_angle), exact.force_ratio(half_angle),
                 label(mixture, half_angle));
        (ball ? ball_peak : pin_peak)
            .add(mixture.peak(half_angle), exact.peak(half_angle),
                 label(mixture, half_angle));
      }
    }
  };
  for (int i = 0; i < 200; ++i) {
    // The first ones with a rigid body.
    const double ratio = i < 10   ? 0
                         : i < 20 ? infinity
                                  : std::pow(10, 6 * uniform(random) - 3);
    compare(ElasticPair::from_modulus_ratio(ratio, 0.5 * uniform(random),
                                            0.5 * uniform(random)));
  }
  // Pairs whose contacts reach beyond 120 deg.
  for (const double ratio : {0.0, 1e-3, 1e-2}) {
    for (const double nu : {0.48, 0.49, 0.499, 0.5}) {
      compare(ElasticPair::from_modulus_ratio(ratio, nu, 0.3));
    }
  }
}

TEST(MixturePressure, CoefficientsAreThoseOfTheFit) {
  for (const JointKind kind : kinds) {
    const auto fit = reference::fit_pressure_mixture(kind);
    const auto& c =
        kind == JointKind::ball ? detail::ball_mixture : detail::pin_mixture;
    // The powers of the sine are nearly dependent: changes of S by 1e-8 move
    // coefficients by 1e-3 and the weight by far less. The coefficients are
    // printed to four decimals.
    for (double h = 0.02; h < 0.87; h += 0.05) {
      double equal = 0;
      double contrast = 0;
      for (int k = detail::mixture_terms - 1; k >= 0; --k) {
        equal = (equal + c.equal[k] - fit.equal[k]) * h;
        contrast = (contrast + c.contrast[k] - fit.contrast[k]) * h;
      }
      EXPECT_NEAR(equal, 0, 5e-4) << h;
      EXPECT_NEAR(contrast, 0, 5e-4) << h;
    }
  }
}

// Hertz' formulas in the radii of both bodies and Young's moduli, in 50 digits.
TEST(HertzPeakPressure, IsThatOfBothRadii) {
  const ElasticPair pair({207e9, 0.292}, {111e9, 0.349});
  const Real modulus = 1 / ((1 - Real(0.292) * 0.292) / 207e9 +
                            (1 - Real(0.349) * 0.349) / 111e9);
  const Real& pi50 = boost::math::constants::pi<Real>();
  // Roundings of the load parameter, of theta0 and of the peak.
  AccuracyReport error("hertz_peak_pressure", 2e-15);
  AccuracyReport width("rho sin(theta0)", 2e-15);
  const auto compare = [&](const JointGeometry& joint, double load,
                           const Real& half_width, const Real& expected) {
    const HertzLaw law(joint.kind());
    const double theta0 =
        law.half_angle(law.load_factor(joint.relative_clearance()) *
                       LoadScale(joint, pair).load_parameter(load))
            .half_angle;
    width.add(sin(Real(theta0)) * joint.radius(), half_width,
              to_string(joint.kind()));
    error.add(Real(hertz_peak_pressure(joint, load, theta0)), expected,
              to_string(joint.kind()));
  };
  const double radius = 0.25;
  for (const double clearance : {1. / 65536, 1. / 1024, 1. / 128, 1. / 8}) {
    const Real curvature =
        1 / Real(radius) - 1 / (Real(radius) + Real(clearance));
    for (const double load : {1.0, 1024.0, 65536.0}) {
      const Real a = cbrt(3 * load / (4 * modulus * curvature));
      compare(JointGeometry::ball(radius, clearance), load, a,
              3 * load / (2 * pi50 * a * a));
      const Real b = sqrt(4 * load / (pi50 * modulus * curvature));
      compare(JointGeometry::pin(radius, clearance, 0.5), load, b,
              2 * load / (pi50 * b));
    }
  }
  EXPECT_DOUBLE_EQ(hertz_peak_over_nominal(JointKind::ball, pi / 6), 6);
  EXPECT_DOUBLE_EQ(hertz_peak_over_nominal(JointKind::pin, pi / 6), 8 / pi);
}

TEST(ContactNotes, SayWhereTheSeatEnds) {
  const ElasticPair pair({2e11, 0.3}, {1e11, 0.3});
  const auto law = make_half_angle_law("tanh", JointKind::ball, pair, {});
  const auto whole = JointGeometry::ball(0.033, 1e-5);
  const auto notes = [&](const JointGeometry& geometry, double half_angle) {
    return ContactLimits(*law, pair, geometry).notes({half_angle, 0});
  };
  const auto ring = whole.with_seat(SeatZone::ring(0.028, 0.033));
  EXPECT_TRUE(notes(whole, 0.5).empty());
  EXPECT_TRUE(notes(ring, 0.43).empty());
  EXPECT_EQ(notes(ring, 0.5),
            std::vector<std::string>{
                "half-angle 28.65 deg is beyond 25.1 deg, where a contact in "
                "the middle of the seat reaches a rim: the contact is not "
                "confined here, and the printed pressures are too low"});
  // A cup has one rim; what has none ends nowhere.
  EXPECT_TRUE(notes(whole.with_seat(SeatZone::cup(1)), 0.99).empty());
  EXPECT_EQ(notes(whole.with_seat(SeatZone::cup(1)), 1.01).size(), 1u);
  EXPECT_TRUE(notes(whole.with_seat(SeatZone(0, std::numbers::pi)), 1).empty());
  // Other clearances leave the seat unchanged.
  EXPECT_EQ(ring.with_clearance(2e-5).seat(), ring.seat());
  // A joint that leaves the seat out says the same.
  const auto endless = ring.without_seat().with_clearance(2e-5);
  EXPECT_FALSE(endless.seat());
  EXPECT_EQ(notes(endless, 0.5), notes(ring, 0.5));
  EXPECT_EQ(endless.without_seat().drawn_seat(), ring.seat());
  EXPECT_EQ(ring.without_seat(), whole);
  EXPECT_ERROR(JointGeometry::pin(1, 0.1, 1).with_seat(SeatZone::cup(1)),
               "a seat that ends requires a ball joint");
}

TEST(ContactNotes, SayWhereTheTheoryAndTheMaterialsEnd) {
  Material polymer{1e9, 0.4, "polymer"};
  polymer.limit_pressure = 2e7;
  const ElasticPair pair({2e11, 0.3}, polymer);
  const ContactLimits limits(
      *make_half_angle_law("tanh", JointKind::ball, pair, {}), pair);
  const auto notes = [&](double half_angle, double peak) {
    return limits.notes({half_angle, peak});
  };
  EXPECT_EQ(limits.peak_pressure(), 2e7);
  EXPECT_TRUE(notes(0.5, 2e7).empty());
  EXPECT_TRUE(notes(nan, nan).empty());
  ASSERT_EQ(notes(0.5, 3e7).size(), 1u);
  EXPECT_EQ(notes(0.5, 3e7)[0],
            "peak pressure 30 MPa is above 20 MPa, the limit pressure of the "
            "outer body, polymer");
  EXPECT_EQ(limits.passed({0.5, 3e7}),
            std::vector<std::string>{"peak pressure above 20 MPa, the limit "
                                     "pressure of the outer body, polymer"});
  EXPECT_TRUE(limits.passed({0.5, 2e7}).empty());
  EXPECT_EQ(notes(0.5, 5e7).size(), 1u);
  ASSERT_EQ(notes(0.5, 2.65e9).size(), 2u);
  EXPECT_EQ(notes(0.5, 2.65e9)[0],
            "peak pressure 2650 MPa is above 50 MPa, 5 % of the smaller "
            "Young's modulus: linear elasticity does not hold");
  const double limit = ExactLaw(JointKind::ball, pair).limit_half_angle();
  EXPECT_TRUE(notes(limit, 1).empty());
  ASSERT_EQ(notes(1.01 * limit, 1).size(), 1u);
  EXPECT_NE(notes(1.01 * limit, 1)[0].find("the limit half-angle"),
            std::string::npos);
}

// Layers under the surface have limits too, once the contact is as wide as they
// are deep; the exact law then gives the half-angle.
TEST(ContactNotes, SayWhatTheLayersBelowBear) {
  const Material steel{2.1e11, 0.3, "steel"};
  Material polymer{1e9, 0.4, "polymer"};
  polymer.limit_pressure = 2e7;
  const ElasticPair pair(steel, steel);
  const auto notes = [&](const LayeredPair& walls, double half_angle,
                         double peak) {
    const ExactLaw law(JointKind::ball, walls);
    return ContactLimits(law, pair).notes({half_angle, peak});
  };
  const LayeredPair inlay(0.02, {{}, Backing::medium(steel)},
                          {{{1e-3, steel}, {8e-3, polymer}}, Backing::rigid()});
  EXPECT_TRUE(notes(inlay, 0.049, 3e7).empty());
  EXPECT_TRUE(notes(inlay, 0.051, 2e7).empty());
  const auto passed = notes(inlay, 0.051, 6e7);
  ASSERT_EQ(passed.size(), 2u);
  EXPECT_EQ(passed[0],
            "peak pressure 60 MPa is above 20 MPa, the limit pressure of the "
            "outer body 1 mm under the contact, polymer: the pressure there is "
            "lower, but not computed");
  EXPECT_EQ(
      passed[1].substr(0, 68),
      "peak pressure 60 MPa is above 50 MPa, 5 % of Young's modulus of the ");
  // A backing, and the core under a coating.
  const LayeredPair backed(0.02, {{}, Backing::medium(steel)},
                           {{{1e-3, steel}}, Backing::medium(polymer)});
  EXPECT_EQ(notes(backed, 0.051, 3e7).size(), 1u);
  const LayeredPair coated(0.02, {{{1e-3, steel}}, Backing::medium(polymer)},
                           {{}, Backing::medium(steel)});
  ASSERT_EQ(notes(coated, 0.051, 3e7).size(), 1u);
  EXPECT_NE(notes(coated, 0.051, 3e7)[0].find("the inner body 1 mm under"),
            std::string::npos);
}

// Walls whose pressure the unknowns do not resolve.
TEST(ContactNotes, SayWhereWallsAreTooThin) {
  const Material steel{2.1e11, 0.3};
  const Material rubber{5e7, 0.49};
  const auto notes = [&](double thickness, const Backing& backing) {
    const LayeredPair walls(0.02, {{}, Backing::medium(steel)},
                            {{{thickness * 0.02, steel}}, backing});
    return ExactLaw(JointKind::pin, walls).validity_notes({steel, steel});
  };
  EXPECT_TRUE(notes(0.0021, Backing::held()).empty());
  ASSERT_EQ(notes(0.0019, Backing::held()).size(), 1u);
  EXPECT_EQ(notes(0.0019, Backing::held())[0].substr(0, 21),
            "a free ring of 0.0019");
  EXPECT_TRUE(notes(0.0011, Backing::medium(rubber)).empty());
  ASSERT_EQ(notes(0.0009, Backing::medium(rubber)).size(), 1u);
  EXPECT_EQ(notes(0.0009, Backing::medium(rubber))[0],
            "a skin of 0.0009 radii on a body 4.2e+03 times softer: its peak "
            "pressure is not resolved, some 1.3 % too high; the half-angle "
            "holds");
  EXPECT_TRUE(notes(0.0009, Backing::medium({5e9, 0.3})).empty());
  // Real coatings: DLC of 2 um on PEEK is right to 0.3 %, on UHMWPE to 1.3 %.
  EXPECT_TRUE(notes(2e-4, Backing::medium({3.8e9, 0.4})).empty());
  EXPECT_EQ(notes(2e-4, Backing::medium({1e9, 0.4})).size(), 1u);
}

// A pin of 25 mm: where its contact is wider than the eye of a lug is long it
// is in neither plane strain nor plane stress, but for a liner that is bonded.
TEST(ContactNotes, SayWherePinsAreShort) {
  const Material steel{2.1e11, 0.3};
  const Material polymer{1e9, 0.4};
  const auto notes = [&](double length, const LayeredBody& outer,
                         double half_angle) {
    const LayeredPair walls(0.0125, {{}, Backing::medium(steel)}, outer);
    const ExactLaw law(JointKind::pin, walls);
    return ContactLimits(law, walls.surfaces(),
                         JointGeometry::pin(0.0125, 3e-5, length))
        .notes({half_angle, 0});
  };
  const LayeredBody lug{{{0.0125, steel}}, Backing::held()};
  const double wide = std::asin(12. / 25);
  EXPECT_TRUE(notes(0.012, lug, wide - 1e-6).empty());
  EXPECT_EQ(
      notes(0.012, lug, 30 * degree),
      std::vector<std::string>{
          "half-angle 30 deg is beyond 28.69 deg, where the contact is "
          "wider than the pin is long, 12 mm: it is between plane_state "
          "= \"strain\" and \"stress\", whose peaks differ by some 5 % and "
          "stiffnesses by 10 %"});
  EXPECT_TRUE(notes(0.025, lug, 80 * degree).empty());
  // Liners thinner and thicker than half of the length, and one on a body as
  // soft.
  const auto liner = [&](double thickness, const Backing& backing) {
    return LayeredBody{{{thickness, polymer}}, backing};
  };
  EXPECT_TRUE(notes(0.012, liner(0.003, Backing::rigid()), 0.6).empty());
  EXPECT_TRUE(notes(0.012, liner(0.003, Backing::medium(steel)), 0.6).empty());
  EXPECT_EQ(notes(0.012, liner(0.007, Backing::rigid()), 0.6).size(), 1u);
  EXPECT_EQ(notes(0.012, liner(0.003, Backing::medium(polymer)), 0.6).size(),
            1u);
  // Bodies without walls.
  const ElasticPair pair(steel, steel);
  EXPECT_EQ(ContactLimits(FittedLaw(JointKind::pin, pair), pair,
                          JointGeometry::pin(0.0125, 3e-5, 0.012))
                .notes({0.6, 0})
                .size(),
            1u);
}

// A law that knows its joint does not leave it: walls, loading and wear widen
// contacts beyond the limit of infinite bodies.
TEST(ContactNotes, ALawThatKnowsItsJointHasItsLimit) {
  const Material steel{2.1e11, 0.3};
  const Material liner{3e9, 0.3};
  const ElasticPair pair(steel, liner);
  const LayeredPair walls(0.01, {{}, Backing::medium(steel)},
                          {{{1e-3, liner}}, Backing::rigid()});
  const double infinite = FittedLaw(JointKind::ball, pair).limit_half_angle();
  const auto lined = std::make_shared<ExactLaw>(JointKind::ball, walls);
  const double limit = lined->limit_half_angle();
  ASSERT_GT(limit, 1.05 * infinite);
  const auto notes = [&pair](const HalfAngleLaw& law, double angle) {
    return ContactLimits(law, pair).notes({angle, 0});
  };
  EXPECT_TRUE(notes(*lined, limit).empty());
  ASSERT_EQ(notes(*lined, 1.01 * limit).size(), 1u);
  EXPECT_NE(notes(*lined, 1.01 * limit)[0].find(
                " deg, the limit half-angle of this joint"),
            std::string::npos);
  EXPECT_EQ(notes(FittedLaw(JointKind::ball, pair), limit).size(), 1u);

  const WornHalfAngle worn(std::make_shared<FittedLaw>(JointKind::ball, pair),
                           20);
  const double widened = worn.half_angle(1e9).half_angle;
  ASSERT_GT(widened, 1.01 * infinite);
  EXPECT_TRUE(notes(worn, widened).empty());
}

}  // namespace
}  // namespace contact::test::family_test
