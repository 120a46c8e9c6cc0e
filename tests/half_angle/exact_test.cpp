#include "libcontact/half_angle/exact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/reference_table.hpp"

namespace {

using namespace contact;
using contact::test::AccuracyReport;
using contact::test::ReferenceTable;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr JointKind kinds[] = {JointKind::ball, JointKind::pin};

struct Pair {
  double ratio, nu1, nu2;
  ElasticPair elastic() const {
    return ElasticPair::from_modulus_ratio(ratio, nu1, nu2);
  }
};

// Both ends and the middle of everything; on both sides of the switches of
// the number of terms (theta0* = 95 and 138 deg).
constexpr Pair pairs[] = {
    {1, 0.3, 0.3},   {1, 0.3, 0.2},       {0, 0.3, 0.3}, {infinity, 0.3, 0},
    {0, 0.2, 0.2},   {0.3, 0, 0.5},       {1, 0, 0.5},   {1, 0.5, 0},
    {0, 0.33, 0.3},  {0, 0.45, 0.3},      {0, 0.49, 0},  {0.01, 0.49, 0.2},
    {1e-6, 0.3, 0},  {100, 0.5, 0.5},     {1e6, 0.2, 0}, {0.02, 0.32, 0.3},
    {0, 0.497, 0.3}, {0.001, 0.499, 0.3},
};

std::string label(const HalfAngleLaw& law, const Pair& pair, double load) {
  return to_string(law.joint_kind()) + ", Ebar " + std::to_string(pair.ratio) +
         ", nu " + std::to_string(pair.nu1) + " " + std::to_string(pair.nu2) +
         ", load " + std::to_string(load);
}

// What the law tabulates.
ExactHalfAngle solver(JointKind kind, const Pair& pair, double load) {
  const ElasticPair elastic = pair.elastic();
  if (kind == JointKind::ball) return BallContact(elastic).half_angle(load);
  if (std::abs(elastic.dundurs_beta()) <= 1e-15) {
    return PinClosedForm(elastic.outer_compliance_share()).half_angle(load);
  }
  const PinContact pin(elastic);
  if (pin.limit_half_angle().status == Status::ok) return pin.half_angle(load);
  return PinContact(elastic, InnerLoading::centre(), 32).half_angle(load);
}

TEST(ExactLaw, IsTheSolver) {
  // The series' truncation, beside the solver's rounding.
  AccuracyReport pin("pin, theta0 against the solver, deg", 1e-11);
  AccuracyReport ball("ball, theta0 against the solver, deg", 1e-8);
  for (const JointKind kind : kinds) {
    for (const Pair& pair : pairs) {
      const ExactLaw law(kind, pair.elastic());
      EXPECT_TRUE(law.validity_notes(pair.elastic()).empty());
      for (double load = 1e-15; load < 2e8; load *= 6.7) {
        const HalfAngleResult result = law.half_angle(load);
        EXPECT_EQ(result.status, Status::ok);
        (kind == JointKind::ball ? ball : pin)
            .add_error(std::abs(result.half_angle -
                                solver(kind, pair, load).half_angle) /
                           degree,
                       label(law, pair, load));
      }
    }
  }
  pin.check();
  ball.check();
}

TEST(ExactLaw, ReproducesTheReferenceTables) {
  const auto compare = [](const char* file, const char* load_column,
                          JointKind kind, AccuracyReport report) {
    const ReferenceTable table(file);
    double ratio = nan;
    std::unique_ptr<ExactLaw> law;
    for (const ReferenceTable::Row row : table) {
      if (row.value("Ebar") != ratio) {
        ratio = row.value("Ebar");
        law = std::make_unique<ExactLaw>(kind, Pair{ratio, 0.3, 0.3}.elastic());
      }
      // Tenths of decades, printed with six digits.
      const double load = std::pow(
          10, std::round(10 * std::log10(row.value(load_column))) / 10);
      report.add_error(std::abs(law->half_angle(load).half_angle / degree -
                                row.value("theta0_deg")),
                       row.label());
    }
    report.check();
  };
  // Five decimals are printed; the tables' own accuracy is theirs.
  compare("conforming/cylinder_theta0.csv", "lambda", JointKind::pin,
          AccuracyReport("pin, theta0 against the table, deg", 1e-5));
  compare("conforming/sphere_theta0.csv", "mu", JointKind::ball,
          AccuracyReport("ball, theta0 against the table, deg", 1e-4));
}

TEST(ExactLaw, RoundTripsUpToTheLimit) {
  AccuracyReport angle_report("theta0 -> load -> theta0", 1e-13);
  // The law's load is the solver's, and near the limit the law's own nearness
  // to it counts: theta0* is known to 1e-14 of itself.
  AccuracyReport load_report("load(theta0) against the solver's", 1e-9);
  for (const JointKind kind : kinds) {
    for (const Pair& pair : pairs) {
      const ExactLaw law(kind, pair.elastic());
      const double limit = law.limit_half_angle();
      for (const double angle :
           {1e-12, 1e-4 * degree, 0.01, 0.3, 1.0, 1.3, limit - 0.01,
            limit - 1e-3 * degree, limit - 1e-9, std::nextafter(limit, 0)}) {
        if (angle > limit) continue;
        const LoadParameterResult load = law.load_parameter(angle);
        ASSERT_EQ(load.status, Status::ok);
        EXPECT_GT(load.load_parameter, 0);
        const HalfAngleResult back = law.half_angle(load.load_parameter);
        EXPECT_EQ(back.status, Status::ok);
        angle_report.add(back.half_angle, angle, label(law, pair, angle));
        // (A closed form near 180 deg or a solver beyond 120 deg is its own
        // limit.)
        if (limit > 2.1 || angle > limit - 1e-4) continue;
        const double solved = kind == JointKind::ball
                                  ? BallContact(pair.elastic())
                                        .load_parameter(angle)
                                        .load_parameter
                                  : PinContact(pair.elastic())
                                        .load_parameter(angle)
                                        .load_parameter;
        load_report.add(load.load_parameter, solved, label(law, pair, angle));
      }
    }
  }
  angle_report.check();
  load_report.check();
}

TEST(ExactLaw, LogSlopeIsTheDerivative) {
  // Central difference over +-1e-4 in ln(load): 1e-8/6 of the third
  // derivative, and rounding 1e-16/1e-4.
  AccuracyReport report("dln(theta0)/dln(load), absolute", 1e-8);
  for (const JointKind kind : kinds) {
    for (const Pair& pair : pairs) {
      const ExactLaw law(kind, pair.elastic());
      for (double load = 1e-12; load < 1e10; load *= 9.1) {
        const double h = 1e-4;
        const auto log_angle = [&](double shift) {
          return std::log(law.half_angle(load * std::exp(shift)).half_angle);
        };
        report.add_error(std::abs((log_angle(h) - log_angle(-h)) / (2 * h) -
                                  law.half_angle(load).log_slope),
                         label(law, pair, load));
      }
    }
  }
  report.check();
}

TEST(ExactLaw, Limits) {
  for (const JointKind kind : kinds) {
    const double exponent = kind == JointKind::ball ? 1.0 / 3 : 0.5;
    for (const Pair& pair : pairs) {
      const ExactLaw law(kind, pair.elastic());
      const double limit = law.limit_half_angle();
      EXPECT_EQ(law.half_angle(0).half_angle, 0);
      EXPECT_EQ(law.half_angle(0).log_slope, exponent);
      EXPECT_EQ(law.load_parameter(0).load_parameter, 0);
      EXPECT_EQ(law.half_angle(infinity).half_angle, limit);
      EXPECT_EQ(law.half_angle(infinity).log_slope, 0);
      EXPECT_EQ(law.load_parameter(limit).load_parameter, infinity);
      // Hertz as the load tends to 0: the next term is below x (|beta| <= 1/2
      // and the like).
      for (const double load : {5e-324, 1e-200, 1e-40, 1e-12}) {
        const double x = x_from_load_parameter(kind, load);
        const HalfAngleResult result = law.half_angle(load);
        EXPECT_NEAR(result.half_angle / x, 1, x + 8 * epsilon) << load;
        EXPECT_NEAR(result.log_slope, exponent, x + 1e-14) << load;
      }
      // From below, and in the end there.
      double last = 0;
      for (double load = 1e-300; load < 1e300; load *= 1e6) {
        const auto [angle, status, log_slope] = law.half_angle(load);
        EXPECT_EQ(status, Status::ok);
        EXPECT_GE(log_slope, 0);
        EXPECT_GE(angle, last) << load;
        EXPECT_LE(angle, limit) << load;
        last = angle;
      }
      EXPECT_NEAR(law.half_angle(1e300).half_angle, limit, 1e-14 * limit);
    }
  }
  // A pin of incompressible material in a rigid hole closes up.
  EXPECT_EQ(
      ExactLaw(JointKind::pin, Pair{0, 0.5, 0.3}.elastic()).limit_half_angle(),
      180 * degree);
}

// The law gives the same on both sides of |beta| = 1e-15, where the closed
// form takes over from the solver, and for loads on both sides of 1.
TEST(ExactLaw, BranchesMeet) {
  const auto angle = [](double nu2, double load) {
    return ExactLaw(JointKind::pin, Pair{1, 0.3, nu2}.elastic())
        .half_angle(load)
        .half_angle;
  };
  for (const double load : {1e-6, 0.1, 2.0, 1e4}) {
    // dtheta0/dnu2 is below 1; the solver's budget is 1e-9 deg.
    EXPECT_NEAR(angle(0.3, load), angle(0.3 + 1e-13, load), 2e-11);
    EXPECT_NEAR(angle(0.3, load), angle(0.3 - 1e-13, load), 2e-11);
  }
}

TEST(ExactLaw, EndsWhereTheSolverEnds) {
  const struct {
    JointKind kind;
    Pair pair;
    double end_deg;
  } cases[] = {{JointKind::pin, {1e-6, 0.5, 0.3}, 163.57},
               {JointKind::ball, {0, 0.5, 0.3}, 175}};
  for (const auto& [kind, pair, end_deg] : cases) {
    const ExactLaw law(kind, pair.elastic());
    const double end = law.limit_half_angle();
    EXPECT_NEAR(end / degree, end_deg, 0.01);
    EXPECT_EQ(law.validity_notes(pair.elastic()).size(), 1U);
    const double load = law.load_parameter(end).load_parameter;
    EXPECT_GT(load, 1e3);
    // At the end theta0 hardly moves with the load: both sides of it.
    EXPECT_EQ(law.half_angle(0.9 * load).status, Status::ok);
    EXPECT_LT(law.half_angle(0.9 * load).half_angle, end);
    for (const double beyond : {1.1 * load, 1e30, infinity}) {
      EXPECT_EQ(law.half_angle(beyond).status, Status::not_converged);
      EXPECT_EQ(law.half_angle(beyond).half_angle, end);
    }
    EXPECT_EQ(law.half_angle(nan).status, Status::out_of_range);
  }
}

// docs/fitted_laws.md, "The extremes": rigid bodies, nu from 0 to 0.5, Ebar
// from 1e-6 to 1e6, half-angles from 1e-4 deg to 1e-3 deg from the limit, loads
// to 1e8. Only nearly incompressible inner bodies in nearly rigid outer ones
// end before their limit.
TEST(ExactLaw, ReachesTheExtremes) {
  // At 175 deg F is 1e-7, which leaves theta0 nine digits.
  AccuracyReport report("extremes, theta0 -> load -> theta0", 1e-10);
  int ends = 0;
  for (const JointKind kind : kinds) {
    for (const double ratio : {0.0, 1e-6, 1e-3, 1.0, 1e3, 1e6, infinity}) {
      for (const double nu1 : {0.0, 0.3, 0.49, 0.5}) {
        for (const double nu2 : {0.0, 0.3, 0.49, 0.5}) {
          const Pair pair{ratio, nu1, nu2};
          const ExactLaw law(kind, pair.elastic());
          const bool ends_early = !law.validity_notes(pair.elastic()).empty();
          ends += ends_early;
          // A pin that closes up exactly (beta = 0) has its closed form.
          const bool incompressible_in_rigid =
              nu1 == 0.5 &&
              (kind == JointKind::ball ? ratio == 0
                                       : ratio == 1e-6 && nu2 != 0.5);
          EXPECT_EQ(ends_early, incompressible_in_rigid) << label(law, pair, 0);
          const double limit = law.limit_half_angle();
          for (const double angle :
               {1e-4 * degree, 1.0, limit - 1e-3 * degree}) {
            const LoadParameterResult load = law.load_parameter(angle);
            ASSERT_EQ(load.status, Status::ok);
            const HalfAngleResult back = law.half_angle(load.load_parameter);
            EXPECT_EQ(back.status, Status::ok) << label(law, pair, angle);
            report.add(back.half_angle, angle, label(law, pair, angle));
          }
          if (ends_early) continue;
          const HalfAngleResult far = law.half_angle(1e8);
          EXPECT_EQ(far.status, Status::ok);
          EXPECT_LT(far.half_angle, limit);
          // theta0* - theta0 falls like 1/load (where the contact closes up
          // like its fourth root).
          EXPECT_GT(far.half_angle, limit - (limit < 2.4 ? 1e-6 : 0.1));
        }
      }
    }
  }
  EXPECT_EQ(ends, 7);
  report.check();
}

TEST(ExactLaw, LoadThroughTheBack) {
  const ElasticPair pair = Pair{0, 0.3, 0.3}.elastic();
  const InnerLoading loading = InnerLoading::back(20 * degree);
  const ExactLaw ball(JointKind::ball, pair, loading);
  const ExactLaw pin(JointKind::pin, pair, loading);
  for (const double load : {1e-4, 0.1, 3.0, 40.0}) {
    EXPECT_NEAR(ball.half_angle(load).half_angle,
                BallContact(pair, loading).half_angle(load).half_angle,
                1e-8 * degree);
    EXPECT_NEAR(pin.half_angle(load).half_angle,
                PinContact(pair, loading).half_angle(load).half_angle,
                1e-11 * degree);
  }
  EXPECT_NEAR(ball.half_angle(3).half_angle / degree, 73.13, 0.005);

  for (const JointKind kind : kinds) {
    const auto made =
        contact::make_half_angle_law("exact", kind, pair, {}, {loading});
    EXPECT_EQ(made->half_angle(3).half_angle,
              (kind == JointKind::ball ? ball : pin).half_angle(3).half_angle);
  }
  for (const std::string& name : contact::half_angle_law_names()) {
    EXPECT_TRUE(contact::half_angle_law_allows(name, {}));
    EXPECT_EQ(contact::half_angle_law_allows(name, {loading}), name == "exact");
    if (name == "exact") continue;
    EXPECT_EQ(contact::test::error_message([&] {
                contact::make_half_angle_law(name, JointKind::ball, pair, {},
                                             {loading});
              }),
              "half-angle law " + name + " must be exact with loading back:20");
  }
}

TEST(ExactLaw, ApproachOfInfiniteSeats) {
  AccuracyReport approach("approach", 1e-6);
  AccuracyReport stiffness("stiffness", 1e-6);
  for (const Pair& pair : pairs) {
    const BallContact contact(pair.elastic());
    const ExactLaw law(JointKind::ball, pair.elastic());
    const double limit = law.limit_half_angle();
    for (const double theta0 : {1e-5, 1e-3, 0.03, 0.4, 1.2, 0.97 * limit}) {
      const ContactApproach near = law.approach(theta0);
      const ContactApproach solved = contact.approach(theta0);
      const std::string text = label(law, pair, theta0);
      approach.add(near.approach, solved.approach, text);
      stiffness.add(near.stiffness, solved.stiffness, text);
    }
    for (const double bad : {nan, -1.0, 0.0, 1.001 * limit}) {
      EXPECT_TRUE(std::isnan(law.approach(bad).approach));
      EXPECT_TRUE(std::isnan(law.approach(bad).stiffness));
    }
  }
  approach.check();
  stiffness.check();
}

TEST(ExactLaw, NoApproach) {
  // Of a pin in an infinite hole, loaded through the back, of other laws.
  const ElasticPair pair = pairs[1].elastic();
  const InnerLoading back = InnerLoading::back(0.3);
  const ExactLaw pin(JointKind::pin, pair);
  const ExactLaw roller(JointKind::pin, pair, back);
  const ExactLaw ball(JointKind::ball, pair, back);
  const auto fitted = make_half_angle_law("fitted", kinds[0], pair);
  const std::initializer_list<const HalfAngleLaw*> laws = {&pin, &roller, &ball,
                                                           fitted.get()};
  for (const HalfAngleLaw* law : laws) {
    EXPECT_TRUE(std::isnan(law->approach(0.5).approach));
    EXPECT_TRUE(std::isnan(law->approach(0.5).stiffness));
  }
}

TEST(InnerLoading, Text) {
  EXPECT_EQ(to_string(InnerLoading::centre()), "centre");
  EXPECT_EQ(to_string(InnerLoading::back(0)), "back:0");
  EXPECT_EQ(to_string(InnerLoading::back(22.5 * degree)), "back:22.5");
  EXPECT_EQ(InnerLoading::back(0.1), InnerLoading::back(0.1));
  EXPECT_NE(InnerLoading::back(0), InnerLoading::centre());
}

TEST(ExactLaw, OneLawServesManyThreads) {
  const ExactLaw law(JointKind::ball, Pair{0.5, 0.3, 0.4}.elastic());
  const auto sum = [&law] {
    double total = 0;
    for (double load = 1e-3; load < 1e3; load *= 1.01) {
      const double half_angle = law.half_angle(load).half_angle;
      total += half_angle + law.approach(half_angle).stiffness;
    }
    return total;
  };
  std::vector<double> sums(4);
  {
    std::vector<std::jthread> threads;
    for (double& s : sums) threads.emplace_back([&s, &sum] { s = sum(); });
  }
  const double expected = sum();
  for (const double s : sums) EXPECT_EQ(s, expected);
}

}  // namespace
