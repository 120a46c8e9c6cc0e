#include "libcontact/friction/kernel/expansion_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/pressure/law.hpp"

namespace contact::detail {
namespace {

/// T_j at the points of Chebyshev's rule, times 2/n (1/n for j = 0).
struct Transform {
  static constexpr int size = ExpansionTable::most_rows;
  std::array<double, size> point;
  std::array<std::array<double, size>, size> factor;  // [point][j]
  Transform() {
    for (int i = 0; i < size; ++i) {
      const double phase = std::numbers::pi * (i + 0.5) / size;
      point[i] = std::cos(phase);
      for (int j = 0; j < size; ++j) {
        factor[i][j] = (j == 0 ? 1.0 : 2.0) / size * std::cos(j * phase);
      }
    }
  }
};

}  // namespace

ExpansionTable::ExpansionTable(const PressureLaw& law, double lower,
                               double upper) {
  static const Transform transform;
  const double low = std::sqrt(lower);
  const double high = std::sqrt(upper);
  rows = low < high ? most_rows : 1;
  middle = (low + high) / 2;
  inverse_half_width = rows > 1 ? 2 / (high - low) : 0;
  for (int i = 0; i < rows; ++i) {
    const double root = middle + (high - low) / 2 * transform.point[i];
    const double half_angle = rows > 1 ? root * root : lower;
    const PressureExpansion p = expansion_of(law, half_angle);
    const double h = std::sin(half_angle / 2);
    const double scale = 4 * h * h;
    size = std::max(size, p.size);
    has_cosine = has_cosine || p.cosine_share != 0;
    has_logarithm = has_logarithm || p.has_logarithm();
    arc_terms = std::max(arc_terms, detail::arc_terms(p));
    const auto add = [&](int column, double value) {
      auto& s = series[column];
      if (rows == 1) {
        s[0] = value;
      } else {
        for (int j = 0; j < rows; ++j) s[j] += transform.factor[i][j] * value;
      }
    };
    add(cosine_share, p.cosine_share);
    add(edge_constant, p.edge_constant);
    for (int k = 0; k < 3; ++k) {
      add(logarithmic + k, scale * p.logarithmic[k]);
    }
    for (int k = 0; k < p.size; ++k) {
      add(coefficient + k, scale * p.coefficient[k]);
    }
  }
  // Rows that are rounding, or little more.
  const double negligible = 2e-13 * std::abs(series[coefficient][0]);
  const auto is_negligible = [&](int row) {
    return std::ranges::all_of(
        series, [=](const auto& s) { return std::abs(s[row]) < negligible; });
  };
  while (rows > 1 && is_negligible(rows - 1)) --rows;
}

}  // namespace contact::detail
