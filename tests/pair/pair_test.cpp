#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "libcontact/pair/fit.hpp"
#include "libcontact/pair/friction_law.hpp"
#include "libcontact/pair/joint_geometry.hpp"
#include "libcontact/pair/layers.hpp"
#include "libcontact/pair/material.hpp"
#include "support/accuracy_report.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"

namespace contact::test::pair_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

std::vector<ElasticPair> pairs() {
  const std::vector<double> moduli = {1e3, 0.8e9, 1.1e11, 2.1e11, 1e13};
  const std::vector<double> ratios = {0, 0.2, 0.3, 0.46, 0.5};
  std::vector<ElasticPair> result;
  for (const double e1 : moduli) {
    for (const double e2 : moduli) {
      for (const double nu1 : ratios) {
        for (const double nu2 : ratios) {
          result.push_back(ElasticPair({e1, nu1}, {e2, nu2}));
        }
      }
    }
  }
  return result;
}

std::string label(const ElasticPair& pair) {
  std::ostringstream text;
  text << pair.inner().youngs_modulus << "," << pair.inner().poissons_ratio
       << "," << pair.outer().youngs_modulus << ","
       << pair.outer().poissons_ratio;
  return text.str();
}

TEST(ElasticPair, AgreesWithFiftyDigits) {
  // 5 to 7 roundings of at most 1.1e-16, measured 2.9e-16.
  AccuracyReport modulus("effective_modulus", 5e-16);
  AccuracyReport contact_modulus("contact_modulus", 5e-16);
  AccuracyReport ratio("modulus_ratio", 5e-16);
  AccuracyReport w1("inner_compliance_share", 5e-16);
  AccuracyReport w2("outer_compliance_share", 5e-16);
  // Differences of numbers up to 1: absolute errors.
  AccuracyReport alpha("dundurs_alpha, absolute", 4e-16);
  AccuracyReport beta("dundurs_beta, absolute", 4e-16);
  for (const ElasticPair& pair : pairs()) {
    const Real e1 = pair.inner().youngs_modulus;
    const Real e2 = pair.outer().youngs_modulus;
    const Real nu1 = pair.inner().poissons_ratio;
    const Real nu2 = pair.outer().poissons_ratio;
    const Real c1 = (1 - nu1 * nu1) / e1;
    const Real c2 = (1 - nu2 * nu2) / e2;
    // Dundurs' own definition, by the shear moduli and Kolosov's constants.
    const Real g1 = e1 / (2 * (1 + nu1));
    const Real g2 = e2 / (2 * (1 + nu2));
    const Real k1 = 3 - 4 * nu1;
    const Real k2 = 3 - 4 * nu2;
    const Real below = g1 * (k2 + 1) + g2 * (k1 + 1);
    const Real exact_alpha = (g1 * (k2 + 1) - g2 * (k1 + 1)) / below;
    const Real exact_beta = (g1 * (k2 - 1) - g2 * (k1 - 1)) / below;
    const std::string row = label(pair);
    modulus.add(Real(pair.effective_modulus()), Real(2 / (c1 + c2)), row);
    contact_modulus.add(Real(pair.contact_modulus()), Real(1 / (c1 + c2)), row);
    ratio.add(Real(pair.modulus_ratio()), Real(e1 / e2), row);
    w1.add(Real(pair.inner_compliance_share()), Real(c1 / (c1 + c2)), row);
    w2.add(Real(pair.outer_compliance_share()), Real(c2 / (c1 + c2)), row);
    alpha.add_error(double(abs(pair.dundurs_alpha() - exact_alpha)), row);
    beta.add_error(double(abs(pair.dundurs_beta() - exact_beta)), row);
  }
}

TEST(ElasticPair, ReducedModulusIsTwiceTheContactModulus) {
  // Equal bodies: E = E1/(1 - nu^2) in the paper's convention, E* half of it.
  const ElasticPair pair({2e11, 0.3}, {2e11, 0.3});
  EXPECT_DOUBLE_EQ(pair.effective_modulus(), 2e11 / 0.91);
  EXPECT_DOUBLE_EQ(pair.contact_modulus(), 1e11 / 0.91);
  EXPECT_TRUE(pair.identical());
  EXPECT_EQ(pair.dundurs_alpha(), 0);
  EXPECT_EQ(pair.dundurs_beta(), 0);
}

