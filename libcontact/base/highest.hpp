#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

namespace contact::detail {

/// Place of the largest value of a function on [0, edge] with few maxima; one
/// of them may be narrow and beside the edge, which the sines make wide.
template <class Function>
double highest(const Function& function, double edge) {
  constexpr int steps = 64;
  using std::numbers::pi;
  const auto at = [&](int i) { return pi / 2 * i / steps; };
  const auto place = [&](double v) {
    return edge * std::sin(pi / 2 * std::sin(v));
  };
  std::array<double, steps + 1> value;
  for (int i = 0; i <= steps; ++i) value[i] = function(place(at(i)));
  double best = 0;
  for (int i = 0; i < steps; ++i) {
    const int before = std::max(i - 1, 0);
    if (value[i] < value[before] || value[i] < value[i + 1]) continue;
    // Half the digits of a double: a maximum has no more.
    const auto [v, fall] = boost::math::tools::brent_find_minima(
        [&](double u) { return -function(place(u)); }, at(before), at(i + 1),
        26);
    if (-fall > function(best)) best = place(v);
  }
  return best;
}

}  // namespace contact::detail
