#include "libcontact/play/published_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "libcontact/play/force_law.hpp"
#include "play/reference_joint.hpp"

// The laws of the literature against the exact one, as the table of
// docs/how-to/play.md has it, which was made by another program.
namespace contact::test::published_forces_test {
namespace {

using namespace contact;

constexpr double negative = -1e9;  // outside: the approach is below 0

struct Row {
  double force;
  double penetration;           // exact, m
  std::vector<double> percent;  // errors of the eight laws
};
struct Pin {
  const char* name;
  JointSpec joint;
  std::vector<Row> rows;
};

std::vector<Pin> pins() {
  const Material steel = {207e9, 0.3};
  const auto ring = [&](double rho, double clearance, double length,
                        double thickness) -> JointSpec {
    return {.geometry = JointGeometry::pin(rho, clearance, length),
            .inner = steel,
            .outer = {{{thickness, steel}}, Backing::held()}};
  };
  const Material other = {210e9, 0.3};
  const JointSpec bush = {
      .geometry = JointGeometry::pin(0.025, 25e-6, 0.04),
      .inner = other,
      .outer = {{{0.005, {110e9, 0.34}}, {0.025, other}}, Backing::held()}};
  const JointSpec liner = {
      .geometry = JointGeometry::pin(0.025, 25e-6, 0.04),
      .inner = other,
      .outer = {{{0.0004, {1e9, 0.42}}}, Backing::rigid()}};
  const double none = negative;
  return {
      {"A",
       ring(0.0095, 0.0005, 0.02, 0.0285),
       {{100, .163e-6, {-7, -4, 10, 78, 11, 707, 465, -3}},
        {2000, 2.42e-6, {-9, -6, 14, 105, 15, 301, 182, -14}},
        {20000, 17.8e-6, {-12, -8, 19, 143, 20, 153, 81, -16}}}},
      {"B",
       ring(0.02, 2e-5, 0.04, 0.06),
       {{1e3, .478e-6, {-12, -8, 18, 112, 18, 171, 96, -14}},
        {1e4, 3.20e-6, {-18, -12, 26, 167, 26, 88, 43, -25}},
        {1e5, 18.9e-6, {-47, -37, 27, 266, 27, 48, 39, -26}}}},
      {"C",
       ring(0.02, 5e-6, 0.04, 0.06),
       {{1e3, .382e-6, {-15, -10, 22, 140, 22, 114, 58, -5}},
        {1e4, 2.33e-6, {-29, -21, 31, 224, 31, 62, 36, -23}},
        {1e5, 15.2e-6, {-98, -85, -6, 290, -6, 15, 44, -42}}}},
      {"D",
       ring(0.0095, 0.0005, 0.02, 0.0095),
       {{100, .195e-6, {-22, -20, -8, 49, -7, 575, 372, -19}},
        {20000, 24.0e-6, {-35, -32, -12, 80, -11, 88, 34, -37}}}},
      {"E",
       bush,
       {{1e3, .663e-6, {-12, -8, 18, 107, 11, 128, 91, -16}},
        {8e4, 20.5e-6, {-41, -30, 36, 267, 19, 37, 47, -18}}}},
      {"F",
       liner,
       {{1e3, .691e-6, {1541, 1803, 3449, 9164, 3022, 3503, 3677, 2010}},
        {5e4, 11.1e-6, {none, none, none, 17051, none, 2932, 8376, 2620}}}},
  };
}

TEST(PublishedForces, AreAsFarFromTheExactLawAsThePageSays) {
  for (const Pin& pin : pins()) {
    const ForceLaw exact(pin.joint);
    const auto laws =
        published_force_laws(pin.joint.geometry, pin.joint.pair());
    ASSERT_EQ(laws.size(), 8u);
    for (const Row& row : pin.rows) {
      const double penetration = exact.penetration_of_force(row.force);
      EXPECT_NEAR(penetration / row.penetration, 1, 4e-3) << pin.name;
      for (std::size_t i = 0; i < laws.size(); ++i) {
        const std::string label = std::string(pin.name) + ", " +
                                  std::to_string(row.force) + ", " +
                                  std::string(laws[i].name);
        const PublishedApproach at = laws[i].at(row.force);
        if (row.percent[i] == negative) {
          EXPECT_LT(at.penetration, 0) << label;
          EXPECT_TRUE(at.outside) << label;
        } else {
          // Whole percents, of an exact law that was good to 0.2 % at the
          // smallest forces.
          const double share = row.force == 100 ? 2e-3 : 0;
          EXPECT_NEAR(100 * (at.penetration / penetration - 1), row.percent[i],
                      0.502 + share * (100 + row.percent[i]))
              << label;
        }
      }
    }
  }
}

TEST(PublishedForces, SlopesAreThoseOfTheLaws) {
  const JointSpec joint = test::slider_crank_joint();
  for (const auto& law : published_force_laws(joint.geometry, joint.pair())) {
    for (const double force : {10.0, 1e3, 1e5}) {
      const double step = 1e-4 * force;
      const PublishedApproach at = law.at(force);
      EXPECT_FALSE(at.outside) << law.name;
      const double slope =
          2 * step /
          (law.at(force + step).penetration - law.at(force - step).penetration);
      EXPECT_NEAR(at.slope / slope, 1, 1e-7) << law.name;
    }
  }
}

TEST(PublishedForces, JohnsonTurnsRoundWhereItsNoteSays) {
  const JointSpec joint = test::slider_crank_joint();
  const auto johnson = published_force_laws(joint.geometry, joint.pair())[0];
  const double turn = 4 * std::acos(-1.0) * joint.pair().contact_modulus() *
                      0.02 * 0.0005 * std::exp(-2);
  EXPECT_FALSE(johnson.at(0.999 * turn).outside);
  EXPECT_TRUE(johnson.at(1.001 * turn).outside);
}

// 5 um to 10 mm.
TEST(PublishedForces, PereiraIsOutsideItsClearances) {
  JointSpec joint = test::slider_crank_joint();
  const auto outside = [&](double clearance) {
    return published_force_laws(JointGeometry::pin(0.0095, clearance, 0.02),
                                joint.pair())
        .back()
        .at(1)
        .outside;
  };
  EXPECT_TRUE(outside(4.9e-6));
  EXPECT_FALSE(outside(5.1e-6));
}

// Small contacts of balls are Hertz'.
TEST(PublishedForces, BallsAreHertz) {
  const JointSpec ball = test::steel_ball();
  const ForceLaw exact(ball);
  const auto laws = published_force_laws(ball.geometry, ball.pair());
  ASSERT_EQ(laws.size(), 1u);
  const double force = exact.force(exact.smallest_penetration());
  EXPECT_NEAR(laws[0].at(force).penetration / exact.smallest_penetration(), 1,
              3e-3);
}

}  // namespace
}  // namespace contact::test::published_forces_test
