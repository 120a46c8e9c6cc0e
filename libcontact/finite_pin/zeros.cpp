#include "libcontact/finite_pin/zeros.hpp"

#include <cstddef>

#include "libcontact/base/root_finding.hpp"

namespace contact::detail {

std::vector<double> zeros(const std::vector<double>& of, double low,
                          double high) {
  if (of.size() < 2) return {};
  std::vector<double> slope;
  for (std::size_t k = 1; k < of.size(); ++k) {
    slope.push_back(static_cast<double>(k) * of[k]);
  }
  const auto value = [&](double x) {
    double sum = 0;
    for (auto c = of.rbegin(); c != of.rend(); ++c) sum = sum * x + *c;
    return sum;
  };
  std::vector<double> ends = zeros(slope, low, high);
  ends.push_back(high);
  std::vector<double> found;
  double from = low;
  constexpr int bits = 53;
  for (const double to : ends) {
    const double a = value(from);
    const double b = value(to);
    if ((a < 0) != (b < 0)) {
      found.push_back(shrink_bracket(value, from, to, a, b, bits).middle());
    }
    from = to;
  }
  return found;
}

}  // namespace contact::detail
