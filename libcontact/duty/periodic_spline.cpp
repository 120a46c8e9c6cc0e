#include "libcontact/duty/periodic_spline.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {
namespace {

using Eigen::Vector3d;

void check(std::span<const double> times, double period, std::size_t values) {
  if (times.size() < 3 || values != times.size()) {
    throw Error(
        detail::must_be(detail::message("{} times of a period", times.size()),
                        "3 or more, as many as values"));
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) continue;
    throw Error(detail::must_be(
        detail::message("time {} s", times[i]),
        detail::message("above {} s, the time before it", times[i - 1])));
  }
  const double span = times.back() - times.front();
  if (!(period > span) || !std::isfinite(period)) {
    throw Error(detail::must_be(
        detail::message("period {} s", period),
        detail::message("above {} s, from the first time to the last", span)));
  }
}

}  // namespace

PeriodicSpline::PeriodicSpline(std::span<const double> times, double period,
                               std::span<const Vector3d> values)
    : times_(times.begin(), times.end()),
      period_(period),
      values_(values.begin(), values.end()) {
  check(times, period, values.size());
  // Continuous slopes: a cyclic tridiagonal system for the second derivatives.
  const int n = static_cast<int>(times_.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d change = Eigen::MatrixX3d::Zero(n, 3);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    const double step =
        (next == 0 ? times_[0] + period_ : times_[next]) - times_[i];
    entries.emplace_back(i, i, step / 3);
    entries.emplace_back(next, next, step / 3);
    entries.emplace_back(i, next, step / 6);
    entries.emplace_back(next, i, step / 6);
    const Vector3d slope = (values_[next] - values_[i]) / step;
    change.row(i) += slope.transpose();
    change.row(next) -= slope.transpose();
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  const Eigen::MatrixX3d solved = factors.solve(change);
  for (int i = 0; i < n; ++i) curvatures_.emplace_back(solved.row(i));
}

PeriodicSpline::Place PeriodicSpline::find(double time) const {
  const double first = times_.front();
  const double periods = std::floor((time - first) / period_);
  // Rounding may leave it a little outside.
  const double within =
      std::clamp(time - periods * period_, first, first + period_);
  const auto after = std::upper_bound(times_.begin(), times_.end(), within);
  const std::size_t to = static_cast<std::size_t>(after - times_.begin());
  const std::size_t from = to - 1;
  const bool wraps = to == times_.size();
  const double step = (wraps ? first + period_ : times_[to]) - times_[from];
  return {from, wraps ? 0 : to, step, (within - times_[from]) / step};
}

Vector3d PeriodicSpline::value(double time) const {
  const auto [from, to, step, b] = find(time);
  const double a = 1 - b;
  const double scale = step * step / 6;
  return a * values_[from] + b * values_[to] +
         scale * ((a * a * a - a) * curvatures_[from] +
                  (b * b * b - b) * curvatures_[to]);
}

Vector3d PeriodicSpline::slope(double time) const {
  const auto [from, to, step, b] = find(time);
  const double a = 1 - b;
  return (values_[to] - values_[from]) / step +
         step / 6 *
             ((3 * b * b - 1) * curvatures_[to] -
              (3 * a * a - 1) * curvatures_[from]);
}

}  // namespace contact
