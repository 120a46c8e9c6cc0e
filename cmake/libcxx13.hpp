// Included in front of every source by emscripten up to 3.1.15 (libc++ 13), whose
// C++20 lacks what is here; later ones have it. Algorithms take whole ranges and
// projections, as far as the library uses them, and forward to those of C++17.
#pragma once

#include <version>

#if defined(_LIBCPP_VERSION) && !defined(__cpp_lib_bit_cast)
#include <algorithm>
#include <functional>
#include <iterator>
#include <type_traits>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

namespace ranges {

struct as_is {
  template <class T>
  constexpr T&& operator()(T&& x) const {
    return static_cast<T&&>(x);
  }
};

template <class Range, class Out>
constexpr auto copy(const Range& r, Out out) {
  return std::copy(std::begin(r), std::end(r), out);
}
template <class Range, class T>
constexpr void fill(Range&& r, const T& value) {
  std::fill(std::begin(r), std::end(r), value);
}
template <class Range, class T>
constexpr void replace(Range&& r, const T& old, const T& value) {
  std::replace(std::begin(r), std::end(r), old, value);
}
template <class Range>
constexpr void reverse(Range&& r) {
  std::reverse(std::begin(r), std::end(r));
}
template <class Range>
constexpr void sort(Range&& r) {
  std::sort(std::begin(r), std::end(r));
}
template <class Range, class T>
constexpr auto count(const Range& r, const T& value) {
  return std::count(std::begin(r), std::end(r), value);
}
template <class Range>
constexpr auto adjacent_find(Range&& r) {
  return std::adjacent_find(std::begin(r), std::end(r));
}
template <class First, class Second, class Equal>
constexpr bool equal(const First& a, const Second& b, Equal is_equal) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b),
                    is_equal);
}
template <class Range, class Condition, class Of = as_is>
constexpr auto find_if(Range&& r, Condition is, Of of = {}) {
  return std::find_if(std::begin(r), std::end(r), [&](auto&& x) {
    return std::invoke(is, std::invoke(of, x));
  });
}
template <class Range, class T, class Of = as_is>
constexpr auto find(Range&& r, const T& value, Of of = {}) {
  return find_if(r, [&](const auto& x) { return x == value; }, of);
}
template <class Range, class Condition>
constexpr bool any_of(const Range& r, Condition is) {
  return find_if(r, is) != std::end(r);
}
template <class Range, class Condition>
constexpr bool none_of(const Range& r, Condition is) {
  return !any_of(r, is);
}
template <class Range, class Condition>
constexpr bool all_of(const Range& r, Condition is) {
  return std::all_of(std::begin(r), std::end(r), is);
}
template <class Range, class Condition>
constexpr auto count_if(const Range& r, Condition is) {
  return std::count_if(std::begin(r), std::end(r), is);
}

// Of these {} stands for std::less.
struct by_less {};
template <class Of>
constexpr auto less_by(const Of& of) {
  return [&](const auto& a, const auto& b) {
    return std::invoke(of, a) < std::invoke(of, b);
  };
}
template <class Range, class T, class Of = as_is>
constexpr auto lower_bound(Range&& r, const T& value, by_less = {},
                           Of of = {}) {
  return std::lower_bound(
      std::begin(r), std::end(r), value,
      [&](const auto& x, const T& y) { return std::invoke(of, x) < y; });
}
template <class Range, class Of = as_is>
constexpr auto min_element(Range&& r, by_less = {}, Of of = {}) {
  return std::min_element(std::begin(r), std::end(r), less_by(of));
}
template <class Range, class Of = as_is>
constexpr auto max_element(Range&& r, by_less = {}, Of of = {}) {
  return std::max_element(std::begin(r), std::end(r), less_by(of));
}
template <class Range, class Of = as_is>
constexpr auto minmax(const Range& r, by_less = {}, Of of = {}) {
  const auto found =
      std::minmax_element(std::begin(r), std::end(r), less_by(of));
  struct {
    std::remove_cvref_t<decltype(*found.first)> min, max;
  } values{*found.first, *found.second};
  return values;
}

}  // namespace ranges
}  // namespace std
#endif