TEST(ElasticPair, ExchangingTheBodiesMirrorsTheMismatch) {
  for (const ElasticPair& pair : pairs()) {
    const ElasticPair swapped(pair.outer(), pair.inner());
    EXPECT_EQ(swapped.effective_modulus(), pair.effective_modulus());
    EXPECT_EQ(swapped.inner_compliance_share(), pair.outer_compliance_share());
    // Up to the rounding of multiplications that a processor joins with sums.
    EXPECT_NEAR(swapped.dundurs_alpha(), -pair.dundurs_alpha(), 1e-15);
    EXPECT_NEAR(swapped.dundurs_beta(), -pair.dundurs_beta(), 1e-15);
  }
}

TEST(ElasticPair, RigidBodies) {
  const Material soft{2e9, 0.4, "polymer"};
  for (const double nu : {0.0, 0.3, 0.5}) {
    const ElasticPair seat(soft, {infinity, nu, "rigid"});
    EXPECT_EQ(seat.modulus_ratio(), 0);
    EXPECT_EQ(seat.dundurs_alpha(), -1);
    EXPECT_EQ(seat.outer_compliance_share(), 0);
    EXPECT_DOUBLE_EQ(seat.contact_modulus(), 2e9 / 0.84);
    // The rigid body's Poisson's ratio has no influence.
    EXPECT_DOUBLE_EQ(seat.dundurs_beta(), -0.2 / 1.2);
    const ElasticPair ball({infinity, nu, "rigid"}, soft);
    EXPECT_EQ(ball.modulus_ratio(), infinity);
    EXPECT_EQ(ball.dundurs_alpha(), 1);
    EXPECT_DOUBLE_EQ(ball.dundurs_beta(), 0.2 / 1.2);
  }
}

TEST(ElasticPair, DimensionlessPairHasReducedModulusOne) {
  for (const double ratio :
       {0.0, 1e-310, 1e-6, 0.5, 1.0, 2.0, 1e6, 1e300, infinity}) {
    for (const double nu1 : {0.0, 0.3, 0.5}) {
      for (const double nu2 : {0.2, 0.45}) {
        const auto pair = ElasticPair::from_modulus_ratio(ratio, nu1, nu2);
        EXPECT_EQ(pair.modulus_ratio(), ratio);
        EXPECT_EQ(pair.inner().poissons_ratio, nu1);
        EXPECT_EQ(pair.outer().poissons_ratio, nu2);
        EXPECT_NEAR(pair.effective_modulus(), 1, 1e-15);  // 5 roundings
        const double share =
            pair.inner_compliance_share() + pair.outer_compliance_share();
        EXPECT_NEAR(share, 1, 2.3e-16);  // one rounding of each share
      }
    }
  }
  const auto pair = ElasticPair::from_modulus_ratio(0.5, 0.3, 0.3);
  const ElasticPair same({1e11, 0.3}, {2e11, 0.3});
  EXPECT_NEAR(pair.dundurs_alpha(), same.dundurs_alpha(), 1e-15);
  EXPECT_NEAR(pair.dundurs_beta(), same.dundurs_beta(), 1e-15);
}

using Real = boost::multiprecision::cpp_bin_float_50;

TEST(JointGeometry, KeepsWhatItIsGiven) {
  const auto ball = JointGeometry::ball(0.05, 5e-5, JointBody::body);
  EXPECT_EQ(ball.kind(), JointKind::ball);
  EXPECT_EQ(ball.radius(), 0.05);
  EXPECT_EQ(ball.radial_clearance(), 5e-5);
  EXPECT_EQ(ball.relative_clearance(), 5e-5 / 0.05);
  EXPECT_TRUE(std::isnan(ball.length()));
  EXPECT_EQ(ball.inner_body(), JointBody::body);
  EXPECT_EQ(ball.load_from_force(7), 7);
  EXPECT_EQ(ball.force_from_load(7), 7);
  EXPECT_DOUBLE_EQ(ball.pressure_unit(2e5), 8e7);

  const auto pin = JointGeometry::pin(0.02, 1e-5, 0.5);
  EXPECT_EQ(pin.kind(), JointKind::pin);
  EXPECT_EQ(pin.length(), 0.5);
  EXPECT_EQ(pin.inner_body(), JointBody::carrier);
  EXPECT_EQ(pin.load_from_force(7), 14);
  EXPECT_EQ(pin.force_from_load(14), 7);
  EXPECT_DOUBLE_EQ(pin.pressure_unit(1e6), 5e7);
}

