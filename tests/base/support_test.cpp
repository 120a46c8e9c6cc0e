#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "libcontact/base/error.hpp"
#include "support/accuracy_report.hpp"
#include "support/friction_reference.hpp"
#include "support/reference_table.hpp"

namespace contact::test::support_test {
namespace {

TEST(ReferenceTable, KeepsEveryDigit) {
  const ReferenceTable table("friction_integrals.csv");
  ASSERT_EQ(table.size(), 221u);
  EXPECT_EQ(table[0].text("chi"), "1.0000000025384784974");
  EXPECT_EQ(table[0].value("theta0_deg"), 0.01);
  using Real = boost::multiprecision::cpp_bin_float_50;
  EXPECT_EQ(table[0].value<Real>("chi"), Real("1.0000000025384784974"));
  EXPECT_NE(table[0].value<Real>("chi"), Real(table[0].value("chi")));
  EXPECT_EQ(table[0].label(),
            "friction_integrals.csv:5: theta0_deg=0.01, alpha_deg=0");
}

TEST(ReferenceTable, SaysWhatIsMissing) {
  EXPECT_THROW(ReferenceTable("none.csv"), Error);
  const ReferenceTable table("friction_integrals.csv");
  EXPECT_THROW(table[0].text("none"), Error);
}

TEST(AccuracyReport, MeasuresRelativeErrors) {
  AccuracyReport report("halves", 0.5);
  report.add(2.0, 2.0, "same");
  report.add(-1.0, -2.0, "half");
  EXPECT_EQ(report.max(), 0.5);
  EXPECT_DOUBLE_EQ(report.rms(), 0.5 / std::sqrt(2.0));
  EXPECT_EQ(report.worst(), "half");
}

TEST(AccuracyReport, ZeroAndNanAreExact) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(relative_error(0.0, 0.0), 0);
  EXPECT_EQ(relative_error(1e-300, 0.0), infinity);
  EXPECT_EQ(relative_error(nan, 1.0), infinity);
  EXPECT_EQ(relative_error(nan, 0.0), infinity);
}

TEST(AccuracyReport, FailsOverBudgetAndWithoutRows) {
  static AccuracyReport over("over", 1e-3);
  over.add(1.01, 1.0, "bad row");
  EXPECT_NONFATAL_FAILURE(over.check(), "bad row");
  static AccuracyReport empty("empty", 1);
  EXPECT_NONFATAL_FAILURE(empty.check(), "no row");
}

TEST(FrictionReference, CoefficientsAreTheRatiosOfTheTable) {
  for (const FrictionReference& row : friction_reference()) {
    const FrictionIntegrals& f = row.expected;
    // Two roundings of the table's cells and one division.
    EXPECT_LE(relative_error(f.pressure.force / f.normal, f.coefficient.force),
              4e-16)
        << row.label;
  }
}

}  // namespace
}  // namespace contact::test::support_test
