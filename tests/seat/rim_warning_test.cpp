#include "libcontact/seat/rim_warning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/seat/contact.hpp"
#include "support/cup.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

// Checks the statements of the rim warnings against finite elements of cups
// with free side faces.
namespace contact::test::rim_warning_test {
namespace {

std::string said_of(const SeatContact& contact, const SeatState& state) {
  for (const std::string& note : contact.notes(state)) {
    if (has_text(note, "side face")) return note;
  }
  return {};
}

// The numbers are read from the sentence. Pressures and approaches are good to
// 0.3 and 0.1 % on both sides.
TEST(RimWarning, HoldsWhatFiniteElementsFind) {
  const std::regex band(
      R"(larger by (up|-1\.2) to ([0-9.]+) %, an approach larger by up to ([0-9.]+) %)");
  int warned = 0, with_numbers = 0, not_known = 0;
  for (const auto row : ReferenceTable("side_face/cups.csv")) {
    const Cup cup = cup_of(row);
    const SeatContact contact = cup.contact();
    const SeatState state = contact.under({0, 0, row.value("load_N")});
    ASSERT_EQ(state.status, SeatStatus::ok) << row.label();
    const double pressure = row.value("dp_percent");
    const double approach = row.value("da_percent");
    if (row.given("p_MPa")) {
      // p is the pressure of the cell about the axis.
      EXPECT_NEAR(row.value("p_MPa") * 1e6 / state.pressure_at_load,
                  1 + pressure / 100, 1e-2)
          << row.label();
      EXPECT_NEAR(row.value("approach_mm") * 1e-3 /
                      (state.shift.norm() - cup.radius / 1000),
                  1 + approach / 100, 2e-3)
          << row.label();
    }
    const std::string said = said_of(contact, state);
    std::smatch found;
    if (said.empty()) {
      // Ten degrees before a corner of 90 deg and more of a stiff seat.
      EXPECT_LE(pressure, 2.3) << row.label();
      continue;
    }
    ++warned;
    if (!std::regex_search(said, found, band)) {
      EXPECT_TRUE(has_text(said, "in nine of ten cups of all sizes by up to"))
          << said;
      EXPECT_GT(cup.thickness, 1.5) << row.label();
      ++not_known;
      continue;
    }
    ++with_numbers;
    const std::string place = row.label() + ", rim " + row.text("rim_deg") +
                              ", corner " + row.text("corner_deg") + ": " +
                              said;
    EXPECT_LE(pressure, std::stod(found[2]) + 0.3) << place;
    EXPECT_GE(pressure, (found[1] == "up" ? 0 : -1.2) - 0.3) << place;
    EXPECT_LE(approach, std::stod(found[3]) + 0.1) << place;
    EXPECT_GE(approach, -0.1) << place;
    // And says no more than it has to.
    EXPECT_LE(std::stod(found[2]), 6 * std::abs(pressure) + 9) << place;
    EXPECT_LE(std::stod(found[3]), 6 * std::abs(approach) + 9) << place;
    EXPECT_TRUE(has_text(said, "of " + row.text("rim_deg") + " deg")) << said;
  }
  RecordProperty("warned", warned);
  EXPECT_GE(with_numbers, 55);
  EXPECT_GE(not_known, 5);
}

// The numbers of the sentence where no bound is known.
TEST(RimWarning, KnowsWhatCupsOfAllSizesHave) {
  std::vector<double> pressures, approaches;
  for (const auto row : ReferenceTable("side_face/rows.csv")) {
    pressures.push_back(row.value("dp_percent"));
    approaches.push_back(row.value("da_percent"));
  }
  std::ranges::sort(pressures);
  std::ranges::sort(approaches);
  const std::size_t nine_tenths = pressures.size() * 9 / 10;
  EXPECT_EQ(std::ceil(pressures[nine_tenths]), 23);
  EXPECT_EQ(std::ceil(approaches[nine_tenths]), 42);
  EXPECT_EQ(std::round(pressures.back()), 152);
  EXPECT_EQ(std::round(approaches.back()), 1735);
}

const detail::RimWarning::Largest& at(
    const std::optional<detail::RimWarning::Largest>& largest) {
  static const detail::RimWarning::Largest none{nan, nan};
  return largest ? *largest : none;
}

detail::RimWarning warning(const Cup& cup, const SeatZone& zone) {
  return {LayeredPair(cup.radius, cup.ball, cup.body()), zone, "cure"};
}

TEST(RimWarning, HasNoNumbersOutsideOfWhatIsKnown) {
  const auto known = [](const Cup& cup, double direction = 0,
                        double half_angle = 60) {
    return warning(cup, cup.zone())
        .largest(1, direction * degree, half_angle * degree)
        .has_value();
  };
  EXPECT_TRUE(known({}));
  EXPECT_TRUE(known({.rim = 35}, 0, 35));
  EXPECT_FALSE(known({.rim = 34}, 0, 35));
  EXPECT_TRUE(known({.corner = 60}));
  EXPECT_FALSE(known({.corner = 59}));
  EXPECT_FALSE(known({.corner = 166}));
  EXPECT_TRUE(known({.thickness = 1.5}));
  EXPECT_FALSE(known({.thickness = 1.6}));
  EXPECT_FALSE(known({.thickness = 0.04}));
  EXPECT_FALSE(known({.seat = {210e9, 0.29}}));
  EXPECT_FALSE(known({.seat = {210e9, 0.47}}));
  EXPECT_FALSE(known({}, 2));
  EXPECT_TRUE(known({}, 0, 80));
  EXPECT_FALSE(known({}, 0, 81));
  EXPECT_FALSE(known({}, 0, 44));
  EXPECT_FALSE(known({}, 0, nan));
  EXPECT_FALSE(known({}, nan));
  const Cup cup;
  EXPECT_FALSE(
      warning(cup, cup.zone().moved_in(0.1)).largest(1, 0, 60 * degree));
  for (const LayeredBody& body :
       {LayeredBody(cup.seat), LayeredBody({{3e-3, cup.seat}}, Backing::held()),
        LayeredBody({{3e-3, cup.seat}, {3e-3, cup.seat}}, Backing::rigid())}) {
    EXPECT_FALSE(
        detail::RimWarning(LayeredPair(0.01, cup.ball, body), cup.zone(), "")
            .largest(1, 0, 60 * degree));
  }
}

TEST(RimWarning, TurnsWithTheCupAndFallsWithWhatYieldsLess) {
  const Cup cup{.corner = 65};
  const detail::RimWarning up = warning(cup, cup.zone());
  const detail::RimWarning down = warning(
      cup, SeatZone(120 * degree, pi).with_edge({.angle = 65 * degree}));
  const auto one = at(up.largest(1, 0, 1));
  const auto other = at(down.largest(0, pi, 1));
  EXPECT_NEAR(one.pressure, other.pressure, 1e-12);
  EXPECT_NEAR(one.approach, other.approach, 1e-12);
  EXPECT_FALSE(up.largest(1, pi, 1));
  // In steps of the distance from the rim.
  EXPECT_LT(at(up.largest(1, 0, 0.9)).pressure, one.pressure);
  EXPECT_EQ(at(up.largest(1, 0, 54 * degree)).pressure,
            at(up.largest(1, 0, 51 * degree)).pressure);
  EXPECT_LT(at(warning({}, Cup().zone()).largest(1, 0, 1)).pressure,
            one.pressure);
  // A ball that yields takes its part of the approach.
  Cup soft = cup;
  soft.ball.youngs_modulus = 21e9;
  EXPECT_LT(at(warning(soft, soft.zone()).largest(1, 0, 1)).pressure,
            0.5 * one.pressure);
}

TEST(RimWarning, OfRingsIsThatOfRadialLoads) {
  const auto ring = [](Cup cup, double half, double direction = 90) {
    return warning(cup, SeatZone((90 - half) * degree, (90 + half) * degree))
        .largest(0, direction * degree, 0.5);
  };
  EXPECT_EQ(at(ring({}, 25)).pressure, 33);
  EXPECT_EQ(at(ring({.thickness = 1}, 25)).approach, 48);
  EXPECT_FALSE(ring({.thickness = 1, .seat = {110e9, 0.3}}, 25));
  EXPECT_FALSE(ring({.thickness = 1.1}, 25));
  EXPECT_FALSE(ring({}, 25, 88));
  EXPECT_FALSE(ring({}, 36));
  EXPECT_FALSE(ring({.seat = {210e9, 0.4}}, 25));
}

TEST(RimWarning, IsSaidEarlierWhereSeatsYieldMore) {
  const auto reach = [](const Cup& cup) {
    return warning(cup, cup.zone()).reach(1) / degree;
  };
  EXPECT_NEAR(reach({}), 10, 1e-12);
  EXPECT_NEAR(reach({.corner = 84}), 15, 1e-12);
  EXPECT_NEAR(reach({.seat = {1e9, 0.4}}), 15, 1e-12);
  EXPECT_TRUE(has_text(warning({}, Cup().zone()).sentence(1, "", true, 0, 1),
                       "are smaller"));
  const Cup sharp{.corner = 65};
  EXPECT_TRUE(has_text(warning(sharp, sharp.zone()).sentence(1, "", true, 0, 1),
                       "the peak is elsewhere"));
}

}  // namespace
}  // namespace contact::test::rim_warning_test
