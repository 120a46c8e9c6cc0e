#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "multibody/motion/motion.hpp"
#include "multibody_support/wheel.hpp"

// Events within a step are found, at their times.
namespace multibody::test::motion_events_test {
namespace {

// Halving the step makes the error 16 times smaller.
// An event is looked for at the end of a step, which is then done again up to
// it: what comes before the event must still be there at its own time.
TEST(MotionEvents, TimesBeforeAnEventInTheSameStepAreTheirOwn) {
  const System system(heavy_carrier(), {wheel(20, 0.4)});
  // Steps get shorter and shorter towards t = 1.
  const auto torque = [](double t) { return 1 / (1.0625 - t); };
  const auto run = [&](bool event) {
    Motion motion(system, {}, std::make_shared<Torque>(torque), start_of(1),
                  on_fixed_carrier());
    int events = 0;
    // Crossed from time to time.
    motion.add_event({[&](const MotionSample& sample) {
      return event ? std::sin(40 * sample.angle(0) + 1) : 1.0;
    }});
    std::vector<double> angles;
    for (int i = 1; i <= 1000; ++i) {
      while (motion.advance_to(1e-3 * i) == Stop::event) ++events;
      angles.push_back(motion.sample().angle(0));
    }
    EXPECT_EQ(events > 0, event);
    return angles;
  };
  const auto with = run(true);
  const auto without = run(false);
  for (std::size_t i = 0; i < with.size(); ++i) {
    // The tolerances of the steps, and of the interpolation between them.
    EXPECT_NEAR(with[i], without[i], 1e-7) << i;
  }
}

// A wheel that turns back just after a level, both within a long step: its
// angle is a polynomial, which the integrators follow exactly.
TEST(MotionEvents, EventsThatCrossTwiceWithinAStepAreFound) {
  const double about = 0.4, rate = 3, brake = 2;
  const double peak = rate * rate * about / (2 * brake);
  for (const Integrator integrator : {Integrator::adaptive, Integrator::rk4}) {
    for (const double share : {0.5, 0.999, 1 - 1e-6, 1 + 1e-6}) {
      const double level = share * peak;
      MotionOptions options =
          on_fixed_carrier(integrator, 0.9);  // the peak comes at 0.6 s
      options.longest_step = 3;
      MotionStart start = turning(rate);
      Motion motion(System(heavy_carrier(), {wheel(20, about)}), {},
                    std::make_shared<Torque>([=](double) { return -brake; }),
                    start, options);
      const auto above = [=](const MotionSample& s) {
        return s.angle(0) - level;
      };
      motion.add_event({above, MotionEvent::Crossing::rising});
      motion.add_event({above, MotionEvent::Crossing::falling});
      // From above, and through a function that needs forces.
      motion.add_event(
          {[=](const MotionSample& s) { return level - s.hinge(0).angle; },
           MotionEvent::Crossing::either});
      if (share > 1) {
        EXPECT_EQ(motion.advance_to(3), Stop::time);
        continue;
      }
      // level = rate t - brake t^2/(2 about)
      const double middle = rate * about / brake;
      const double half = middle * std::sqrt(1 - share);
      for (const double time : {middle - half, middle + half}) {
        int seen = 0;
        for (int k = 0; k < 2; ++k) {
          ASSERT_EQ(motion.advance_to(3), Stop::event) << share;
          seen |= 1 << motion.event();
          // The angle is known to 1e-15 of it, and is flat at the peak.
          EXPECT_NEAR(motion.time(), time, 1e-12 + 1e-14 / half) << share;
        }
        EXPECT_EQ(seen, time < middle ? 0b101 : 0b110);
      }
      EXPECT_EQ(motion.advance_to(3), Stop::time);
      if (integrator == Integrator::adaptive) {
        EXPECT_LT(motion.counts().steps, 60);
      }
    }
  }
}

// A wheel that goes to and fro within a step: its angle is a polynomial of
// degree 4, which rk4 follows exactly, with three crossings of 0. At the points
// of the step it is below -0.24. The polynomial through them stays below -0.16,
// with an uncertainty of 0.39.
TEST(MotionEvents, CrossingsThatThePolynomialMissesAreFound) {
  MotionOptions options = on_fixed_carrier(Integrator::rk4, 1);
  Motion motion(System(heavy_carrier(), {wheel(20, 0.4)}), {}, nullptr,
                start_of(1), options);
  motion.add_event({[](const auto& sample) {
                      return std::sin(13 * (sample.time() - 0.5)) - 0.85;
                    },
                    MotionEvent::Crossing::rising});
  ASSERT_EQ(motion.advance_to(1), Stop::event);
  EXPECT_NEAR(motion.time(),
              0.5 + (std::asin(0.85) - 2 * std::numbers::pi) / 13, 1e-12);
}

// An angle a u^2 + q (1/4 - u^2)^2 + c, u = t - 1/2, that rk4 follows exactly:
// by its ends and rates alone it is q (1/4 - u^2)^2 higher and stays above 0.
TEST(MotionEvents, CrossingsThatTheStatesInBetweenMissAreFound) {
  const double a = 1, q = -2e-3, c = -q / 32, about = 0.4;
  const auto torque = [=](double t) {
    const double u = t - 0.5;
    return about * (2 * a + q * (12 * u * u - 1));
  };
  MotionStart start = turning(-a);
  start.bodies[0].angle = a / 4 + c;
  MotionOptions options = on_fixed_carrier(Integrator::rk4, 1);
  Motion motion(System(heavy_carrier(), {wheel(20, about)}), {},
                std::make_shared<Torque>(torque), start, options);
  motion.add_event({[](const auto& sample) { return sample.angle(0); },
                    MotionEvent::Crossing::falling});
  ASSERT_EQ(motion.advance_to(1), Stop::event);
  // The root of q s^2 + (a - q/2) s + q/16 + c in s = u^2.
  const double b = a - q / 2, d = q / 16 + c;
  const double s = -2 * d / (b + std::sqrt(b * b - 4 * q * d));
  EXPECT_NEAR(motion.time(), 0.5 - std::sqrt(s), 1e-10);
}

// Exactly 0 where a step ends.
TEST(MotionEvents, EventsAtTheEndOfAStepComeOnce) {
  for (const double sign : {1., -1.}) {
    MotionOptions options = on_fixed_carrier(Integrator::rk4, 0.25);
    Motion motion(System(heavy_carrier(), {wheel(20, 0.4)}), {}, nullptr,
                  start_of(1), options);
    motion.add_event(
        {[=](const auto& sample) { return sign * (sample.time() - 1); },
         sign > 0 ? MotionEvent::Crossing::rising
                  : MotionEvent::Crossing::falling});
    ASSERT_EQ(motion.advance_to(2), Stop::event);
    EXPECT_EQ(motion.time(), 1);
    EXPECT_EQ(motion.advance_to(2), Stop::time);
  }
}

TEST(MotionEvents, EveryCrossingWithinAStepIsFoundInOrder) {
  const double about = 0.4;
  const double a = 0.2, b = 0.6, c = 0.9;  // and 0
  using Crossing = MotionEvent::Crossing;
  const auto run = [&](Crossing way) {
    MotionOptions options = on_fixed_carrier(Integrator::rk4, 1);
    MotionStart start = turning(-a * b * c);
    // x'' of t (t - a) (t - b) (t - c)
    Motion motion(System(heavy_carrier(), {wheel(20, about)}), {},
                  std::make_shared<Torque>([&](double t) {
                    return about * (12 * t * t - 6 * (a + b + c) * t +
                                    2 * (a * b + b * c + c * a));
                  }),
                  start, options);
    motion.add_event({[](const MotionSample& s) {
                        return s.angle(0) - (s.time() == 0 ? 1e-9 : 0);
                      },
                      way});
    std::vector<double> times;
    while (motion.advance_to(1) == Stop::event) times.push_back(motion.time());
    EXPECT_EQ(motion.counts().steps, 1 + static_cast<long>(times.size()));
    return times;
  };
  const auto expect = [](const std::vector<double>& times,
                         const std::vector<double>& right) {
    ASSERT_EQ(times.size(), right.size());
    for (std::size_t i = 0; i < right.size(); ++i) {
      EXPECT_NEAR(times[i], right[i], 1e-14) << i;  // rounding
    }
  };
  expect(run(Crossing::either), {a, b, c});
  expect(run(Crossing::rising), {a, c});
  expect(run(Crossing::falling), {b});
}

// The thread of a pendulum pulls most at the bottom, m g (3 cos x - 2 cos x0):
// a level just below that is passed twice in a swing, between two steps.
TEST(MotionEvents, ReactionsThatPeakWithinAStepAreFound) {
  const double l = 0.8, mass = 3, amplitude = 1.2;
  Body body{HingeKind::axis, mass, Matrix3d::Zero()};
  body.hinge_from_com = Vector3d(0, l, 0);
  MotionStart start = start_of(1);
  start.bodies[0].angle = amplitude;
  const double most = mass * g * (3 - 2 * std::cos(amplitude));
  const double period =
      4 * std::comp_ellint_1(std::sin(amplitude / 2)) * std::sqrt(l / g);
  for (const Integrator integrator : {Integrator::adaptive, Integrator::rk4}) {
    for (const double share : {0.99, 1 - 1e-6, 1 + 1e-6}) {
      MotionOptions options = on_fixed_carrier(integrator, 0.01);
      Motion motion(System(heavy_carrier(), {body}), {}, nullptr, start,
                    options);
      const double level = share * most;
      motion.add_event({[=](const MotionSample& s) {
                          return s.hinge(0).reaction_force.norm() / level - 1;
                        },
                        MotionEvent::Crossing::rising});
      for (int swing = 0; swing < 10 && share < 1; ++swing) {
        ASSERT_EQ(motion.advance_to(100), Stop::event) << share << swing;
        const double angle = std::acos(
            (share * (3 - 2 * std::cos(amplitude)) + 2 * std::cos(amplitude)) /
            3);
        // The peak drifts with the energy, by 1e-9 of it in 10 swings: 4e-8
        // and, for the higher level, 5e-6 was seen.
        EXPECT_NEAR(std::abs(motion.sample().angle(0)), angle, 2e-5);
        EXPECT_NEAR(motion.time(), (0.25 + 0.5 * swing) * period, 0.05);
      }
      if (share > 1) {
        EXPECT_EQ(motion.advance_to(5 * period), Stop::time);
      }
      std::printf("%ld steps, %ld evaluations\n", motion.counts().steps,
                  motion.counts().evaluations);
    }
  }
}

}  // namespace
}  // namespace multibody::test::motion_events_test
