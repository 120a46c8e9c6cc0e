#pragma once

#include <array>
#include <iterator>
#include <utility>

#include "libcontact/quantities/quantity.hpp"

/// Rows of a struct that stands in another one as a member.
namespace contact::detail {

/// A row of `table` as one of Whole, whose `member` it is of.
template <class Whole, auto member, const auto& table, std::size_t i>
constexpr Quantity<Whole> lifted_row() {
  constexpr std::size_t kind = table[i].of.index();
  bool (*exists)(const Whole&) = nullptr;
  if constexpr (table[i].exists != nullptr) {
    exists = [](const Whole& whole) { return table[i].exists(whole.*member); };
  }
  return {table[i].key,
          table[i].symbol,
          table[i].dimension,
          table[i].meaning,
          +[](const Whole& whole) -> decltype(auto) {
            return std::get<kind>(table[i].of)(whole.*member);
          },
          table[i].length_meaning,
          exists};
}

/// All rows of a constexpr table.
template <class Whole, auto member, const auto& table>
constexpr auto lifted() {
  return []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{lifted_row<Whole, member, table, i>()...};
  }
  (std::make_index_sequence<std::size(table)>{});
}

/// Rows of one table, then those of another.
template <class T, std::size_t m, std::size_t n>
constexpr auto joined(const std::array<T, m>& a, const std::array<T, n>& b) {
  return [&]<std::size_t... i, std::size_t... k>(std::index_sequence<i...>,
                                                 std::index_sequence<k...>) {
    return std::array{a[i]..., b[k]...};
  }
  (std::make_index_sequence<m>{}, std::make_index_sequence<n>{});
}

}  // namespace contact::detail
