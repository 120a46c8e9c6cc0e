#include "libcontact/pair/seat_zone.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "libcontact/base/units.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"

// Zones of seats: what they are made from, what they carry, what is refused.
namespace contact::test::zone_test {
namespace {

SeatZone cup(double degrees) { return SeatZone::cup(degrees * degree); }

TEST(SeatZone, IsWhatItIsMadeFrom) {
  const SeatZone ring = SeatZone::ring(0.028, 0.033);
  EXPECT_NEAR(ring.from() / degree, 64.9, 0.01);  // GE 50
  EXPECT_DOUBLE_EQ(ring.from() + ring.to(), pi);
  EXPECT_TRUE(ring.carries(0) && ring.carries(pi / 2) && ring.carries(pi));
  EXPECT_TRUE(cup(60).carries(59.9 * degree));
  EXPECT_FALSE(cup(60).carries(60 * degree));
  EXPECT_FALSE(SeatZone(100 * degree, pi).carries(pi / 2));
  EXPECT_TRUE(SeatZone(100 * degree, pi).carries(pi));
  EXPECT_NEAR(cup(60).margin(10 * degree, 30 * degree), 20 * degree, 1e-15);
  EXPECT_EQ(SeatZone(0, pi).margin(1, 3), HUGE_VAL);
}

TEST(SeatZone, HasAnAxisAndSideFaces) {
  const SeatZone zone = cup(60).about({0, 3, -4});
  EXPECT_EQ(zone.axis(), (std::array<double, 3>{0, 0.6, -0.8}));
  EXPECT_EQ(zone.about(zone.axis()), zone);
  EXPECT_NE(zone, cup(60));
  EXPECT_TRUE(has_text(error_message([&] {
                         cup(60).about({0, 0, 0});
                       }),
                       "length of the axis = 0 must be above 0"));
  // Flat rims: 120 deg of a cup of 60, 65 of a ring of 25; a bore.
  EXPECT_NEAR(SeatZone(24 * degree, 56 * degree).side_angle(0), 114 * degree,
              1e-15);
  EXPECT_NEAR(zone.side_angle(1), 120 * degree, 1e-15);
  EXPECT_NEAR(SeatZone(65 * degree, 115 * degree).side_angle(0), 65 * degree,
              1e-15);
  EXPECT_NEAR(SeatZone(65 * degree, 115 * degree).side_angle(1), 65 * degree,
              1e-15);
}

TEST(SeatZone, EdgesMayBeTold) {
  const SeatZone zone = cup(60).with_edge({1e-3, 75 * degree, 0.05});
  EXPECT_EQ(zone.side_angle(1), 75 * degree);
  EXPECT_EQ(zone.moved_in(0.1).drawn().about({0, 0, 1}), zone);
  EXPECT_NE(zone, cup(60));
  EXPECT_EQ(zone.with_edge({}), cup(60));
  const auto refused = [](const SeatEdge& edge) {
    return error_message([&] { cup(60).with_edge(edge); });
  };
  EXPECT_TRUE(has_text(refused({.radius = -1}), "edge_radius = -1 must be"));
  EXPECT_TRUE(has_text(refused({.angle = pi}), "above 0 and below pi rad"));
  EXPECT_TRUE(has_text(refused({.report_distance = 0}), "above 0 and below 1"));
  EXPECT_TRUE(has_text(refused({.report_distance = nan}), "above 0"));
}

TEST(SeatZone, RimsMoveInAndTheSideFaceStays) {
  const SeatZone drawn(65 * degree, 115 * degree);
  const SeatZone moved = drawn.moved_in(5 * degree);
  EXPECT_NEAR(moved.from(), 70 * degree, 1e-15);
  EXPECT_NEAR(moved.to(), 110 * degree, 1e-15);
  EXPECT_DOUBLE_EQ(moved.side_angle(0), drawn.side_angle(0));
  EXPECT_NEAR(moved.drawn().from(), drawn.from(), 1e-15);
  EXPECT_NEAR(moved.moved_in(1 * degree).drawn().to(), drawn.to(), 1e-15);
  EXPECT_EQ(drawn.moved_in(0), drawn);
  // A pole is no rim.
  EXPECT_EQ(cup(60).moved_in(0.1).from(), 0);
  EXPECT_NEAR(cup(60).moved_in(0.1).to(), 60 * degree - 0.1, 1e-15);
  for (const double wrong : {-0.1, 25 * degree, std::nan("")}) {
    EXPECT_NE(error_message([&] { drawn.moved_in(wrong); }), "(no error)");
  }
}

TEST(SeatZone, Refuses) {
  const auto message = [](double from, double to) {
    return error_message([&] { SeatZone(from * degree, to * degree); });
  };
  EXPECT_EQ(message(10, 11), "(no error)");
  EXPECT_TRUE(has_text(message(10, 10.9), "must be at least 1 deg"));
  EXPECT_TRUE(has_text(message(-1, 30), "from = -0.01745"));
  EXPECT_TRUE(has_text(message(30, 181), "must be above 0 to pi rad"));
  EXPECT_TRUE(has_text(message(NAN, 30), "must be 0 to pi rad"));
  EXPECT_TRUE(
      has_text(error_message([] { SeatZone::ring(0.1, 0.05); }),
               "ring width = 0.1 must be above 0 m and less than the ball's"));
}

}  // namespace
}  // namespace contact::test::zone_test
