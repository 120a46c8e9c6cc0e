#include "multibody/motion/crossings.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "libcontact/base/root_finding.hpp"

namespace multibody {
namespace {

using Values = StepFunction::Values;
constexpr int last = StepFunction::last;
constexpr int middle_node = StepFunction::middle;

// Chebyshev points of the second kind in [0, 1], increasing.
const Values nodes = [] {
  Values x{};
  for (int k = 0; k <= last; ++k) {
    const double sine = std::sin(std::numbers::pi * k / (2 * last));
    x[k] = sine * sine;
  }
  x[middle_node] = 0.5;
  return x;
}();

// Bernstein coefficients on [0, 1] of the polynomial through the values, by
// divided differences from the beginning: a long step then keeps the details of
// its first part.
Values bernstein(const Values& values) {
  Values newton = values;
  for (int order = 1; order <= last; ++order) {
    for (int k = last; k >= order; --k) {
      newton[k] = (newton[k] - newton[k - 1]) / (nodes[k] - nodes[k - order]);
    }
  }
  Values power{};
  for (int k = last; k >= 0; --k) {
    for (int j = last; j >= 0; --j) {
      power[j] = (j > 0 ? power[j - 1] : 0) - nodes[k] * power[j];
    }
    power[0] += newton[k];
  }
  Values result{};
  for (int i = 0; i <= last; ++i) {
    double share = 1;  // ratio of binomials, i over j and last over j
    for (int j = 0; j <= i; ++j) {
      result[i] += share * power[j];
      share *= static_cast<double>(i - j) / (last - j);
    }
  }
  return result;
}

// The halves of a polynomial, by de Casteljau.
std::pair<Values, Values> halves(Values c) {
  Values left{};
  Values right{};
  for (int round = 0; round <= last; ++round) {
    left[round] = c[0];
    right[last - round] = c[last - round];
    for (int i = 0; i < last - round; ++i) c[i] = (c[i] + c[i + 1]) / 2;
  }
  return {left, right};
}

double polynomial(Values c, double s) {
  for (int n = last; n > 0; --n) {
    for (int i = 0; i < n; ++i) c[i] += s * (c[i + 1] - c[i]);
  }
  return c[0];
}

// Upper bound of the number of turning points of the polynomial.
int turns_of(const Values& c) {
  int count = 0;
  double before = 0;
  for (int i = 1; i <= last; ++i) {
    const double step = c[i] - c[i - 1];
    if ((before < 0 && step > 0) || (before > 0 && step < 0)) ++count;
    if (step != 0) before = step;
  }
  return count;
}

// Size of the polynomial's two highest degrees; the error of the polynomial is
// hardly larger.
double uncertainty(const Values& values) {
  double sum = 0;
  for (const int degree : {last - 1, last}) {
    double c = 0;
    for (int k = 0; k <= last; ++k) {
      const double share = k == 0 || k == last ? 0.5 : 1;
      c += share * values[k] *
           std::cos(degree * std::numbers::pi * (last - k) / last);
    }
    sum += std::abs(2 * c / last);
  }
  return sum;
}

struct Point {
  double time, value;
};

// Points between which a function crosses 0 at most once, according to the
// polynomial through its values.
class Separation {
 public:
  Separation(const StepFunction& function, double begin, double end,
             double unsure)
      : function_(function), begin_(begin), end_(end), unsure_(unsure) {}

  void look(const Values& c, double low, double high) {
    const double sign = c[0] > 0 || (c[0] == 0 && c[last] > 0) ? 1 : -1;
    const bool same = sign * c[last] > 0;
    const int turns = turns_of(c);
    if (same) {
      if (turns == 0 || std::ranges::all_of(
                            c, [&](double x) { return sign * x > unsure_; })) {
        return;
      }
      if (turns == 1) {
        add_extremum(c, low, high, sign);
        return;
      }
    } else if (turns <= 1) {
      add(low);
      add(high);
      // Rises above 0 and returns: the maximum separates the two crossings.
      if (turns == 1) {
        add(low + extremum(c, sign).first * (high - low));
        add(low + extremum(c, -sign).first * (high - low));
      }
      return;
    }
    const double half = low + (high - low) / 2;
    if (!(low < half && half < high)) return;
    const auto [left, right] = halves(c);
    look(left, low, half);
    look(right, half, high);
  }