TEST(JointGeometry, NotesAClearanceThatIsNotSmall) {
  EXPECT_TRUE(JointGeometry::ball(1, 0.015).validity_notes().empty());
  const auto notes =
      JointGeometry::ball(1, std::nextafter(0.015, 1.0)).validity_notes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0],
            "relative clearance 0.015 exceeds 0.015: the theory is of first "
            "order in it, and pressures are too high by 0.5 to 1.2 times it; "
            "small contacts are exact with a radial clearance of eps/(1 + "
            "eps/rho), 14.78 mm");
  EXPECT_TRUE(JointGeometry::ball(1, 1e-5).validity_notes().empty());
  const auto small =
      JointGeometry::pin(1, std::nextafter(1e-5, 0.0), 1).validity_notes();
  ASSERT_EQ(small.size(), 1u);
  EXPECT_EQ(small[0],
            "relative clearance 1e-05 is below 1e-05: form errors and "
            "temperature change such small clearances");
}

TEST(JointGeometry, NominalPressureIsThatOfTheProjectedArea) {
  EXPECT_DOUBLE_EQ(JointGeometry::ball(0.5, 1e-3).nominal_pressure(3),
                   12 / std::numbers::pi);
  EXPECT_DOUBLE_EQ(JointGeometry::pin(0.5, 1e-3, 2).nominal_pressure(3), 1.5);
  // d_k C of a GE 50; cups along their axis.
  const auto ball = JointGeometry::ball(0.033, 1e-5);
  EXPECT_DOUBLE_EQ(
      ball.with_seat(SeatZone::ring(0.028, 0.033)).nominal_pressure(1e5),
      1e5 / (0.066 * 0.028));
  EXPECT_DOUBLE_EQ(
      ball.with_seat(SeatZone::cup(std::numbers::pi / 6)).nominal_pressure(1e5),
      1e5 / (std::numbers::pi * 0.0165 * 0.0165));
}

TEST(LoadScale, AgreesWithFiftyDigits) {
  const Real& pi = boost::math::constants::pi<Real>();
  // 6 to 8 roundings of at most 1.1e-16, measured 2.8e-16.
  AccuracyReport forward("load_parameter", 5e-16);
  AccuracyReport back("load", 5e-16);
  for (const double radius : {1e-4, 0.05, 3.7}) {
    for (const double share : {1e-6, 1e-3, 0.04}) {
      for (const double e2 : {2e9, 2.07e11}) {
        const double clearance = share * radius;
        const ElasticPair pair({1.1e11, 0.33}, {e2, 0.29});
        const Real c1 = (1 - Real(0.33) * 0.33) / 1.1e11;
        const Real c2 = (1 - Real(0.29) * 0.29) / e2;
        const Real modulus = 2 / (c1 + c2);
        const Real relative = Real(clearance) / radius;
        const Real mu_1 = 2 * relative * radius * radius * modulus / 3;
        const Real lambda_1 = pi * relative * radius * modulus / 2;
        const auto ball = JointGeometry::ball(radius, clearance);
        const auto pin = JointGeometry::pin(radius, clearance, 1);
        const LoadScale ball_scale(ball, pair);
        const LoadScale pin_scale(pin, pair);
        for (const double value : {1e-9, 1.234, 7.7e8}) {
          forward.add(Real(ball_scale.load_parameter(value)),
                      Real(value / mu_1), "ball");
          forward.add(Real(pin_scale.load_parameter(value)),
                      Real(value / lambda_1), "pin");
          back.add(Real(ball_scale.load(value)), Real(value * mu_1), "ball");
          back.add(Real(pin_scale.load(value)), Real(value * lambda_1), "pin");
        }
      }
    }
  }
}

// Literature: example 1 of the paper prints mu = 0.55; by hand
// 3 * 2e5/(2 * 1e-3 * 0.05^2 * 2e11/0.91) = 0.546.
TEST(LoadScale, PaperExampleOne) {
  const LoadScale scale(JointGeometry::ball(0.05, 5e-5),
                        ElasticPair({2e11, 0.3}, {2e11, 0.3}));
  EXPECT_NEAR(scale.load_parameter(2e5), 0.546, 1e-15);
  EXPECT_NEAR(scale.load_parameter(2e5), 0.55, 0.005);
}

