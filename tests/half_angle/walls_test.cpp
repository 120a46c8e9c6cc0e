#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "support/accuracy_report.hpp"
#include "support/allocation_count.hpp"
#include "support/error_message.hpp"
#include "support/wall.hpp"

// ExactLaw of joints with walls against the solvers that it tabulates.
namespace {

using namespace contact;
using contact::test::AccuracyReport;
using contact::test::Wall;

constexpr double infinity = std::numeric_limits<double>::infinity();

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
  for (const AccuracyReport* report :
       {&load, &angle, &slope, &approach, &stiffness}) {
    report->check();
  }
}

TEST(WalledExactLaw, IsTheSolverOfBalls) {
  compare<BallContact>(JointKind::ball);
}

TEST(WalledExactLaw, IsTheSolverOfPins) { compare<PinContact>(JointKind::pin); }

void compare_approach(const std::string& file, JointKind kind) {
  const test::ReferenceTable table(file);
  AccuracyReport approach("approach", 1e-6);
  AccuracyReport stiffness("stiffness", 1e-6);
  for (const test::ReferenceTable::Row row : table) {
    const std::string label = to_string(kind) + ", " + row.label();
    const LayeredPair pair = test::reference_pair(row);
    const ContactApproach a =
        ExactLaw(kind, pair).approach(row.value("theta0_deg") * degree);
    if (row.text("approach").empty()) {
      EXPECT_TRUE(std::isnan(a.approach)) << label;
      EXPECT_TRUE(std::isnan(a.stiffness)) << label;
      continue;
    }
    const double unit = pair.surfaces().effective_modulus() *
                        (kind == JointKind::ball ? pair.radius() : 1);
    approach.add(a.approach * row.value("clearance"), row.value("approach"),
                 label);
    stiffness.add(a.stiffness * unit, row.value("stiffness"), label);
  }
  approach.check();
  stiffness.check();
}

TEST(WalledExactLaw, ApproachOfTheReferenceBalls) {
  compare_approach("walls/walls_ball.csv", JointKind::ball);
}

TEST(WalledExactLaw, ApproachOfTheReferencePins) {
  compare_approach("walls/walls_pin.csv", JointKind::pin);
}

TEST(WalledExactLaw, SmallLoadsAreHertzian) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    for (const Wall& wall : walls) {
      const ExactLaw law(kind, wall.pair());
      for (const double x : {1e-20, 1e-10, 1e-6}) {
        const double load = kind == JointKind::ball ? x * x * x : x * x / 4;
        EXPECT_NEAR(law.half_angle(load).half_angle / x, 1, 2e-3 + 1e-8);
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
  EXPECT_EQ(test::error_message([&] {
              ExactLaw(JointKind::ball, pair, InnerLoading::back(0.1));
            }),
            "loading = back requires an inner body without coatings");
}

}  // namespace
