#include "separation/peaks.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace separation {
namespace {

// Less than what steps and solvers leave uncertain is no peak.
constexpr double higher = 1 + 1e-10;

// Chebyshev's points of [-1, 1] from left to right.
double node(int k) {
  return -std::cos(std::numbers::pi * k / (peak_nodes - 1));
}

using Values = std::array<double, peak_nodes>;

// The polynomial through values at the nodes, by the barycentric formula: the
// weights are +-1, half of that at the ends.
double polynomial(const Values& values, double x) {
  double above = 0;
  double below = 0;
  for (int k = 0; k < peak_nodes; ++k) {
    const double from = x - node(k);
    if (from == 0) return values[k];
    const bool end = k == 0 || k == peak_nodes - 1;
    const double weight = (k % 2 == 0 ? 1 : -1) * (end ? 0.5 : 1) / from;
    above += weight * values[k];
    below += weight;
  }
  return above / below;
}

}  // namespace

bool may_peak(const Look& a, const Look& b, const Look& c, double from,
              const std::vector<double>& known) {
  // Newton's form about b.
  const double ab = b.time - a.time;
  const double bc = c.time - b.time;
  const double near = std::max(ab, bc) / 2;
  const double first = from - b.time - near;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const double before = (b.values[i] - a.values[i]) / ab;
    const double after = (c.values[i] - b.values[i]) / bc;
    const double bend = (before - after) / (ab + bc);
    if (!(bend > 0)) continue;
    // Slope at b, and where it is used up.
    const double slope = (bc * before + ab * after) / (ab + bc);
    const double way = slope / (2 * bend);
    if (way < first || way > bc + near) continue;
    // Parabolas are not exact: a quarter more than they say.
    const double top = b.values[i] + slope * way / 2;
    const double rise = top - std::max({a.values[i], b.values[i], c.values[i]});
    if (top + rise / 4 > higher * known[i]) return true;
  }
  return false;
}

double peak_node(int k, double begin, double end) {
  if (k == 0) return begin;
  if (k == peak_nodes - 1) return end;
  return begin + (end - begin) * (1 + node(k)) / 2;
}

std::vector<double> peak_times(const std::array<Look, peak_nodes>& looks,
                               const std::vector<double>& known) {
  // Values go as the square of this share of the time.
  constexpr double same = 1e-4;
  constexpr int bits = 20;
  const double begin = looks.front().time;
  const double span = looks.back().time - begin;
  std::vector<double> times;
  for (std::size_t i = 0; i < known.size(); ++i) {
    Values values;
    for (int k = 0; k < peak_nodes; ++k) values[k] = looks[k].values[i];
    const auto top =
        static_cast<int>(std::ranges::max_element(values) - values.begin());
    std::uintmax_t steps = 60;
    const auto [x, below] = boost::math::tools::brent_find_minima(
        [&](double at) { return -polynomial(values, at); },
        node(std::max(top - 1, 0)), node(std::min(top + 1, peak_nodes - 1)),
        bits, steps);
    if (!(-below > higher * known[i])) continue;
    const double time = begin + span * (1 + x) / 2;
    if (std::ranges::none_of(times, [&](double other) {
          return std::abs(time - other) < same * span;
        })) {
      times.push_back(time);
    }
  }
  return times;
}

}  // namespace separation
