#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/friction/friction_integrals.hpp"
#include "libcontact/friction/harmonics.hpp"
#include "libcontact/friction/models.hpp"
#include "libcontact/pressure/exact.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"
#include "support/wall.hpp"

// ExactPressure of contacts that interference keeps closed over most of the
// circle or sphere, and their friction.
namespace contact::test::interference_test {
namespace {

std::unique_ptr<const ExactPressure> law_of(JointKind kind,
                                            const LayeredPair& pair) {
  return std::isfinite(pair.relative_thickness())
             ? std::make_unique<const ExactPressure>(kind, pair)
             : std::make_unique<const ExactPressure>(kind, pair.surfaces());
}

void compare_with_rows(JointKind kind) {
  const bool is_ball = kind == JointKind::ball;
  // Below 120 deg the table of all joints, with walls good to 1e-6; above it
  // the table of interference.
  AccuracyReport sums[] = {{"S, below 120 deg", 1e-6}, {"S", 1e-7}};
  AccuracyReport centres[] = {{"p(0), below 120 deg", 1e-6}, {"p(0)", 1e-6}};
  AccuracyReport frictions[] = {{"chi, sigma_Y, sigma_Z, below 120 deg", 2e-6},
                                {"chi, sigma_Y, sigma_Z", 1e-7}};
  // Rows of one pair of bodies stand together.
  std::optional<LayeredPair> last;
  std::unique_ptr<const ExactPressure> shared;
  for (const ReferenceTable::Row row :
       ReferenceTable("preload/preload_" + to_string(kind) + ".csv")) {
    if (row.text("state") == "closed") continue;
    const double theta0 = row.value("theta0_deg") * degree;
    const LayeredPair pair = test::reference_pair(row);
    if (!last || !(pair == *last)) {
      shared = law_of(kind, pair);
      last = pair;
    }
    const ExactPressure& law = *shared;
    EXPECT_EQ(law.closing_half_angle(), pi) << row.label();
    const bool is_wide = theta0 > law.largest_half_angle();
    AccuracyReport& sum = sums[is_wide];
    AccuracyReport& centre = centres[is_wide];
    AccuracyReport& friction = frictions[is_wide];
    const double load = row.value("load");
    const double rho = row.value("rho");
    sum.add(law.force_ratio(theta0), row.value("sum_p") / load, row.label());
    centre.add(law.pressure(0, theta0) * load / (is_ball ? rho * rho : rho),
               row.value("p_centre"), row.label());
    if (!is_ball) continue;
    const FrictionIntegrals i =
        friction_integrals(law, theta0, SlipAxis::from_degrees(30));
    friction.add(i.coefficient.force, row.value("chi_30"), row.label());
    friction.add(i.coefficient.sliding, row.value("sigma_Y_30"), row.label());
    friction.add(i.coefficient.spinning, row.value("sigma_Z_30"), row.label());
  }
  if (is_ball) return;
  for (AccuracyReport& friction : frictions) friction.may_be_empty();
}

TEST(InterferencePressure, IsThatOfTheReference) {
  for (const JointKind kind : kinds) compare_with_rows(kind);
}

// The profile carries the load, sums up to S and is 0 at the edge.
TEST(InterferencePressure, ProfileCarriesTheLoad) {
  AccuracyReport load("load of the profile", 1e-6);
  AccuracyReport sum("S of the profile", 1e-6);
  AccuracyReport second("second moment of the profile", 1e-6);
  const contact::detail::GaussLegendre gauss(48);
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const bool is_ball = kind == JointKind::ball;
    for (const double thickness : {10.0, 0.3, 0.1}) {
      const auto made = law_of(kind, test::Wall{thickness, 0.4, false}.pair());
      const ExactPressure& law = *made;
      for (const double theta0_deg : {125.0, 150.0, 175.0, 179.9}) {
        const double theta0 = theta0_deg * degree;
        const std::string label = to_string(kind) + " t " +
                                  std::to_string(thickness) + " " +
                                  std::to_string(theta0_deg);
        double force = 0, all = 0, moment = 0;
        // t = theta0 (1 - u^2) takes the square root at the edge.
        for (int i = 0; i < gauss.node.size(); ++i) {
          const double u = (1 + gauss.node(i)) / 2;
          const double t = theta0 * (1 - u * u);
          const double dp = gauss.weight(i) * theta0 * u *
                            law.pressure(t, theta0) *
                            (is_ball ? 2 * pi * std::sin(t) : 2);
          force += dp * std::cos(t);
          all += dp;
          moment += dp * std::sin(t) * std::sin(t);
        }
        load.add(force, 1.0, label);
        sum.add(all, law.force_ratio(theta0), label);
        EXPECT_EQ(law.pressure(theta0 + 1e-9, theta0), 0) << label;
        EXPECT_NEAR(law.pressure(-1, theta0), law.pressure(1, theta0), 0);
        if (!is_ball) continue;
        second.add(viscous_friction_integrals(law, theta0, SlipAxis{1, 0})
                       .coefficient.spinning,
                   moment, label);
      }
    }
  }
}

// Slopes against differences of the pressure, up to the contact that is closed
// all round; what is tabulated is good to 1e-6 of the peak.
TEST(InterferencePressure, SlopesAreThoseOfThePressure) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    const auto made = law_of(kind, test::Wall{0.3, 0.4, false}.pair());
    const ExactPressure& law = *made;
    for (const double theta0_deg : {170.0, 179.9, 180.0}) {
      const double theta0 = theta0_deg * degree;
      for (const double t : {-2.0, -0.3, 0.3, 1.0, 2.0}) {
        constexpr double h = 1e-3;
        const double fall =
            (law.pressure(t - h, theta0) - law.pressure(t + h, theta0)) /
            (2 * h);
        EXPECT_NEAR(law.slope(t, theta0), fall, 1e-5 * law.peak(theta0))
            << theta0_deg << ' ' << t;
      }
    }
  }
}

