#include "libcontact/pair/seat_zone.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libcontact/base/units.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"

// Zones of seats: what they are made from, what they carry, what is refused.
namespace contact::test {
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
}  // namespace contact::test
