#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "libcontact/c/quantity.h"
#include "libcontact/quantities/quantity.hpp"

/// Compares quantities from C with the table of C++.
namespace contact::test {

/// Equal, or both NaN.
inline void expect_same(double a, double b, std::string_view key) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b))
      << key << ": " << a << " and " << b;
}

/// Lists and gets all quantities of a table.
template <class T, class Listed, class Get>
void expect_table(std::span<const Quantity<T>> table, const T& of,
                  const Listed& listed, const Get& get) {
  std::size_t i = 0;
  for (const auto& q : table) {
    const contact_quantity* c = listed(i++);
    ASSERT_NE(c, nullptr) << q.key;
    EXPECT_EQ(c->key, q.key);
    EXPECT_EQ(c->symbol, q.symbol) << q.key;
    EXPECT_EQ(c->meaning, q.meaning) << q.key;
    EXPECT_EQ(c->unit, unit_text(q.dimension)) << q.key;
    EXPECT_EQ(c->size, q.is_vector() ? 3u : 1u) << q.key;
    double values[3];
    ASSERT_EQ(get(c->key, values), CONTACT_OK) << q.key;
    for (std::size_t k = 0; k < c->size; ++k) {
      const double expected =
          q.exists && !q.exists(of)
              ? std::numeric_limits<double>::quiet_NaN()
              : number_of(q, of, q.is_vector() ? static_cast<int>(k) : whole);
      expect_same(values[k], expected, q.key);
    }
  }
  EXPECT_EQ(listed(i), nullptr);
}

}  // namespace contact::test
