// Finite-length pins on a cycle: a level one equals the infinite pin, sums
// equal their parts, and a stationary state equals a single solution.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "libcontact/base/units.hpp"
#include "libcontact/duty/along_pin.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/quantities/tables.hpp"
#include "support/bush.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"

namespace contact::test::pin_cycle_test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Instant = JointCycle::Instant;

constexpr double rho = 0.02;
constexpr double length = 0.05;

JointSpec bush(Relief relief = Relief::none(),
               JointBody inner = JointBody::carrier) {
  JointSpec spec = bush_of(FrictionLaw(0.1), relief, inner);
  spec.half_angle_law = "exact";
  return spec;
}

// A load that swings, on a pin that swings.
DutyCycle swinging() {
  DutyCycle::Rows rows;
  constexpr int count = 40;
  for (int i = 0; i < count; ++i) {
    const double phase = 2 * pi * i / count;
    const double way = 0.4 * std::cos(phase + 0.3);
    const double load = 4e4 * (1.5 + std::sin(phase));
    rows.times.push_back(2.0 * i / count);
    rows.forces.push_back(load * Vector3d(std::cos(way), std::sin(way), 0));
    rows.motion.push_back({0.2 * std::sin(phase), 0, 0});
  }
  rows.period = 2;
  return {rows, {}, DutyCycle::TurnSequence("z")};
}

TEST(CycleOfPin, LevelIsTheEndlessPin) {
  for (const JointBody inner : {JointBody::carrier, JointBody::body}) {
    const JointSpec spec = bush(Relief::none(), inner);
    const JointCycle endless(swinging(), Joint(spec.contact()));
    // By slices, which its middle loads as a level pin.
    const JointCycle pin(swinging(), Joint(spec), loaded_at(0));
    const AlongPin along(pin, spec);
    // The force law is within 5e-11 of solutions, the joint's tables 1e-9.
    constexpr double budget = 1e-8;
    EXPECT_TRUE(pin.joint().lie(pin.rows()[0].solution));
    EXPECT_NEAR(pin.sums().pv / endless.integral([&](const auto& i) {
      return endless.sliding(i).pv_total();
    }),
                1, budget);
    EXPECT_NEAR(pin.sums().energy / endless.sums().energy, 1, budget);
    EXPECT_NEAR(
        pin.sums().effective_distance / endless.sums().effective_distance, 1,
        budget);
    EXPECT_NEAR(pin.sums().moment / endless.sums().moment, 1, budget);
    EXPECT_EQ(pin.sums().sliding_path, endless.sums().sliding_path);
    EXPECT_TRUE(std::isnan(pin.contact_spread()));
    const auto pv = [&](const auto& i) {
      return endless.sliding(i).largest_pv().value;
    };
    const Instant most = pin.largest_pv();
    const double largest = pin.pv(most).largest;
    const auto most_of_endless = endless.largest(pv);
    EXPECT_NEAR(largest / pv(endless.at(most.time)), 1, budget);
    // The swing has it twice, on its way there and back, to 2e-7; a maximum in
    // time is flat: the root of that.
    EXPECT_NEAR(largest / pv(most_of_endless), 1, 1e-6);
    EXPECT_NEAR(std::abs(most.time - 0.5), std::abs(most_of_endless.time - 0.5),
                1e-4);
    EXPECT_NEAR(
        pin.largest_contact().half_angle / endless.largest_contact().half_angle,
        1, budget);
    for (const JointBody body : {JointBody::carrier, JointBody::body}) {
      const WearMap map(endless, body);
      constexpr int count = 90;
      const std::vector<Vector3d> points = map.grid(count);
      const double deepest = map.deepest(points,
                                         [&] {
                                           std::vector<WearMap::Wear> wear;
                                           for (const Vector3d& p : points) {
                                             wear.push_back(map.at(p));
                                           }
                                           return wear;
                                         }())
                                 .wear.pv;
      for (const double z : {-0.4 * length, 0.1 * length}) {
        const auto wear = along.pv_integrals(body, z, count);
        for (int k = 0; k < count; ++k) {
          EXPECT_NEAR(wear[k], map.at(points[k]).pv, 1e-7 * deepest) << k;
        }
      }
    }
  }
}

// A relief selects slices by default; such a pin wears only along the pin.
TEST(CycleOfPin, OfAReliefIsBySlices) {
  const Joint bush_with_relief(bush(Relief::barrel(1e-5)));
  const JointCycle pin(swinging(), bush_with_relief);
  const JointCycle level(swinging(), bush_with_relief,
                         tilted_with_load({0, 0}));
  EXPECT_EQ(pin.sums().energy, level.sums().energy);
  EXPECT_GT(pin.half_angle(pin.rows()[3]), 0);
  EXPECT_TRUE(std::isnan(pin.rating(pin.rows()[3]).heat_flux.value));
  EXPECT_GT(pin.rating(pin.rows()[3]).pv_total, 0);
  EXPECT_ERROR(WearMap(pin, JointBody::body),
               "the wear of a pin that ends requires a place along it: "
               "hinge-duty --along-map");
}

TEST(CycleOfPin, RefusesWhatHasNoSlices) {
  JointSpec viscous = bush();
  viscous.friction = ViscousLaw(1e9);
  EXPECT_ERROR(
      JointCycle(swinging(), Joint(viscous), loaded_at(0)),
      "a pin that is tilted, loaded at a place or slides along its axis "
      "requires a pin of a JointSpec with dry friction, a radial_clearance "
      "above 0 m, loading = centre and a wall with an end");
  JointSpec ball = bush();
  ball.geometry = JointGeometry::ball(rho, 2e-5);
  EXPECT_ERROR(JointCycle(swinging(), Joint(ball), loaded_at(0)),
               "a tilt, or a place of the load, requires a pin");
}

