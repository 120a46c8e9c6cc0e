#include "libcontact/base/gauss_legendre.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/legendre.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

namespace contact::test::gauss_legendre_test {
namespace {

using Long = boost::multiprecision::cpp_bin_float_50;

// Boost's zeros and derivatives in 50 digits.
TEST(GaussLegendre, IsExactToTheLastBit) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  for (const int n : {1, 2, 5, 32, 96, 160, 300}) {
    const detail::GaussLegendre rule(n);
    const auto zeros = boost::math::legendre_p_zeros<Long>(n);
    for (std::size_t i = 0; i < zeros.size(); ++i) {
      const Long x = zeros[i];
      const Long slope = boost::math::legendre_p_prime(n, x);
      const Long weight = 2 / ((1 - x) * (1 + x) * slope * slope);
      const auto right = n / 2 + static_cast<Eigen::Index>(i);
      const Eigen::Index left = n - 1 - right;
      EXPECT_EQ(rule.node(right), static_cast<double>(x)) << n << " " << i;
      EXPECT_EQ(rule.node(left), -rule.node(right));
      // Roundings of long double are 2^-11 of a last bit, times n: few of the
      // weights are the next double.
      EXPECT_NEAR(rule.weight(right), static_cast<double>(weight),
                  epsilon * static_cast<double>(weight))
          << n << " " << i;
      EXPECT_EQ(rule.weight(left), rule.weight(right));
    }
  }
}

}  // namespace
}  // namespace contact::test::gauss_legendre_test
