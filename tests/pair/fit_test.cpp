#include "libcontact/pair/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "support/reference_table.hpp"

namespace {

using contact::Fit;
using contact::FitClearance;
using contact::test::ReferenceTable;

constexpr std::array ends_mm = {3,   6,   10,  18,  30,  50, 80,
                                120, 180, 250, 315, 400, 500};

double um(const Fit& fit, FitClearance which) {
  return fit.clearance(which) * 1e6;
}
double smallest_um(const Fit& fit) { return um(fit, FitClearance::minimum); }
double largest_um(const Fit& fit) { return um(fit, FitClearance::maximum); }

// How wide a grade is: a hole and a shaft without a deviation have it twice.
double tolerance_um(char grade, double size_mm) {
  const std::string hole{'H', grade}, shaft{'h', grade};
  return largest_um(Fit(hole, shaft, size_mm / 1e3)) / 2;
}

// A class beside the nominal size: a fit with H5 or h5 without those.
struct Class {
  Fit fit;
  double near_um;
  double far_um;

  Class(const std::string& name, double size_mm)
      : fit(contact::fit_holes.contains(name) ? Fit(name, "h5", size_mm / 1e3)
                                              : Fit("H5", name, size_mm / 1e3)),
        near_um(smallest_um(fit)),
        far_um(largest_um(fit) - tolerance_um('5', size_mm)) {}
};

// Differences of numbers that are rounded in m.
constexpr double rounding_um = 1e-9;

TEST(Fit, ClassesArePublishedOnes) {
  const ReferenceTable table("iso_286_limits.csv");
  ASSERT_EQ(table.size(), 401U);
  for (const ReferenceTable::Row row : table) {
    SCOPED_TRACE(row.label());
    std::string name = row.text("class");
    const bool letter_alone = name.size() == 1;
    if (letter_alone) name += '7';
    const bool hole = contact::fit_holes.contains(name);
    const auto deviation = [&](bool near) {
      return std::abs(
          std::stod(row.text(hole == near ? "lower_um" : "upper_um")));
    };
    const double over_mm = std::stod(row.text("over_mm"));
    const double to_mm = std::stod(row.text("to_mm"));
    // Both ends of the range, which has the upper one.
    const double from_mm = std::max(3.0, std::nextafter(over_mm, 500));
    for (const double size_mm : {from_mm, to_mm}) {
      const Class computed(name, size_mm);
      EXPECT_NEAR(computed.near_um, deviation(true), rounding_um);
      if (letter_alone) continue;
      EXPECT_NEAR(computed.far_um, deviation(false), rounding_um);
    }
  }
}

// ISO 286-1, with D the geometric mean of the range in mm (the deviations also
// in Narayana's "Machine Drawing", table 15.4). It rounds in steps of 1 um that
// grow to 10 um, and not always to the nearest one. The bounds are the largest
// differences of the published values, measured, not a rule of the standard.
// Up to 3 mm its values are not those of the formulas.
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
  EXPECT_EQ(fit.radius(), 0.025);
  EXPECT_EQ(fit.taken(), FitClearance::mean);
  // The doubles nearest to the decimals.
  EXPECT_EQ(fit.radial_clearance(), 14.75e-6);
  EXPECT_EQ(Fit("H7", "g6", 0.05, FitClearance::minimum).radial_clearance(),
            4.5e-6);
  EXPECT_EQ(Fit("H7", "g6", 0.05, FitClearance::maximum).radial_clearance(),
            25e-6);
  EXPECT_EQ(to_string(fit),
            "fit H7/g6 at 50 mm: diametral clearance 9 to 50 um; mean 29.5 um "
            "taken");
  EXPECT_EQ(to_string(Fit("G7", "h6", 0.0105, FitClearance::maximum)),
            "fit G7/h6 at 10.5 mm: diametral clearance 6 to 35 um; maximum 35 "
            "um taken");
}

// What the docstring of Fit::radius() says of the deviation that it leaves out.
TEST(Fit, DeviationOfTheShaftThatIsLeftOut) {
  const auto percent = [](const char* shaft, double size_mm) {
    const Class one(shaft, size_mm);
    return (one.near_um + one.far_um) / 2 / (10 * size_mm);
  };
  EXPECT_NEAR(percent("g6", 50), 0.034, 5e-4);
  EXPECT_NEAR(percent("d9", 50), 0.22, 5e-3);
  const auto above = [](double size_mm) { return size_mm * (1 + 1e-9); };
  EXPECT_NEAR(percent("d9", above(3)), 1.5, 1e-6);
  for (const double size_mm :
       {6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400}) {
    EXPECT_LT(percent("d9", above(size_mm)), 1.0) << size_mm;
  }
}

TEST(Fit, Sizes) {
  EXPECT_FALSE(Fit::has_size(std::nextafter(0.003, 0)));
  EXPECT_TRUE(Fit::has_size(0.003));
  EXPECT_TRUE(Fit::has_size(0.5));
  EXPECT_FALSE(Fit::has_size(std::nextafter(0.5, 1)));
  EXPECT_FALSE(Fit::has_size(NAN));
}

}  // namespace
