#pragma once

#include <array>
#include <vector>

namespace separation {

/// Some quantities at one time.
struct Look {
  double time;
  std::vector<double> values;
};

/// Whether a quantity may be higher than known from a time to that of c, as the
/// parabola through three looks says; or just before or after.
/// @param from   a's time, or b's
/// @param known  of each quantity: the highest value so far
bool may_peak(const Look& a, const Look& b, const Look& c, double from,
              const std::vector<double>& known);

/// Chebyshev's points between two times, the ends among them.
inline constexpr int peak_nodes = 7;
double peak_node(int k, double begin, double end);

/// Times between the first and the last of the looks, which are at the nodes,
/// at which the polynomial through them says that a quantity is higher than
/// known; those so near each other that it makes no difference once.
std::vector<double> peak_times(const std::array<Look, peak_nodes>& looks,
                               const std::vector<double>& known);

}  // namespace separation