  std::vector<Point> points;

 private:
  double time(double s) const { return begin_ + s * (end_ - begin_); }
  double add(double s) {
    if (s <= 0 || s >= 1) return 0;  // known
    points.push_back({time(s), function_(time(s))});
    return points.back().value;
  }
  static std::pair<double, double> extremum(const Values& c, double sign) {
    std::uintmax_t steps = 60;
    return boost::math::tools::brent_find_minima(
        [&](double x) { return sign * polynomial(c, x); }, 0., 1., bits, steps);
  }
  void add_extremum(const Values& c, double low, double high, double sign) {
    const auto [s, least] = extremum(c, sign);
    if (least > unsure_) return;
    if (sign * add(low + s * (high - low)) <= 0) return;
    std::uintmax_t steps = 30;
    const auto [t, value] = boost::math::tools::brent_find_minima(
        [&](double x) { return sign * function_(x); }, time(low), time(high),
        bits, steps);
    points.push_back({t, sign * value});
  }

  static constexpr int bits = 26;  // in time: values differ by 1e-15 of it
  const StepFunction& function_;
  double begin_, end_;
  double unsure_;
};

double spread(std::span<const double> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

}  // namespace

bool is_crossing(double before, double after, MotionEvent::Crossing way) {
  return (before < 0 && after >= 0 && way != MotionEvent::Crossing::falling) ||
         (before > 0 && after <= 0 && way != MotionEvent::Crossing::rising);
}

double StepFunction::point(int k, double begin, double end) {
  return k == last ? end : begin + nodes[k] * (end - begin);
}

bool StepFunction::is_far(std::span<const double> values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return (*low > 0 || *high < 0) &&
         std::min(std::abs(*low), std::abs(*high)) > *high - *low;
}

double StepFunction::locate(double low, double low_value, double high,
                            double high_value) const {
  if (low_value == 0) return low;
  if (high_value == 0) return high;
  return contact::shrink_bracket(at_, low, high, low_value, high_value, 50)
      .high;
}

std::optional<StepFunction::Crossed> StepFunction::first_crossing(
    Values values, double before, MotionEvent::Crossing way) const {
  if (before * values[0] <= 0) {
    if (std::abs(before) == just_crossed) {
      values[0] = before;
    } else if (is_crossing(before, values[0], way)) {
      return Crossed{begin_, before < 0};
    } else {
      before = values[0];
    }
  }
  if (is_far(values) && before * values[0] > 0) return {};
  // A step of a few roundings of time has ends, but no points inside.
  constexpr double rounding = 1e-14;
  if (end_ - begin_ <= rounding * std::abs(end_)) {
    if (!is_crossing(before, values[last], way)) return {};
    return Crossed{end_, before < 0};
  }
  // States between the ends are estimates, which are worst in the middle. The
  // integrator's dense output costs some evaluations.
  double miss =
      std::abs(at_(point(middle_node, begin_, end_)) - values[middle_node]);
  constexpr double rough = 1e-3;
  if (!(miss <= rough * spread(values))) {
    for (int k = 1; k < last; ++k) values[k] = at_(point(k, begin_, end_));
    miss = 0;
  }
  Separation separation(*this, begin_, end_, uncertainty(values) + 2 * miss);
  std::vector<Point>& points = separation.points;
  for (int k = 1; k <= last; ++k)
    points.push_back({point(k, begin_, end_), values[k]});
  separation.look(bernstein(values), 0, 1);
  std::ranges::sort(points, {}, &Point::time);
  double from = begin_;
  for (const Point& point : points) {
    if (is_crossing(before, point.value, way)) {
      const bool rises = before < 0;
      // By the steps' own formula, where the points are estimates.
      const double low = from == begin_ ? values[0] : at_(from);
      const double high = point.time == end_ ? values[last] : at_(point.time);
      if (low * high <= 0) {
        return Crossed{locate(from, low, point.time, high), rises};
      }
    }
    if (point.value > 0 || point.value < 0) {
      before = point.value;
      from = point.time;
    }
  }
  return {};
}

}  // namespace multibody
