// A pin on points of the circle: against the closed forms of contacts that are
// closed all round, and exact contacts without wear.
#include "libcontact/duty/steps/worn_circle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/pin.hpp"
#include "support/numbers.hpp"

namespace contact::test::worn_circle_test {
namespace {

using detail::WornCircle;
using Eigen::VectorXd;

const Material steel{2.1e11, 0.3};
const Material polymer{1e9, 0.4};
const LayeredPair lined(0.025, steel, {{{0.0025, polymer}}, Backing::rigid()});

double sum_factor(const WornCircle& circle, double load,
                  const WornCircle::Contact& contact) {
  return 2 * pi * circle.radius() * contact.pressure.mean() / load;
}

// Closed all round the pressure has two harmonics, which fade and stay.
TEST(WornCircle, FadesAlikeWhileClosed) {
  const WornCircle circle(lined);
  const double c0 = circle.mean_compliance();
  const double i = 2e-5;
  const double load = 0.3 * pi * circle.radius() * i / c0;
  const double first = load / (pi * circle.radius());
  for (const bool seat : {true, false}) {
    VectorXd gap = VectorXd::Constant(circle.size(), -i);
    double sigma = 0;
    WornCircle::Contact now;
    for (int step = 0; step < 100; ++step) {
      const double part = 0.01 * c0;
      now = circle.wear({load, 0}, gap,
                        seat ? detail::CircleSprings{.local = part}
                             : detail::CircleSprings{.mean = part});
      sigma += part;
    }
    EXPECT_EQ(now.half_angle, pi);
    const double p0 = i / c0 * std::exp(-sigma / c0);
    for (Eigen::Index k = 0; k < circle.size(); k += 20) {
      // A third of the third power of the step, a hundred times.
      EXPECT_NEAR(now.pressure[k], p0 + first * std::cos(circle.angle()[k]),
                  1e-5 * p0);
    }
    EXPECT_NEAR(gap[0], -c0 * p0 + (seat ? sigma * first : 0), 1e-5 * i);
  }
}

// Without wear it is the contact that the exact solver has, with a clearance.
TEST(WornCircle, IsTheExactContactWithoutWear) {
  const PinContact exact(lined);
  for (const int points : {360, 720}) {
    const WornCircle circle(lined, points);
    for (const double degrees : {35.0, 60.0, 80.0}) {
      const double clearance = 5e-5;
      const double theta0 = degrees * degree;
      const double modulus = lined.surfaces().effective_modulus();
      const double load =
          pi / 2 * clearance * modulus / exact.reciprocal_load(theta0);
      const ContactPressure pressure = exact.pressure(theta0);
      // On a point, between two and anywhere.
      for (const double direction : {0.0, pi / points, 2.345}) {
        const WornCircle::Contact c = circle.press(
            load * Eigen::Vector2d(std::cos(direction), std::sin(direction)),
            VectorXd::Constant(circle.size(), clearance));
        EXPECT_EQ(c.status, Status::ok);
        EXPECT_NEAR(c.half_angle / degree, degrees, 90.0 / points);
        EXPECT_NEAR(sum_factor(circle, load, c) / pressure.force_ratio(), 1,
                    3e-4 * 360 / points);
      }
    }
  }
}

}  // namespace
}  // namespace contact::test::worn_circle_test