// Tilted and relieved: the pressures over angle, length and time.
TEST(CycleOfPin, SumsOverThePinAreThoseOfItsPlaces) {
  const JointSpec spec = bush(Relief::barrel(1e-5));
  const JointCycle pin(swinging(), Joint(spec), tilted_with_load({6e-4, 2e-4}));
  const AlongPin along_pin(pin, spec);
  constexpr int places = 200;
  constexpr int angles = 720;
  double along = 0;
  double largest = 0;
  for (int i = 0; i < places; ++i) {
    const double z = length * ((i + 0.5) / places - 0.5);
    const AlongPin::Place at = along_pin.at(z);
    along += at.pv_per_length * length / places;
    largest = std::max(largest, at.largest_pv);
    EXPECT_GE(at.largest_pv, at.mean_pv);
    if (i != 150) continue;
    for (const JointBody body : {JointBody::carrier, JointBody::body}) {
      double round = 0;
      for (const double pv : along_pin.pv_integrals(body, z, angles)) {
        round += pv;
      }
      // Kinks at the edges: squares of the steps.
      EXPECT_NEAR(round * 2 * pi * rho / angles / at.pv_per_length, 1, 1e-4);
    }
  }
  // Midpoints, with the ends of contact between them.
  EXPECT_NEAR(along / pin.sums().pv, 1, 1e-4);
  const double most = pin.pv(pin.largest_pv()).largest;
  EXPECT_NEAR(largest / most, 1, 1e-3);
  EXPECT_LE(largest, most);
  // The table of quantities has the same.
  EXPECT_EQ(number_of(*find_quantity(worst_quantities(), "largest_pv"), pin),
            most);
  // Dry friction: the work is f0 times the integral of p v.
  EXPECT_NEAR(pin.sums().energy / pin.sums().pv, 0.1, 1e-12);
}

// One load, one rate: the cycle is a state.
TEST(CycleOfPin, SteadyIsOneState) {
  DutyCycle::Rows rows;
  for (int i = 0; i < 4; ++i) {
    rows.times.push_back(i);
    rows.forces.push_back({3e4, 4e4, 500});
    rows.motion.push_back({0, 0, 0.5 * pi});
  }
  rows.period = 4;
  const JointSpec spec = bush(Relief::ends(1.5e-5, 0.008));
  const JointCycle pin({rows, {}}, Joint(spec), loaded_at(2e-3));
  const AlongPin along(pin, spec);
  const FinitePin state(spec);
  const FinitePinSolution s = state.solve_at({3e4, 4e4}, 2e-3, 1);
  const double pv = s.contact.peak_pressure * 0.5 * pi * rho;
  const AlongPin::Place at = along.at(s.contact.peak_place);
  EXPECT_NEAR(at.largest_pv / pv, 1, 1e-12);
  EXPECT_NEAR(at.mean_pv / pv, 1, 1e-12);
  // The body turns once under the load: it wears evenly.
  const auto wear = along.pv_integrals(JointBody::body, 0.01, 8);
  const double mean = along.at(0.01).pv_per_length / (2 * pi * rho);
  for (const double depth : wear) EXPECT_NEAR(depth / mean, 1, 1e-2);
  // The carrier wears where the pressures are, which friction turns.
  const auto stands = along.pv_integrals(JointBody::carrier, 0.01, 360);
  const auto deepest = std::ranges::max_element(stands) - stands.begin();
  const Vector2d& force = s.contact.force;
  EXPECT_NEAR(static_cast<double>(deepest) - 180,
              std::atan2(force.y(), force.x()) / degree, 1);
}

// A tilt in the plane of the load is one in carrier axes that turns with it.
TEST(CycleOfPin, LiesThroughTheCycle) {
  const DutyCycle cycle = swinging();
  const JointSpec spec = bush();
  const JointCycle with_load(cycle, Joint(spec),
                             tilted_with_load({5e-4, 1e-4}));
  std::vector<Vector2d> tilts;
  std::vector<double> places;
  for (const double time : cycle.times()) {
    const Vector2d x = cycle.at(time).reaction.head<2>().normalized();
    tilts.push_back(5e-4 * x + 1e-4 * Vector2d(-x.y(), x.x()));
    places.push_back(1e-3);
  }
  const JointCycle in_carrier(cycle, Joint(spec),
                              tilted_at(cycle.times(), cycle.period(), tilts));
  const JointCycle loaded(cycle, Joint(spec), loaded_at(1e-3));
  const JointCycle through(cycle, Joint(spec),
                           loaded_at(cycle.times(), cycle.period(), places));
  for (std::size_t i = 0; i < tilts.size(); ++i) {
    // Splines give their values back to rounding.
    const auto peak = [i](const JointCycle& pin) {
      return pin.rows()[i].solution.peak_pressure;
    };
    EXPECT_NEAR(peak(in_carrier) / peak(with_load), 1, 1e-9);
    EXPECT_NEAR(peak(through) / peak(loaded), 1, 1e-9);
  }
}

TEST(CycleOfPin, SaysWhereItHasNoContact) {
  DutyCycle::Rows rows;
  for (int i = 0; i < 4; ++i) {
    rows.times.push_back(i);
    rows.forces.push_back({i == 2 ? 1e9 : 1e4, 0, 0});
    rows.motion.push_back({0.1 * i, 0, 0});
  }
  rows.period = 4;
  EXPECT_ERROR(
      JointCycle({rows, {}, DutyCycle::TurnSequence("z")}, Joint(bush()),
                 loaded_at(0)),
      "the reaction at 2 s, 1e+09 N must be one under which the pin that ends "
      "has a contact");
}

}  // namespace
}  // namespace contact::test::pin_cycle_test