// The step from one table to the other is at most the error of the first one at
// its end: 5e-6 of the peak near the edge of a ball whose wall is 0.1 radii
// thick.
TEST(InterferencePressure, GoesOnFromNarrowerContacts) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    for (const double thickness : {10.0, 0.3, 0.1}) {
      const auto made = law_of(kind, test::Wall{thickness, 0.4, false}.pair());
      const ExactPressure& law = *made;
      const double below = law.largest_half_angle();
      const double above = std::nextafter(below, pi);
      EXPECT_NEAR(law.force_ratio(above) / law.force_ratio(below), 1, 5e-6);
      for (const double share : {0.0, 0.3, 0.8, 0.99}) {
        EXPECT_NEAR(law.pressure(share * below, above),
                    law.pressure(share * below, below), 1e-5 * law.peak(below));
      }
      if (kind == JointKind::pin) continue;
      for (const double a_deg : {0.0, 30.0, 85.0, 90.0}) {
        const SlipAxis axis = SlipAxis::from_degrees(a_deg);
        const FrictionTriple a =
            friction_integrals(law, below, axis).coefficient;
        const FrictionTriple b =
            friction_integrals(law, above, axis).coefficient;
        EXPECT_NEAR(a.force, b.force, 5e-6) << a_deg;
        EXPECT_NEAR(a.sliding, b.sliding, 5e-6) << a_deg;
        EXPECT_NEAR(a.spinning, b.spinning, 5e-6) << a_deg;
      }
    }
  }
}

// p = p_0 + p_1 cos t: chi = (3 pi/8) cos a, the moment opposite w,
// sigma = (pi/4) S.
TEST(PressureHarmonics, OfAClosedContactAreTheClosedForms) {
  for (const double a_deg : {-70.0, 0.0, 30.0, 90.0}) {
    const SlipAxis axis = SlipAxis::from_degrees(a_deg);
    for (const double ratio : {1.0, 4.0, 1e6}) {
      const double harmonics[] = {ratio, 1};
      const FrictionTriple c =
          contact::detail::coefficients_by_harmonics(harmonics, axis);
      const double s = 3 * ratio;
      EXPECT_NEAR(c.force, 3 * pi / 8 * axis.cos, 1e-15);
      EXPECT_NEAR(c.sliding, pi / 4 * s * axis.cos, 1e-15 * s);
      EXPECT_NEAR(c.spinning, pi / 4 * s * axis.sin, 1e-15 * s);
    }
  }
}

TEST(InterferencePressure, HasNoneForALoadThroughTheBack) {
  const ElasticPair pair = ElasticPair::from_modulus_ratio(1, 0.3, 0.3);
  const ExactPressure law(JointKind::ball, pair,
                          InnerLoading::back(20 * degree));
  EXPECT_LT(law.closing_half_angle(), pi);
  EXPECT_TRUE(std::isnan(law.force_ratio(3)));
}

}  // namespace
}  // namespace contact::test::interference_test
