#include "libcontact/base/simd.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "libcontact/base/lanes/select.hpp"

// Lanes do what each number alone does, the unordered ones too.
namespace contact::test::simd_test {
namespace {

using detail::LanesOf;

#if defined(__aarch64__) || defined(__wasm_simd128__)
static_assert(detail::native_lanes == 2);
#endif

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<double, 8> left = {1, -2, nan, 0.0, 3, 5, -1, 0.25};
constexpr std::array<double, 8> right = {2, -2, 1, -0.0, nan, 4, -7, 0.25};

template <class V>
class Lanes : public testing::Test {
 protected:
  V a = V::load(left.data());
  V b = V::load(right.data());

  template <class Mask, class Scalar>
  void expect(const Mask& mask, Scalar scalar) {
    unsigned bits = 0;
    for (int i = 0; i < V::size(); ++i) {
      const bool is = scalar(left[i], right[i]);
      EXPECT_EQ(mask[i], is) << i;
      bits |= unsigned{is} << i;
    }
    EXPECT_EQ(mask.bits(), bits);
    EXPECT_EQ((!mask).bits(), ~bits & ((1U << V::size()) - 1));
    EXPECT_EQ(any_of(mask), bits != 0);
    EXPECT_EQ(none_of(mask), bits == 0);
    EXPECT_EQ(all_of(mask), bits + 1 == 1U << V::size());
    EXPECT_EQ(popcount(mask), std::popcount(bits));
    if (bits) {
      EXPECT_EQ(find_first_set(mask), std::countr_zero(bits));
    }
    const V chosen = select(mask, a, b);
    for (int i = 0; i < V::size(); ++i) {
      const double one = mask[i] ? left[i] : right[i];
      EXPECT_TRUE(chosen[i] == one || std::isnan(one)) << i;
    }
  }
};
using Types = testing::Types<LanesOf<2>, LanesOf<4>, LanesOf<8>>;
TYPED_TEST_SUITE(Lanes, Types);

TYPED_TEST(Lanes, CompareAsNumbersDo) {
  const auto& u = this->a;
  const auto& w = this->b;
  this->expect(u < w, [](double x, double y) { return x < y; });
  this->expect(u <= w, [](double x, double y) { return x <= y; });
  this->expect(u > w, [](double x, double y) { return x > y; });
  this->expect(u >= w, [](double x, double y) { return x >= y; });
  this->expect(u == w, [](double x, double y) { return x == y; });
  this->expect(u != w, [](double x, double y) { return x != y; });
  this->expect(u < w || u > w,
               [](double x, double y) { return x < y || x > y; });
  this->expect(u <= w && u >= w, [](double x, double y) { return x == y; });
  using Mask = typename TypeParam::mask_type;
  this->expect(Mask(true), [](double, double) { return true; });
  this->expect(Mask(false), [](double, double) { return false; });
}

TYPED_TEST(Lanes, CalculateAsNumbersDo) {
  const auto same = [](double x, double y) {
    return x == y ? std::signbit(x) == std::signbit(y)
                  : std::isnan(x) && std::isnan(y);
  };
  const TypeParam sum = this->a + this->b, product = this->a * this->b,
                  difference = this->a - this->b, ratio = this->a / this->b,
                  negative = -this->a, size = abs(this->a),
                  root = sqrt(abs(this->b)), most = max(this->a, this->b),
                  least = min(this->a, this->b);
  for (int i = 0; i < TypeParam::size(); ++i) {
    const double x = left[i], y = right[i];
    EXPECT_TRUE(same(sum[i], x + y)) << i;
    EXPECT_TRUE(same(product[i], x * y)) << i;
    EXPECT_TRUE(same(difference[i], x - y)) << i;
    EXPECT_TRUE(same(ratio[i], x / y)) << i;
    EXPECT_TRUE(same(negative[i], -x)) << i;
    EXPECT_TRUE(same(size[i], std::abs(x))) << i;
    EXPECT_TRUE(same(root[i], std::sqrt(std::abs(y)))) << i;
    EXPECT_TRUE(same(most[i], x > y ? x : y)) << i;
    EXPECT_TRUE(same(least[i], x < y ? x : y)) << i;
  }
}

// Halves are added to halves, so that sums have the same bits on any machine.
TYPED_TEST(Lanes, FoldByHalves) {
  constexpr int n = TypeParam::size();
  std::array<double, 8> part{};
  for (int i = 0; i < n; ++i) part[i] = 1 / (i + 3.0);
  const TypeParam v = TypeParam::load(part.data());
  double largest = part[0], smallest = part[n - 1];
  EXPECT_EQ(hmax(v), largest);
  EXPECT_EQ(hmin(v), smallest);
  for (int size = n / 2; size > 0; size /= 2) {
    for (int i = 0; i < size; ++i) part[i] += part[i + size];
  }
  EXPECT_EQ(reduce(v), part[0]);
}

TYPED_TEST(Lanes, AreSetAndStoredOneByOne) {
  TypeParam v = 1.5;
  v.set_lane(1, -0.0);
  std::array<double, TypeParam::size()> out;
  v.store(out.data());
  EXPECT_EQ(out[0], 1.5);
  EXPECT_TRUE(std::signbit(out[1]));
  const TypeParam counted([](auto i) { return 10.0 * i; });
  for (int i = 0; i < TypeParam::size(); ++i) EXPECT_EQ(counted[i], 10.0 * i);
}

}  // namespace
}  // namespace contact::test::simd_test
