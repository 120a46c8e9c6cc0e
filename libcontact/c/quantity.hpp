#pragma once

#include <span>
#include <string>
#include <vector>

#include "libcontact/base/text.hpp"
#include "libcontact/c/call.hpp"
#include "libcontact/c/quantity.h"
#include "libcontact/quantities/quantity.hpp"

/// Tables of quantities for C.
namespace contact::c {

/// Row i of the quantities that `table` returns as C has it; null behind the
/// last one.
template <auto table>
const contact_quantity* row(std::size_t i) {
  static const auto& units = *new auto([] {
    std::vector<std::string> all;
    for (const auto& q : table()) all.push_back(unit_text(q.dimension));
    return all;
  }());
  static const auto& rows = *new auto([] {
    std::vector<contact_quantity> all;
    for (const auto& q : table()) {
      all.push_back({q.key.data(), q.symbol.data(), units[all.size()].c_str(),
                     q.meaning.data(), q.is_vector() ? 3U : 1U});
    }
    return all;
  }());
  return i < rows.size() ? &rows[i] : nullptr;
}

/// @throws Error for an unknown key
template <class T>
const Quantity<T>& row_of(std::span<const Quantity<T>> table,
                          std::string_view key) {
  if (const auto* q = find_quantity(table, key)) return *q;
  std::vector<std::string> keys;
  for (const auto& q : table) keys.emplace_back(q.key);
  throw Error(detail::unknown("quantity", std::string(key), keys));
}

/// Puts a quantity into `value`, a number or three.
template <class T>
contact_status get(const Quantity<T>& q, const T& of, double* value) {
  const int size = q.is_vector() ? 3 : 1;
  for (int k = 0; k < size; ++k) {
    value[k] = value_of(q, of, q.is_vector() ? k : whole);
  }
  return CONTACT_OK;
}

/// The function `function` of C: puts the quantity `key` of `result`, an
/// argument called `name`, into `value`.
/// @param to_cpp  converts the result to the type of `table`
template <auto table, class Result, class ToCpp>
contact_status get_of(const std::string& function, const char* name,
                      const Result* result, const ToCpp& to_cpp,
                      const char* key, double* value) {
  return call_for(
      [&] {
        const auto place = [&](const char* of) { return function + ": " + of; };
        const auto& from = given(result, place(name).c_str());
        const auto& q = row_of(table(), &given(key, place("key").c_str()));
        return get(q, to_cpp(from), &given(value, place("value").c_str()));
      },
      value);
}

}  // namespace contact::c