// x is the contact radius over the ball's (pin's) radius that Hertz's own
// formulas give: a^3 = 3 R_n r/(4 E*), b^2 = 4 P r/(pi E*), with
// 1/r = 1/rho1 - 1/rho2 = eps/rho1^2 to first order.
TEST(LoadScale, IsHertzTheoryForSmallLoads) {
  const ElasticPair pair({2e11, 0.3}, {1e11, 0.34});
  const double rho = 0.03;
  const double eps = 2e-5;
  const double curvature_radius = rho * rho / eps;
  const double e_star = pair.contact_modulus();
  const double force = 12.0;
  const double ball_radius =
      std::cbrt(3 * force * curvature_radius / (4 * e_star));
  const double pin_radius =
      std::sqrt(4 * force * curvature_radius / (std::acos(-1.0) * e_star));
  const LoadScale ball(JointGeometry::ball(rho, eps), pair);
  const LoadScale pin(JointGeometry::pin(rho, eps, 1), pair);
  // A dozen roundings on both sides.
  EXPECT_NEAR(contact::LoadScale::x_from_load_parameter(
                  JointKind::ball, ball.load_parameter(force)) /
                  (ball_radius / rho),
              1, 2e-15);
  EXPECT_NEAR(contact::LoadScale::x_from_load_parameter(
                  JointKind::pin, pin.load_parameter(force)) /
                  (pin_radius / rho),
              1, 2e-15);
}

TEST(LoadParameter, XAgreesWithFiftyDigits) {
  // glibc's cbrt, 2 ulp; two products.
  AccuracyReport forward("x_from_load_parameter", 5e-16);
  AccuracyReport back("load_parameter_from_x", 3e-16);
  for (double value = 1e-90; value < 1e90; value *= 1.73) {
    const std::string row = std::to_string(value);
    forward.add(
        Real(contact::LoadScale::x_from_load_parameter(JointKind::ball, value)),
        Real(cbrt(Real(value))), row);
    forward.add(
        Real(contact::LoadScale::x_from_load_parameter(JointKind::pin, value)),
        Real(2 * sqrt(Real(value))), row);
    back.add(
        Real(contact::LoadScale::load_parameter_from_x(JointKind::ball, value)),
        Real(Real(value) * value * value), row);
    back.add(
        Real(contact::LoadScale::load_parameter_from_x(JointKind::pin, value)),
        Real(Real(value) * value / 4), row);
  }
}

TEST(LoadParameter, NanAndLimits) {
  for (const JointKind kind : {JointKind::ball, JointKind::pin}) {
    EXPECT_TRUE(
        all_nan({contact::LoadScale::x_from_load_parameter(kind, nan),
                 contact::LoadScale::load_parameter_from_x(kind, nan)}));
    EXPECT_EQ(contact::LoadScale::x_from_load_parameter(kind, 0), 0);
    EXPECT_EQ(contact::LoadScale::x_from_load_parameter(kind, infinity),
              infinity);
    EXPECT_EQ(contact::LoadScale::load_parameter_from_x(kind, infinity),
              infinity);
  }
  EXPECT_TRUE(std::isnan(
      contact::LoadScale::x_from_load_parameter(JointKind::pin, -1)));
}

TEST(FrictionLaw, StressAndCoefficient) {
  const FrictionLaw law(0.1, 4e7);
  EXPECT_EQ(law.coefficient(), 0.1);
  EXPECT_EQ(law.adhesion(), 4e7);
  EXPECT_DOUBLE_EQ(law.coefficient_at(8e7), 0.6);
  EXPECT_DOUBLE_EQ(law.stress_at(8e7), 4.8e7);
  // The stress stays finite where the coefficient does not.
  EXPECT_EQ(law.stress_at(0), 4e7);
  EXPECT_EQ(law.coefficient_at(0), infinity);
  EXPECT_EQ(FrictionLaw(0.3).coefficient_at(0), 0.3);
  EXPECT_TRUE(all_nan({law.coefficient_at(nan), law.stress_at(nan)}));
}

constexpr std::array ends_mm = {3,   6,   10,  18,  30,  50, 80,
                                120, 180, 250, 315, 400, 500};

double um(const Fit& fit, Fit::Clearance which) {
  return fit.clearance(which) * 1e6;
}
double smallest_um(const Fit& fit) { return um(fit, Fit::Clearance::minimum); }
double largest_um(const Fit& fit) { return um(fit, Fit::Clearance::maximum); }

// How wide a grade is: a hole and a shaft without a deviation have it twice.
double tolerance_um(char grade, double size_mm) {
  const std::string hole{'H', grade}, shaft{'h', grade};
  return largest_um(Fit(hole, shaft, size_mm / 1e3)) / 2;
}

