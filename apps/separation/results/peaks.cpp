#include "separation/results/peaks.hpp"

#include <algorithm>
#include <boost/math/interpolators/barycentric_rational.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace separation {
namespace {

// A rise below the uncertainty of steps and solvers is no peak.
constexpr double higher = 1 + 1e-10;

// Chebyshev's points of [-1, 1] from left to right.
double node(int k) {
  return -std::cos(std::numbers::pi * k / (peak_nodes - 1));
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
  std::array<double, peak_nodes> nodes;
  for (int k = 0; k < peak_nodes; ++k) nodes[k] = node(k);
  std::vector<double> times;
  for (std::size_t i = 0; i < known.size(); ++i) {
    std::array<double, peak_nodes> values;
    for (int k = 0; k < peak_nodes; ++k) values[k] = looks[k].values[i];
    // A run that fails leaves some values unknown.
    const bool known_all = std::ranges::all_of(
        values, [](double value) { return std::isfinite(value); });
    if (!known_all) continue;
    // The interpolant of highest order is the polynomial.
    const boost::math::barycentric_rational<double> polynomial(
        nodes.data(), values.data(), peak_nodes, peak_nodes - 1);
    const auto top =
        static_cast<int>(std::ranges::max_element(values) - values.begin());
    std::uintmax_t steps = 60;
    const auto [x, below] = boost::math::tools::brent_find_minima(
        [&](double at) { return -polynomial(at); }, nodes[std::max(top - 1, 0)],
        nodes[std::min(top + 1, peak_nodes - 1)], bits, steps);
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
