#include "libcontact/base/lanes/sine_cosine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "libcontact/base/simd.hpp"

// Sines and cosines in lanes against the standard library's long double.
namespace contact::test::sine_cosine_test {
namespace {

using detail::LanesOf;

template <class V>
class SineCosineOf : public testing::Test {};
using Types = testing::Types<LanesOf<2>, LanesOf<4>, LanesOf<8>>;
TYPED_TEST_SUITE(SineCosineOf, Types);

// The largest error of both for angles like that, another in each lane.
template <class V, class Angle, class Function>
double largest_error(Angle angle, Function function) {
  double largest = 0;
  for (int round = 0; round < 20000; ++round) {
    const V x([&](auto) { return angle(); });
    const auto [sine, cosine] = function(x);
    for (int i = 0; i < V::size(); ++i) {
      const long double exact = x[i];
      largest = std::max<double>(
          {largest, static_cast<double>(std::abs(sine[i] - std::sin(exact))),
           static_cast<double>(std::abs(cosine[i] - std::cos(exact)))});
    }
  }
  return largest;
}

// Half a unit in the last place of 1 is 1.1e-16. Measured: 1.6e-16.
constexpr double bound = 2e-16;
// MinGW's long double functions are the x87's, which reduce angles by a pi of
// 66 bits. Measured: 8e-17 at 1e5.
#ifdef _WIN32
constexpr double reference_error = 1e-21;
#else
constexpr double reference_error = 0;
#endif

TYPED_TEST(SineCosineOf, AngleOfAContactIsRight) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(0, std::numbers::pi);
  EXPECT_LE(largest_error<TypeParam>(
                [&] { return angle(random); },
                [](const auto& x) { return detail::sine_cosine(x); }),
            bound);
}

TYPED_TEST(SineCosineOf, AnyAngleIsRight) {
  std::mt19937_64 random(2);
  const auto of_any = [](const auto& x) {
    return detail::sine_cosine_of_any(x);
  };
  // The last is beyond where the series serve.
  for (const double size : {1e-9, 1.0, 10.0, 1e5, 1e9}) {
    std::uniform_real_distribution<double> angle(-size, size);
    EXPECT_LE(largest_error<TypeParam>([&] { return angle(random); }, of_any),
              bound + size * reference_error)
        << size;
  }
  // Near the quarter turns, where one of them is small.
  std::uniform_int_distribution<int> turns(-60000, 60000);
  EXPECT_LE(largest_error<TypeParam>(
                [&] { return turns(random) * (std::numbers::pi / 2); }, of_any),
            bound);
}

TYPED_TEST(SineCosineOf, AngleThatIsNoneGivesNaNInItsLaneAlone) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double none : {nan, infinity, -infinity}) {
    const auto [sine, cosine] = detail::sine_cosine_of_any(
        TypeParam([&](auto i) { return i == 1 ? none : 0.5; }));
    EXPECT_TRUE(std::isnan(sine[1]) && std::isnan(cosine[1]));
    EXPECT_EQ(sine[0], std::sin(0.5));
    EXPECT_EQ(cosine[0], std::cos(0.5));
  }
}

}  // namespace
}  // namespace contact::test::sine_cosine_test