// A class other than the nominal position: a fit with H5 or h5 but without
// those.
struct Class {
  Fit fit;
  double near_um;
  double far_um;

  Class(const std::string& name, double size_mm)
      : fit(Fit::holes.contains(name) ? Fit(name, "h5", size_mm / 1e3)
                                      : Fit("H5", name, size_mm / 1e3)),
        near_um(smallest_um(fit)),
        far_um(largest_um(fit) - tolerance_um('5', size_mm)) {}
};

// Differences of numbers that are rounded in m.
constexpr double rounding_um = 1e-9;

TEST(Fit, ClassesArePublishedOnes) {
  const ReferenceTable table("iso_286_limits.csv");
  ASSERT_EQ(table.size(), 539U);
  for (const ReferenceTable::Row row : table) {
    SCOPED_TRACE(row.label());
    std::string name = row.text("class");
    const bool letter_alone = name.size() == 1;
    // Letters of press fits lie above the nominal size.
    const bool pressed = std::string("kmnprs").find(name[0]) != name.npos;
    if (letter_alone) name += pressed ? '6' : '7';
    const bool hole = Fit::holes.contains(name);
    const auto deviation = [&](bool near) {
      const double value =
          std::stod(row.text(hole == near ? "lower_um" : "upper_um"));
      return hole ? value : -value;
    };
    const double over_mm = std::stod(row.text("over_mm"));
    const double to_mm = std::stod(row.text("to_mm"));
    // Both ends of the range, which has the upper one.
    const double from_mm = std::max(3.0, std::nextafter(over_mm, 500));
    for (const double size_mm : {from_mm, to_mm}) {
      const Class computed(name, size_mm);
      if (!(letter_alone && pressed)) {
        EXPECT_NEAR(computed.near_um, deviation(true), rounding_um);
      }
      if (letter_alone && !pressed) continue;
      EXPECT_NEAR(computed.far_um, deviation(false), rounding_um);
    }
  }
}

// ISO 286-1, with D the geometric mean of the range in mm (the deviations also
// in Narayana's "Machine Drawing", table 15.4). It rounds in steps of 1 um that
// grow to 10 um, and not always to the nearest one. The bounds are the largest
// differences of the published values, measured, not a rule of the standard. Up
// to 3 mm its values differ from the formulas.
double rounding_of_the_standard_um(double value_um) {
  return value_um <= 100 ? 1.22 : value_um <= 200 ? 2.9 : 5;
}

TEST(Fit, EveryEntryIsItsFormulaRounded) {
  for (std::size_t i = 1; i < ends_mm.size(); ++i) {
    const double size_mm = ends_mm[i];
    SCOPED_TRACE(size_mm);
    const double d = std::sqrt(ends_mm[i - 1] * size_mm);
    const double unit_um = 0.45 * std::cbrt(d) + 0.001 * d;
    const auto expect = [](double table_um, double formula_um) {
      EXPECT_NEAR(table_um, formula_um,
                  rounding_of_the_standard_um(formula_um));
    };
    expect(tolerance_um('5', size_mm), 7 * unit_um);
    expect(tolerance_um('6', size_mm), 10 * unit_um);
    expect(tolerance_um('7', size_mm), 16 * unit_um);
    expect(tolerance_um('8', size_mm), 25 * unit_um);
    expect(tolerance_um('9', size_mm), 40 * unit_um);
    expect(Class("d6", size_mm).near_um, 16 * std::pow(d, 0.44));
    expect(Class("e6", size_mm).near_um, 11 * std::pow(d, 0.41));
    expect(Class("f6", size_mm).near_um, 5.5 * std::pow(d, 0.41));
    expect(Class("g6", size_mm).near_um, 2.5 * std::pow(d, 0.34));
    expect(Class("E6", size_mm).near_um, 11 * std::pow(d, 0.41));
    expect(Class("F6", size_mm).near_um, 5.5 * std::pow(d, 0.41));
    expect(Class("G6", size_mm).near_um, 2.5 * std::pow(d, 0.34));
    EXPECT_EQ(Class("h6", size_mm).near_um, 0);
    EXPECT_EQ(Class("H6", size_mm).near_um, 0);
  }
}

