// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

namespace separation {

/// Quantities at one time.
struct Look {
  double time;
  std::vector<double> values;
};

/// Whether, by the parabola through three evaluations, a quantity may exceed
/// its known maximum between `from` and c, or just before or after.
/// @param from   a's time, or b's
/// @param known  highest value of each quantity so far
bool may_peak(const Look& a, const Look& b, const Look& c, double from,
              const std::vector<double>& known);

/// Chebyshev points between two times, including the ends.
inline constexpr int peak_nodes = 7;
double peak_node(int k, double begin, double end);

/// Times between the first and the last evaluation, which are at the nodes, at
/// which the polynomial through them exceeds the known maximum of a quantity;
/// times that are equal for this purpose only once.
std::vector<double> peak_times(const std::array<Look, peak_nodes>& looks,
                               const std::vector<double>& known);

}  // namespace separation
