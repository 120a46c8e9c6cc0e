#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <iterator>

namespace contact::detail {

/// The integral of a quantity over a cycle.
/// @param points  with their `weight` in it, s
template <class Points, class Quantity>
double integral_of(const Points& points, const Quantity& quantity) {
  double sum = 0;
  for (const auto& point : points) sum += point.weight * quantity(point);
  return sum;
}

/// The row of a cycle where a quantity is largest, improved between its
/// neighbours to 1e-8.
/// @param rows      of one period, with their `time`
/// @param at        the row of any time
/// @param quantity  of a row
template <class Rows, class At, class Quantity>
auto largest_of(const Rows& rows, double period, const At& at,
                const Quantity& quantity) {
  const auto best = std::ranges::max_element(
      rows, {}, [&](const auto& row) { return quantity(row); });
  const double first = rows.front().time;
  const double before =
      best == rows.begin() ? rows.back().time - period : std::prev(best)->time;
  const double after =
      std::next(best) == rows.end() ? first + period : std::next(best)->time;
  // Half the digits of a double: a maximum has no more.
  const double time =
      boost::math::tools::brent_find_minima(
          [&](double t) { return -quantity(at(t)); }, before, after, 26)
          .first;
  auto found = at(time < first ? time + period : time);
  return quantity(found) > quantity(*best) ? found : *best;
}

}  // namespace contact::detail