TEST(Fit, PublishedFits) {
  struct Published {
    const char* hole;
    const char* shaft;
    double size_mm, minimum_um, maximum_um;
  };
  for (const Published& fit : {
           // ANSI B4.2-1978 (R1994), table 12, preferred hole basis metric
           // clearance fits, as reprinted in Machinery's Handbook.
           Published{"H9", "d9", 3, 20, 70},
           {"H8", "f7", 3, 6, 30},
           {"H7", "g6", 3, 2, 18},
           {"H7", "h6", 3, 0, 16},
           {"H9", "d9", 5, 30, 90},
           {"H8", "f7", 5, 10, 40},
           {"H7", "g6", 5, 4, 24},
           {"H7", "h6", 5, 0, 20},
           // pressfit 0.1 (Python), its page.
           {"H7", "g6", 25, 7, 41},
           // Wikipedia, "Engineering fit".
           {"H8", "f7", 50, 25, 89},
           // K. L. Narayana, P. Kannaiah, K. V. Reddy, "Machine Drawing",
           // chapter 15: a bush of 50.000 to 50.025 mm and its shaft with these
           // clearances. That the fit is H7/f7 is concluded from them.
           {"H7", "f7", 50, 25, 75},
       }) {
    const Fit computed(fit.hole, fit.shaft, fit.size_mm / 1e3);
    SCOPED_TRACE(to_string(computed));
    EXPECT_NEAR(smallest_um(computed), fit.minimum_um, rounding_um);
    EXPECT_NEAR(largest_um(computed), fit.maximum_um, rounding_um);
  }
}

TEST(Fit, GivesAJointItsRadiusAndClearance) {
  const Fit fit("H7", "g6", 0.05);
  EXPECT_EQ(fit.name(), "H7/g6");
  EXPECT_EQ(fit.diameter(), 0.05);
  EXPECT_DOUBLE_EQ(fit.radius(), 0.0249915);  // 9 to 25 um less across
  EXPECT_EQ(fit.taken(), Fit::Clearance::mean);
  // The doubles nearest to the decimals.
  EXPECT_EQ(fit.radial_clearance(), 14.75e-6);
  EXPECT_EQ(Fit("H7", "g6", 0.05, Fit::Clearance::minimum).radial_clearance(),
            4.5e-6);
  EXPECT_EQ(Fit("H7", "g6", 0.05, Fit::Clearance::maximum).radial_clearance(),
            25e-6);
  EXPECT_EQ(to_string(fit),
            "fit H7/g6 at 50 mm: diametral clearance 9 to 50 um; mean 29.5 um "
            "taken");
  EXPECT_EQ(to_string(Fit("G7", "h6", 0.0105, Fit::Clearance::maximum)),
            "fit G7/h6 at 10.5 mm: diametral clearance 6 to 35 um; maximum 35 "
            "um taken");
}

// Half of the nominal size and half of the shaft's mean deviation, by the
// limits of a class that the tests above compare with published tables.
TEST(Fit, RadiusIsThatOfTheMiddleOfTheShaft) {
  for (const char* shaft : {"g6", "d9", "h5", "f7", "n6", "k6"}) {
    for (const double size_mm : {3, 10, 50, 80}) {
      const Class one(shaft, size_mm);
      EXPECT_NEAR(Fit("H8", shaft, size_mm / 1e3).radius(),
                  (size_mm / 1e3 - (one.near_um + one.far_um) / 2e6) / 2, 1e-17)
          << shaft << ' ' << size_mm;
    }
  }
  // The docstring's.
  const double above = 3 * (1 + 1e-9) / 1e3;
  EXPECT_NEAR(2 * Fit("H9", "d9", above).radius() / above, 1 - 0.015, 1e-6);
}

// Each alone would do.
TEST(LayeredPair, AllCoatingsTogetherAreThinnerThanTheRadius) {
  const Layer layer{0.6, {1, 0.3}};
  const LayeredBody rigid{{}, Backing::rigid()};
  EXPECT_ERROR(LayeredPair(1, {{layer, layer}, Backing::rigid()}, rigid),
               "coatings: thickness = 1.2 must be below the radius of 1 m");
  EXPECT_EQ(
      LayeredPair(1, {{layer}, Backing::rigid()}, rigid).relative_thickness(),
      0.6);
}

TEST(Fit, Sizes) {
  EXPECT_FALSE(Fit::has_size("g6", std::nextafter(0.003, 0)));
  EXPECT_TRUE(Fit::has_size("g6", 0.003));
  EXPECT_TRUE(Fit::has_size("g6", 0.5));
  EXPECT_FALSE(Fit::has_size("g6", std::nextafter(0.5, 1)));
  EXPECT_FALSE(Fit::has_size("g6", NAN));
}

}  // namespace
}  // namespace contact::test::pair_test
