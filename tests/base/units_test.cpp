#include "libcontact/base/units.hpp"
#include "support/numbers.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

namespace contact::test::units_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

TEST(Units, SineCosineDegreesToFullRelativeAccuracy) {
  const Real degree = boost::math::constants::pi<Real>() / 180;
  double largest = 0;
  for (const double x :
       {1e-300, 1e-9, 0.01, 14.9, 29.5, 45.0, 60.1, 89.5, 89.99, 90 - 1e-13,
        90 + 1e-13, 179.999, 359.9, -1e-7, -89.999, -45.0, -150.0, 720.25}) {
    const SineCosine result = detail::sine_cosine_deg(x);
    const Real s = sin(Real(x) * degree);
    const Real c = cos(Real(x) * degree);
    largest = std::max(largest, double(abs(result.sin / s - 1)));
    largest = std::max(largest, double(abs(result.cos / c - 1)));
  }
  // Conversion, argument and result each round once: 1.5 units of 2.2e-16.
  EXPECT_LE(largest, 4e-16);
  RecordProperty("max_relative_error", std::to_string(largest));
}

TEST(Units, MultiplesOfNinetyDegreesAreExact) {
  for (int k = -8; k <= 8; ++k) {
    const SineCosine result = detail::sine_cosine_deg(90.0 * k);
    const int phase = ((k % 4) + 4) % 4;
    EXPECT_EQ(result.sin, phase == 1 ? 1 : phase == 3 ? -1 : 0);
    EXPECT_EQ(result.cos, phase == 0 ? 1 : phase == 2 ? -1 : 0);
  }
}

TEST(Units, NanAndInfinityGiveNan) {
  for (const double x : {std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(all_nan(
        {detail::sine_cosine_deg(x).sin, detail::sine_cosine_deg(x).cos}));
  }
}

}  // namespace
}  // namespace contact::test::units_test
