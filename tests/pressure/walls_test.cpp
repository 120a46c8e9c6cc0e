#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "libcontact/base/instruction_set.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/pressure/exact.hpp"
#include "libcontact/tools/reference/quadrature.hpp"
#include "support/accuracy_report.hpp"
#include "support/wall.hpp"

// ExactPressure of joints with walls: against the solvers, and the friction
// under it against quadrature of the definition.
namespace contact::test::walls_test {
namespace {

constexpr Wall walls[] = {{1, 0.3, false},      {0.3, 0.45, true},
                          {0.1, 0.4, false},    {0.03, 0.3, false},
                          {0.015, 0.42, false}, {0.01, 0.499, false}};

template <class Contact>
void compare(JointKind kind) {
  AccuracyReport value("p over the peak", 1e-6);
  // By the midpoint rule below, whose error for a ball this is.
  AccuracyReport load("load by p", kind == JointKind::ball ? 1e-5 : 1e-12);
  // The solver's own, which shows as its load by p against H_1.
  AccuracyReport sum("S", 1e-6);
  for (const Wall& wall : walls) {
    const Contact contact(wall.pair());
    const ExactPressure law(kind, wall.pair());
    const double largest = contact.limit_half_angle().half_angle;
    EXPECT_GE(law.largest_half_angle(), largest);
    for (const double theta0 : {0.01, 0.1, 0.3, 0.8, 1.3, 0.999 * largest}) {
      const std::string label =
          wall.label() + ", theta0 " + std::to_string(theta0);
      const ContactPressure solved = contact.pressure(theta0);
      for (const double share : {0.0, 0.2, 0.5, 0.8, 0.95, 0.99}) {
        const double theta = share * theta0;
        value.add_error(
            std::abs(law.pressure(theta, theta0) - solved.pressure(theta)) /
                solved.peak(),
            label);
      }
      EXPECT_NEAR(law.peak(theta0) / solved.peak(), 1, 1e-6) << label;
      sum.add(law.force_ratio(theta0), solved.force_ratio(), label);
      // Midpoint rule in the angle phi of the edge variable.
      constexpr int steps = 400;
      double force = 0;
      for (int i = 0; i < steps; ++i) {
        const double phi = std::numbers::pi / 2 * (i + 0.5) / steps;
        const double theta = theta0 * std::cos(phi);
        const double area = kind == JointKind::ball
                                ? 2 * std::numbers::pi * std::sin(theta)
                                : 2.0;
        force += law.pressure(theta, theta0) * std::cos(theta) * area * theta0 *
                 std::sin(phi) * std::numbers::pi / 2 / steps;
      }
      load.add(force, 1.0, label);
    }
  }
}

TEST(WalledExactPressure, IsTheSolverOfBalls) {
  compare<BallContact>(JointKind::ball);
}

TEST(WalledExactPressure, IsTheSolverOfPins) {
  compare<PinContact>(JointKind::pin);
}

// Such rings press hardest near the edge, from small contacts on: friction
// integrals have the weight p/p(0) all the same.
constexpr Wall free_rings[] = {{0.04, 0.4, true},
                               {0.0313, 0.351, true},
                               {0.02, 0.4, true},
                               {0.01, 0.4, true}};

// With as many unknowns as the solvers have; fewer lost 7e-5 of the load of
// balls, and with it 5e-5 of S.
template <class Contact>
void check_rings(JointKind kind) {
  AccuracyReport value("p over the peak", 1e-6);
  AccuracyReport sum("S", 1e-6);
  for (const Wall& ring : free_rings) {
    const Contact finest(ring.pair(), InnerLoading::centre(),
                         Contact::max_walled_unknowns);
    const ExactPressure law(kind, ring.pair());
    for (const double theta0 : {0.2, 0.8, 80 * degree}) {
      const std::string label =
          ring.label() + ", theta0 " + std::to_string(theta0);
      const ContactPressure solved = finest.pressure(theta0);
      for (const double share : {0.0, 0.3, 0.6, 0.9, 0.97}) {
        const double theta = share * theta0;
        value.add_error(
            std::abs(law.pressure(theta, theta0) - solved.pressure(theta)) /
                solved.peak(),
            label);
      }
      sum.add(law.force_ratio(theta0), solved.force_ratio(), label);
    }
  }
}

TEST(WalledExactPressure, FreeRingsAreResolved) {
  check_rings<BallContact>(JointKind::ball);
  check_rings<PinContact>(JointKind::pin);
}

// Seconds of this processor for one call.
template <class Call>
double cost(int calls, const Call& call) {
  const std::clock_t begin = std::clock();
  for (int i = 0; i < calls; ++i) call(i);
  return double(std::clock() - begin) / CLOCKS_PER_SEC / calls;
}

// 64 unknowns and friction over 64 sines against 16 and the short way.
// Measured: 13 and 8 times as long.
TEST(WalledExactPressure, FreeRingsCostNotMuchMore) {
  const auto law_of = [](const Wall& wall) {
    return ExactPressure(JointKind::ball, wall.pair());
  };
  const Wall liner{0.1, 0.4, false};
  const Wall& ring = free_rings[3];
  law_of(liner);  // tables that all share
  law_of(ring);
  EXPECT_LT(cost(3, [&](int) { law_of(ring); }),
            40 * cost(10, [&](int) { law_of(liner); }));
  const ExactPressure of_liner = law_of(liner);
  const ExactPressure of_ring = law_of(ring);
  const auto friction = [](const ExactPressure& law) {
    return cost(300, [&](int i) {
      friction_integrals(law, 0.5 + 0.002 * i, SlipAxis::from_degrees(30));
    });
  };
  EXPECT_LT(friction(of_ring), 40 * friction(of_liner));
}

// The 32 terms of a thin wall's pressure are summed in a form that does not
// multiply roundings, which differ between instruction sets: powers of the edge
// variable would make 1e-12 of them.
TEST(WalledExactPressure, FrictionKeepsItsDigits) {
  AccuracyReport report("between instruction sets", 4e-15);
  for (const Wall& wall : walls) {
    const ExactPressure law(JointKind::ball, wall.pair());
    for (const double theta0_deg : {5.0, 45.0, 65.0, 80.0}) {
      for (const double axis_deg : {1e-4, 30.0, 60.0, 85.0}) {
        const SlipAxis axis = SlipAxis::from_degrees(axis_deg);
        const auto by = [&](InstructionSet set) {
          const detail::WithInstructionSet with(set);
          return friction_integrals(law, theta0_deg * degree, axis).coefficient;
        };
        const FrictionTriple expected = by(InstructionSet::baseline);
        for (const auto set : {InstructionSet::avx2, InstructionSet::avx512}) {
          if (!is_supported(set)) continue;
          const FrictionTriple computed = by(set);
          const std::string label =
              wall.label() + ", theta0_deg " + std::to_string(theta0_deg);
          report.add(computed.force, expected.force, label);
          report.add(computed.sliding, expected.sliding, label);
          report.add(computed.spinning, expected.spinning, label);
        }
      }
    }
  }
}

TEST(WalledExactPressure, Friction) {
  // By quadrature of the definition with this very pressure, all its sines.
  // Friction takes 32.
  AccuracyReport thick("friction coefficients, t >= 0.1", 1e-7);
  AccuracyReport thin("friction coefficients, t = 0.03 to 0.01", 1e-7);
  // By parts over all 64 sines.
  AccuracyReport rings("friction coefficients, free rings", 1e-9);
  // Error of p(0) by 32 sines, 1e-6 of the peak as for the whole law.
  AccuracyReport scale("with p over p(0)", 1e-6);
  const ExactPressure ring(JointKind::ball, free_rings[0].pair());
  EXPECT_GT(ring.peak(0.1), 2 * ring.pressure(0, 0.1));
  std::vector<Wall> all(std::begin(walls), std::end(walls));
  all.insert(all.end(), std::begin(free_rings), std::end(free_rings));
  for (const Wall& wall : all) {
    AccuracyReport& report = wall.thickness >= 0.1 ? thick
                             : wall.held           ? rings
                                                   : thin;
    const ExactPressure law(JointKind::ball, wall.pair());
    for (const double theta0_deg : {5.0, 45.0, 80.0}) {
      for (const double axis_deg : {10.0, 60.0}) {
        const SlipAxis axis = SlipAxis::from_degrees(axis_deg);
        const double theta0 = theta0_deg * degree;
        const FrictionIntegrals expected =
            reference::quadrature_friction_integrals(law, theta0, axis, 1e-9)
                .value;
        const FrictionIntegrals computed =
            friction_integrals(law, theta0, axis);
        const std::string label = wall.label() + ", theta0_deg " +
                                  std::to_string(theta0_deg) + ", a_deg " +
                                  std::to_string(axis_deg);
        report.add(computed.coefficient.force, expected.coefficient.force,
                   label);
        report.add(computed.coefficient.sliding, expected.coefficient.sliding,
                   label);
        report.add(computed.coefficient.spinning, expected.coefficient.spinning,
                   label);
        scale.add(computed.normal, expected.normal, label);
        scale.add(computed.pressure.force, expected.pressure.force, label);
      }
    }
  }
}

}  // namespace
}  // namespace contact::test::walls_test
