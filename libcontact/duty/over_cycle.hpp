#pragma once

#include <boost/math/tools/minima.hpp>
#include <cstddef>
#include <limits>

namespace contact::detail {

/// The integral of a quantity over a cycle.
/// @param points  with their `weight` in it, s
template <class Points, class Quantity>
double integral_of(const Points& points, const Quantity& quantity) {
  double sum = 0;
  for (const auto& point : points) sum += point.weight * quantity(point);
  return sum;
}

/// The row where a quantity is largest; the first if it is NaN in all.
template <class Rows, class Quantity>
auto largest_row(const Rows& rows, const Quantity& quantity) {
  std::size_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double value = quantity(rows[i]);
    if (!(value > most)) continue;
    best = i;
    most = value;
  }
  return rows[best];
}

/// The row of a cycle where a quantity is largest, improved between its
/// neighbours to 1e-8.
/// @param rows      of one period, with their `time`
/// @param at        the row of any time
/// @param quantity  of a row
template <class Rows, class At, class Quantity>
auto largest_of(const Rows& rows, double period, const At& at,
                const Quantity& quantity) {
  const std::size_t count = rows.size();
  std::size_t best = 0;
  double most = quantity(rows[0]);
  for (std::size_t i = 1; i < count; ++i) {
    const double value = quantity(rows[i]);
    if (!(most < value)) continue;
    best = i;
    most = value;
  }
  const double first = rows[0].time;
  const double before =
      best == 0 ? rows[count - 1].time - period : rows[best - 1].time;
  const double after = best + 1 == count ? first + period : rows[best + 1].time;
  // Half the digits of a double: a maximum has no more.
  const double time =
      boost::math::tools::brent_find_minima(
          [&](double t) { return -quantity(at(t)); }, before, after, 26)
          .first;
  auto found = at(time < first ? time + period : time);
  return quantity(found) > most ? found : rows[best];
}

}  // namespace contact::detail
