#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "support/accuracy_report.hpp"
#include "support/elastic_cases.hpp"
#include "support/error_message.hpp"
#include "support/long_run.hpp"
#include "support/numbers.hpp"
#include "support/wall.hpp"

namespace contact::test::exact_test {
namespace {

constexpr const auto& pairs = exact_pairs;
// Ratios of moduli in the reference tables.
constexpr double table_ratios[] = {0, 0.01, 0.1, 0.5, 1, 2, 10, 100};

std::string label(const HalfAngleLaw& law, const PairCase& pair, double load) {
  return to_string(law.joint_kind()) + ", " + pair.label() + ", load " +
         std::to_string(load);
}

// Solution that the law tabulates.
ExactHalfAngle solver(JointKind kind, const PairCase& pair, double load) {
  const ElasticPair elastic = pair.elastic();
  if (kind == JointKind::ball) return BallContact(elastic).half_angle(load);
  if (std::abs(elastic.dundurs_beta()) <= 1e-15) {
    return PinClosedForm(elastic.outer_compliance_share()).half_angle(load);
  }
  const PinContact pin(elastic);
  if (pin.limit_half_angle().status == Status::ok) return pin.half_angle(load);
  return PinContact(elastic, InnerLoading::centre(), 32).half_angle(load);
}

// So that it reproduces what they reproduce (tests/conforming).
TEST(ExactLaw, IsTheSolver) {
  // Truncation of the series, in addition to the solver's rounding.
  AccuracyReport pin("pin, theta0 against the solver, deg", 1e-11);
  AccuracyReport ball("ball, theta0 against the solver, deg", 1e-8);
  std::vector<PairCase> all(std::begin(pairs), std::end(pairs));
  for (const double ratio : table_ratios) all.push_back({ratio, 0.3, 0.3});
  for (const JointKind kind : kinds) {
    for (const PairCase& pair : all) {
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
}

TEST(ExactLaw, RoundTripsUpToTheLimit) {
  AccuracyReport angle_report("theta0 -> load -> theta0", 1e-13);
  // The law's load is the solver's, and near the limit the law's own nearness
  // to it counts: theta0* is known to 1e-14 of itself.
  AccuracyReport load_report("load(theta0) against the solver's", 1e-9);
  for (const JointKind kind : kinds) {
    for (const PairCase& pair : pairs) {
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
}

// The law gives the same on both sides of |beta| = 1e-15, where the closed
// form takes over from the solver, and for loads on both sides of 1.
TEST(ExactLaw, BranchesMeet) {
  const auto angle = [](double nu2, double load) {
    return ExactLaw(JointKind::pin, PairCase{1, 0.3, nu2}.elastic())
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
    PairCase pair;
    double end_deg;
  } cases[] = {{JointKind::ball, {0, 0.5, 0.3}, 175}};
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

// The solution by the gap takes over where the bodies yield all round, from
// that by the pressure, which ends at 163.57 deg.
TEST(ExactLaw, GoesOnByTheGap) {
  const ElasticPair pair = PairCase{1e-6, 0.5, 0.3}.elastic();
  const ExactLaw law(JointKind::pin, pair);
  const double limit = law.limit_half_angle();
  EXPECT_GT(limit / degree, 164);
  EXPECT_LT(limit / degree, 180);
  EXPECT_TRUE(law.validity_notes(pair).empty());
  EXPECT_EQ(law.half_angle(infinity).status, Status::ok);
  EXPECT_NEAR(law.half_angle(infinity).half_angle, limit, 1e-15);
  const double end = 163.57 * degree;
  const double load = law.load_parameter(end).load_parameter;
  double last = law.half_angle(load).half_angle;
  EXPECT_NEAR(last, end, 1e-12);
  for (const double more : {1.001, 1.01, 1.1, 10.0, 1e6}) {
    const HalfAngleResult next = law.half_angle(more * load);
    EXPECT_EQ(next.status, Status::ok);
    EXPECT_GT(next.half_angle, last);
    last = next.half_angle;
    EXPECT_NEAR(law.load_parameter(last).load_parameter / (more * load), 1,
                1e-5);
  }
  EXPECT_LT(last, limit);
}

// docs/internals/fitted_laws.md, "The extremes": rigid bodies, nu from 0 to
// 0.5, Ebar from 1e-6 to 1e6, half-angles from 1e-4 deg to 1e-3 deg from the
// limit, loads to 1e8. Only nearly incompressible inner bodies in nearly rigid
// outer ones end before their limit.
TEST(ExactLaw, ReachesTheExtremes) {
  // At 175 deg F is 1e-7, which leaves theta0 nine digits.
  AccuracyReport report("extremes, theta0 -> load -> theta0", 1e-10);
  int ends = 0;
  for (const JointKind kind : kinds) {
    for (const double ratio : {0.0, 1e-6, 1e-3, 1.0, 1e3, 1e6, infinity}) {
      for (const double nu1 : {0.0, 0.3, 0.49, 0.5}) {
        for (const double nu2 : {0.0, 0.3, 0.49, 0.5}) {
          const PairCase pair{ratio, nu1, nu2};
          const ExactLaw law(kind, pair.elastic());
          const bool ends_early = !law.validity_notes(pair.elastic()).empty();
          ends += ends_early;
          // A pin that closes up exactly (beta = 0) has its closed form.
          const bool incompressible_in_rigid =
              nu1 == 0.5 && kind == JointKind::ball && ratio == 0;
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
  EXPECT_EQ(ends, 4);
}

TEST(ExactLaw, LoadThroughTheBack) {
  const ElasticPair pair = PairCase{0, 0.3, 0.3}.elastic();
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
    const auto made = make_half_angle_law("exact", kind, pair, {}, {loading});
    EXPECT_EQ(made->half_angle(3).half_angle,
              (kind == JointKind::ball ? ball : pin).half_angle(3).half_angle);
  }
  for (const std::string& name : half_angle_law_names()) {
    EXPECT_TRUE(half_angle_law_allows(name, {}));
    EXPECT_EQ(half_angle_law_allows(name, {loading}), name == "exact");
    if (name == "exact") continue;
    EXPECT_ERROR(
        make_half_angle_law(name, JointKind::ball, pair, {}, {loading}),
        "half-angle law " + name + " must be exact with loading back:20");
  }
}

TEST(ExactLaw, ApproachOfInfiniteSeats) {
  AccuracyReport approach("approach", 1e-6);
  AccuracyReport stiffness("stiffness", 1e-6);
  for (const PairCase& pair : pairs) {
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
      EXPECT_TRUE(
          all_nan({law.approach(bad).approach, law.approach(bad).stiffness}));
    }
  }
}

TEST(ExactLaw, NoApproach) {
  // A pin in an infinite hole, loaded through the back, and other laws.
  const ElasticPair pair = pairs[1].elastic();
  const InnerLoading back = InnerLoading::back(0.3);
  const ExactLaw pin(JointKind::pin, pair);
  const ExactLaw roller(JointKind::pin, pair, back);
  const ExactLaw ball(JointKind::ball, pair, back);
  const auto fitted = make_half_angle_law("fitted", kinds[0], pair);
  const std::initializer_list<const HalfAngleLaw*> laws = {&pin, &roller, &ball,
                                                           fitted.get()};
  for (const HalfAngleLaw* law : laws) {
    EXPECT_TRUE(
        all_nan({law->approach(0.5).approach, law->approach(0.5).stiffness}));
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
  const ExactLaw law(JointKind::ball, PairCase{0.5, 0.3, 0.4}.elastic());
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

// ExactLaw of joints with walls against the solvers that it tabulates.
constexpr Wall walls[] = {{3, 0.3, false},     {1, 0.45, true},
                          {0.3, 0.499, false}, {0.1, 0.3, true},
                          {0.1, 0.4, false},   {0.02, 0.3, false},
                          {0.02, 0.499, true}};

template <class Contact>
void compare(JointKind kind) {
  AccuracyReport load("load at theta0", 1e-6);
  AccuracyReport angle("theta0 -> load -> theta0", 1e-12);
  AccuracyReport slope("log_slope", 1e-5);
  AccuracyReport approach("approach", 1e-6);
  AccuracyReport stiffness("stiffness", 1e-6);
  for (const Wall& wall : walls) {
    const std::string label = to_string(kind) + ", " + wall.label();
    const Contact contact(wall.pair());
    const ExactLaw law(kind, wall.pair());
    EXPECT_TRUE(law.validity_notes(wall.pair().surfaces()).empty()) << label;
    const ExactHalfAngle limit = contact.limit_half_angle();
    EXPECT_NEAR(law.limit_half_angle(), limit.half_angle, 1e-12);
    EXPECT_EQ(law.half_angle(infinity).half_angle, law.limit_half_angle());
    EXPECT_EQ(law.half_angle(0).half_angle, 0);
    for (const double theta0 :
         {1e-3, 0.01, 0.03, 0.1, 0.2, 0.5, 0.9, 0.9999 * limit.half_angle}) {
      const LoadParameterResult tabulated = law.load_parameter(theta0);
      EXPECT_EQ(tabulated.status, Status::ok);
      load.add(tabulated.load_parameter, 1 / contact.reciprocal_load(theta0),
               label);
      const ContactApproach near = law.approach(theta0);
      const ContactApproach solved = contact.approach(theta0);
      approach.add(near.approach, solved.approach, label);
      stiffness.add(near.stiffness, solved.stiffness, label);
      const HalfAngleResult back = law.half_angle(tabulated.load_parameter);
      EXPECT_EQ(back.status, Status::ok);
      angle.add(back.half_angle, theta0, label);
      if (theta0 > 0.95) continue;
      const double h = 1e-4 * theta0;
      const auto log_load = [&](double t) {
        return -std::log(contact.reciprocal_load(t));
      };
      slope.add(back.log_slope,
                std::log((theta0 + h) / (theta0 - h)) /
                    (log_load(theta0 + h) - log_load(theta0 - h)),
                label);
    }
  }
}

TEST(WalledExactLaw, IsTheSolverOfBalls) {
  compare<BallContact>(JointKind::ball);
}

TEST(WalledExactLaw, IsTheSolverOfPins) { compare<PinContact>(JointKind::pin); }

// Kinds of layers and their supports: eleven kinds in sixty rows.
std::string kind_of_walls(const ReferenceTable::Row& row) {
  std::string kind = row.text("end");
  for (const char* column : {"E1", "coat_E", "La_E", "Lb_E"}) {
    kind += row.given(column) ? '+' : '-';
  }
  return kind;
}

void compare_approach(const std::string& file, JointKind kind) {
  const ReferenceTable table(file);
  AccuracyReport approach("approach", 1e-6);
  AccuracyReport stiffness("stiffness", 1e-6);
  std::set<std::string> seen;
  for (const ReferenceTable::Row row : table) {
    // Each row makes a law of its own.
    if (!seen.insert(kind_of_walls(row)).second && !is_long_run()) continue;
    const std::string label = to_string(kind) + ", " + row.label();
    const LayeredPair pair = reference_pair(row);
    const ContactApproach a =
        ExactLaw(kind, pair).approach(row.value("theta0_deg") * degree);
    if (row.text("approach").empty()) {
      EXPECT_TRUE(all_nan({a.approach, a.stiffness})) << label;
      continue;
    }
    const double unit = pair.surfaces().effective_modulus() *
                        (kind == JointKind::ball ? pair.radius() : 1);
    approach.add(a.approach * row.value("clearance"), row.value("approach"),
                 label);
    stiffness.add(a.stiffness * unit, row.value("stiffness"), label);
  }
}

TEST(WalledExactLaw, ApproachOfTheReferenceBalls) {
  compare_approach("walls/walls_ball.csv", JointKind::ball);
}

TEST(WalledExactLaw, ApproachOfTheReferencePins) {
  compare_approach("walls/walls_pin.csv", JointKind::pin);
}

// Thin rings turn from a contact of their edge strip to one all over within a
// few per cent of the load: the cubic that starts Newton's steps must not lead
// to the root of the other sign, nor to the limit.
TEST(WalledExactLaw, HalfAngleGrowsWithTheLoad) {
  // Moduli of ring over pin: polymer, bronze, steel; a soft pin.
  const Material rings[] = {{0.01, 0.4}, {0.5, 0.34}, {1, 0.3}, {50, 0.3}};
  const auto expect = [](JointKind kind, const LayeredPair& pair,
                         const std::string& label) {
    const ExactLaw law(kind, pair);
    // The factor between the loads is that over which the worst of them turn.
    double before = 0;
    for (double load = 1e-11; load < 1e2; load *= 1.05) {
      const HalfAngleResult at = law.half_angle(load);
      ASSERT_EQ(at.status, Status::ok) << label << ", load " << load;
      // (At the limit to rounding.)
      ASSERT_GE(at.half_angle, before * (1 - 1e-12))
          << label << ", load " << load;
      before = at.half_angle;
      if (law.limit_half_angle() - before < 1e-6) continue;
      ASSERT_NEAR(law.load_parameter(before).load_parameter / load, 1, 1e-9)
          << label << ", load " << load;
    }
  };
  for (const double t : {0.012, 0.02, 0.03, 0.045, 0.06, 0.08, 0.1}) {
    for (const Material& ring : rings) {
      const LayeredBody pin{{}, Backing::medium({1, 0.3})};
      for (const Backing& backing :
           {Backing::held(), Backing::rigid(), Backing::medium({1, 0.3})}) {
        const LayeredPair pair(1, pin, {{{t, ring}}, backing});
        expect(JointKind::pin, pair,
               detail::message("pin, t {}, E {}, backing {}", t,
                               ring.youngs_modulus,
                               static_cast<int>(backing.kind())));
      }
      const LayeredPair lined(
          1, pin, {{{t / 4, {0.02, 0.4}}, {t, ring}}, Backing::held()});
      expect(JointKind::pin, lined,
             detail::message("lined pin, t {}, E {}", t, ring.youngs_modulus));
    }
    const LayeredPair seat(1, Material{1, 0.3},
                           {{{t, {0.5, 0.34}}}, Backing::held()});
    expect(JointKind::ball, seat, detail::message("ball, t {}", t));
  }
}

TEST(WalledExactLaw, SmallLoadsAreHertzian) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    for (const Wall& wall : walls) {
      const ExactLaw law(kind, wall.pair());
      // By 1e-3 where it is a thousandth of the thinnest wall; to nothing the
      // wall does nothing, and the series is exact.
      for (const double x : {1e-20, 1e-10, 1e-6}) {
        const double load = kind == JointKind::ball ? x * x * x : x * x / 4;
        EXPECT_NEAR(law.half_angle(load).half_angle / x, 1,
                    x == 1e-20 ? 1e-13 : 2e-3 + 1e-8);
      }
    }
  }
}

TEST(WalledExactLaw, EndsWhereTheSolverDoes) {
  // An incompressible liner: the pin's limit lies beyond 163 deg.
  const LayeredPair pair(1, {{}, Backing::rigid()},
                         {{{0.3, {1, 0.5}}}, Backing::rigid()});
  const ExactLaw law(JointKind::pin, pair);
  const PinContact pin(pair, InnerLoading::centre(), PinContact::max_unknowns);
  EXPECT_EQ(law.limit_half_angle(), pin.largest());
  EXPECT_EQ(law.validity_notes(pair.surfaces()).size(), 1u);
  EXPECT_EQ(law.half_angle(infinity).status, Status::not_converged);
  const double load = law.load_parameter(2.5).load_parameter;
  EXPECT_NEAR(load * pin.reciprocal_load(2.5), 1, 1e-6);
}

TEST(WalledExactLaw, RefusesCoatingsLoadedFromBehind) {
  const LayeredPair pair(1, {{{0.1, {1, 0.3}}}, Backing::rigid()},
                         {{}, Backing::medium({1, 0.3})});
  EXPECT_ERROR(ExactLaw(JointKind::ball, pair, InnerLoading::back(0.1)),
               "loading = back requires an inner body without coatings");
}

}  // namespace
}  // namespace contact::test::exact_test
