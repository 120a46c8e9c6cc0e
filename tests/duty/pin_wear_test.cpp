// Wear of pins with interference: against a table, and exact results.
#include "libcontact/duty/steps/pin_wear.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "duty/worn_pin_clearance.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "libcontact/duty/wear_map.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/pressure/exact.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::pin_wear_test {
namespace {

using detail::PinWear;
using detail::WornCircle;

LayeredPair pair_of(const ReferenceTable::Row& row) {
  return {row.value("rho"), Material{row.value("pin_E"), row.value("pin_nu")},
          LayeredBody{
              {{row.value("La_t"), {row.value("La_E"), row.value("La_nu")}}},
              Backing::rigid()}};
}

double sum_factor(const WornCircle& circle, double load,
                  const WornCircle::Contact& contact) {
  return 2 * pi * circle.radius() * contact.pressure.mean() / load;
}

// The hole wears; the load is stationary in it.
TEST(PinWear, OfTheHoleMatchesTheReference) {
  const ReferenceTable table("preload/wear.csv");
  // `accuracy` is the reference's own; half of it is ours.
  AccuracyReport worst("share of `accuracy`", 1);
  for (const ReferenceTable::Row row : table) {
    if (row.text("worn_body") != "fixed") continue;
    PinWear wear(pair_of(row), row.value("clearance"));
    const double load = row.value("load");
    EXPECT_EQ(wear.slide({load, 0}, {.hole = row.value("sigma"), .pin = 0}),
              Status::ok);
    const WornCircle::Contact now = wear.contact({load, 0});
    EXPECT_EQ(now.status, Status::ok);
    const auto add = [&](double computed, const char* column) {
      worst.add_error(
          std::abs(computed / row.value(column) - 1) / row.value("accuracy"),
          row.label() + ' ' + column);
    };
    add(sum_factor(wear.circle(), load, now), "S");
    add(now.pressure[0], "p_centre");
    add(wear.depth(), "max_depth");
    // Half a degree of the table, a quarter of ours.
    EXPECT_NEAR(now.half_angle / degree, row.value("theta0_deg"), 0.8)
        << row.label();
    EXPECT_EQ(wear.is_closed(), row.value("theta0_deg") == 180);
  }
}

JointContact contact_of(const LayeredPair& pair, double clearance) {
  const auto kind = JointKind::pin;
  return {JointGeometry::pin(pair.radius(), clearance, 1),
          pair.surfaces(),
          FrictionLaw(0.1),
          std::make_shared<ExactLaw>(kind, pair),
          std::make_shared<ExactPressure>(kind, pair),
          {.walls = pair}};
}

// The pin wears, and stays round: from interference to clearance.
TEST(PinWear, OfThePinMatchesTheReference) {
  const ReferenceTable table("preload/wear.csv");
  // The loads of the table are rounded to 1.5e-6, the paths are not.
  AccuracyReport growth("growth of the clearance", 1e-6);
  AccuracyReport half_angle("half-angle", 1e-8);
  AccuracyReport exact("S", 2e-6);
  AccuracyReport sums("S on the circle", 1e-4);
  std::unique_ptr<JointContact> contact;
  for (const ReferenceTable::Row row : table) {
    if (row.text("worn_body") != "turning") continue;
    const LayeredPair pair = pair_of(row);
    const double clearance = row.value("clearance");
    if (!contact || contact->geometry().radius() != pair.radius()) {
      contact = std::make_unique<JointContact>(contact_of(pair, clearance));
    }
    const double load = row.value("load");
    const double sigma = row.value("sigma");
    const LoadedPath path = {load, sigma};
    const double after = clearance_of_worn_pin(*contact, {&path, 1}, 1);
    growth.add(after - clearance, row.value("clearance_after") - clearance,
               row.label());
    const JointContact worn =
        contact->with_clearance(row.value("clearance_after"));
    const double theta0 = worn.half_angle(load).half_angle;
    half_angle.add(theta0 / degree, row.value("theta0_deg"), row.label());
    exact.add(worn.sum_of_pressures(load, theta0) / load, row.value("S"),
              row.label());
    PinWear wear(pair, clearance);
    wear.slide({load, 0}, {.hole = 0, .pin = sigma});
    sums.add(sum_factor(wear.circle(), load, wear.contact({load, 0})),
             row.value("S"), row.label());
    EXPECT_NEAR(wear.clearance(), after, 1e-3 * std::abs(clearance));
    EXPECT_EQ(wear.depth(), 0);
  }
}

// Closed all round both bodies take their share, and the loads in between do
// not count: interference is eps(0) exp(-path/C_0).
TEST(PinWear, IsExactWhileClosed) {
  const ReferenceTable table("preload/wear.csv");
  const LayeredPair pair = pair_of(table[0]);
  constexpr double i = 2e-5;
  PinWear wear(pair, -i);
  const double c0 = wear.circle().mean_compliance();
  const double lift_off = pi * pair.radius() * i / c0;
  double shifted = 0;
  for (const double share : {0.1, 0.4, 0.2}) {
    wear.slide({share * lift_off, 0}, {.hole = 0.1 * c0, .pin = 0.2 * c0});
    shifted += 0.1 * c0 * share * i / c0;
  }
  EXPECT_TRUE(wear.is_closed());
  const double left = i * std::exp(-0.9);
  EXPECT_NEAR(wear.clearance(), -left, 1e-12 * i);
  EXPECT_NEAR(wear.depth(), (i - left) / 3 + shifted, 1e-12 * i);
  EXPECT_NEAR(wear.worn_area(), 2 * pi * pair.radius() * (i - left) / 3,
              1e-12 * i);
  EXPECT_NEAR(wear.contact({0.3 * lift_off, 0}).pressure[0] * c0,
              left + 0.3 * i, 1e-9 * i);
}

// Wherever it begins, the worn pressure tends to the pressure of a hole ground
// out by the pin: a cosine over the half circle, S = 4/pi.
TEST(PinWear, RunsToTheWornPressure) {
  const ReferenceTable table("preload/wear.csv");
  const LayeredPair pair = pair_of(table[0]);
  for (const double clearance : {-2e-5, 0.0, 2e-5}) {
    PinWear wear(pair, clearance);
    const double c0 = wear.circle().mean_compliance();
    const double load = pi * pair.radius() * 2e-5 / c0;
    wear.slide({load, 0}, {.hole = 300 * c0, .pin = 0});
    EXPECT_NEAR(
        sum_factor(wear.circle(), load, wear.contact({load, 0})) / (4 / pi), 1,
        2e-3)
        << clearance;
  }
}

// Halving the steps changes S by less than 1e-4.
TEST(PinWear, StepsAreShortEnough) {
  const ReferenceTable table("preload/wear.csv");
  const LayeredPair pair = pair_of(table[0]);
  PinWear wear(pair, -2e-5);
  PinWear fine = wear;
  const double c0 = wear.circle().mean_compliance();
  const double load = 1.2 * pi * pair.radius() * 2e-5 / c0;
  wear.slide({load, 0}, {.hole = c0, .pin = 0});
  for (double done = 0; done < c0;) {
    const double step = std::min(fine.next_step() / 2, c0 - done);
    fine.slide({load, 0}, {.hole = step, .pin = 0});
    done += step;
  }
  EXPECT_NEAR(sum_factor(wear.circle(), load, wear.contact({load, 0})),
              sum_factor(fine.circle(), load, fine.contact({load, 0})), 1e-4);
}

// A load that rotates with the hole, so that it is stationary in it, of
// constant or varying size.
DutyCycle steady(double force, double swing = 0) {
  constexpr int count = 8;
  std::vector<double> times;
  std::vector<Eigen::Vector3d> forces;
  for (int i = 0; i < count; ++i) {
    times.push_back(i);
    forces.emplace_back(0, -force * (1 + swing * std::cos(2 * pi * i / count)),
                        0);
  }
  const std::vector<Eigen::Vector3d> rates(count, {0, 0, 2});
  return {{times, forces, rates, count}, {JointBody::body, JointBody::body}};
}

// Cycles of a joint: closed to begin with, then lifted, then with a clearance.
TEST(WearInPressed, OpensTheInterference) {
  const ReferenceTable table("preload/wear.csv");
  const LayeredPair pair = pair_of(table[0]);
  constexpr double i = 2e-5;
  const JointContact contact = contact_of(pair, -i);
  const double force = contact.lift_off_force() / 2;
  const PinWear circle(pair, -i);
  const double c0 = circle.circle().mean_compliance();
  constexpr double k = 1e-17;
  const double distance = pair.radius() * 2 * 8;
  const double cycles = 5 * c0 / (k * distance);
  for (const double swing : {0.0, 0.5}) {
    const WearIn worn =
        wear_in(steady(force, swing), contact, {.seat = k}, cycles);
    ASSERT_GT(worn.states.size(), 20u);
    EXPECT_EQ(worn.states.front().half_angle, pi);
    // Before wear the cycle equals the joint's own cycle, except for the
    // discretisation of the circle.
    const JointCycle fresh(steady(force, swing), Joint(contact));
    const double energy = -fresh.integral(
        [](const JointCycle::Instant& at) { return at.solution.power; });
    EXPECT_NEAR(worn.states.front().energy / energy, 1, 1e-3);
    for (const WearIn::State& state : worn.states) {
      const double left = std::exp(-k * distance * state.cycles / c0);
      if (left < (1 + swing) / 2) break;  // the largest load may lift it off
      // Exact for any loads.
      EXPECT_NEAR(state.clearance / -i, left, 1e-9);
    }
    const WearIn::State& last = worn.states.back();
    EXPECT_EQ(last.cycles, cycles);
    EXPECT_GT(last.clearance, 0);
    EXPECT_NEAR(last.half_angle / degree, 90, 2);
    // S is 4/pi within 2 %: the moment is rho f0 S R_n, turned through 16 rad.
    const double cosine = 1 / std::hypot(1, 0.1);
    EXPECT_NEAR(last.mean_moment / (pair.radius() * 0.1 * force * cosine),
                4 / pi, 0.02);
    EXPECT_NEAR(last.energy / (16 * last.mean_moment), 1, 1e-9);
    EXPECT_TRUE(std::isnan(last.wear_number));
    ASSERT_EQ(worn.notes.size(), 1u);
    EXPECT_EQ(worn.notes[0],
              "the contact is closed all round at first: debris cannot leave");
  }
}

// The pin alone: as the exact growth of its clearance.
TEST(WearInPressed, OfThePinFollowsItsExactGrowth) {
  const ReferenceTable table("preload/wear.csv");
  const LayeredPair pair = pair_of(table[0]);
  const JointContact contact = contact_of(pair, -2e-5);
  const double force = contact.lift_off_force() / 2;
  constexpr double k = 1e-16;
  const double path = k * pair.radius() * 16;
  const auto states =
      wear_in(steady(force), contact, {.seat = 0, .inner = k}, 2e5).states;
  const LoadedPath loaded = {force / std::hypot(1, 0.1), path};
  EXPECT_NEAR(states.back().clearance,
              clearance_of_worn_pin(contact, {&loaded, 1}, 2e5), 1e-3 * 2e-5);
  EXPECT_EQ(states.back().volume, 0);
}

// p all round while closed, then p of the lifted contact: the map of the hole,
// in which the load is stationary, against the pressure itself.
TEST(WearMap, OfAPressedPin) {
  const LayeredPair pair = pair_of(ReferenceTable("preload/wear.csv")[0]);
  const JointContact contact = contact_of(pair, -2e-5);
  const double distance = pair.radius() * 2 * 8;
  for (const double share : {0.5, 3.0}) {
    const JointCycle cycle(steady(share * contact.lift_off_force()),
                           Joint(contact));
    const JointCycle::Instant& at = cycle.gauss_points()[0];
    const WearMap map(cycle, JointBody::body);
    const Eigen::Vector3d centre =
        at.state.turn.conjugate() * cycle.sliding(at).centre();
    const double force = at.solution.normal_force;
    const double half_angle = at.solution.half_angle;
    EXPECT_EQ(half_angle == pi, share < 1);
    const double largest = contact.pressure(0, force, half_angle);
    for (const double theta : {0.0, 0.7, 1.5, 2.5, pi}) {
      const Eigen::AngleAxisd turn(theta, Eigen::Vector3d::UnitZ());
      const double p = theta < half_angle
                           ? contact.pressure(theta, force, half_angle)
                       : share < 1 ? contact.pressure(pi, force, half_angle)
                                   : 0;
      // A profile of a wide contact is good to 1e-6 of the peak.
      EXPECT_NEAR(map.at(turn * centre).pv, p * distance,
                  2e-6 * largest * distance)
          << theta << ' ' << share;
    }
    std::vector<WearMap::Wear> wear;
    for (const auto& point : map.grid(2000)) wear.push_back(map.at(point));
    EXPECT_LT(std::abs(map.volume_defect(wear)), 1e-3);
  }
}

TEST(WearInPressed, IsOfPins) {
  const LayeredPair pair = pair_of(ReferenceTable("preload/wear.csv")[0]);
  const auto kind = JointKind::ball;
  const JointContact ball(
      JointGeometry::ball(pair.radius(), -2e-5), pair.surfaces(),
      FrictionLaw(0.1), std::make_shared<ExactLaw>(kind, pair),
      std::make_shared<ExactPressure>(kind, pair), {.walls = pair});
  EXPECT_ERROR(wear_in(steady(1000), ball, {1e-17}, 10),
               "wear without clearance or with interference requires a pin: a "
               "ball slides faster at its equator, so that it loses its shape");
}

}  // namespace
}  // namespace contact::test::pin_wear_test
