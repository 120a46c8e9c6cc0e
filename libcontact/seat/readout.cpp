#include "libcontact/seat/readout.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"

namespace contact::detail {
namespace {

using Eigen::Vector3d;

Vector3d direction(double v, double longitude) {
  return {std::sin(v) * std::cos(longitude), std::sin(v) * std::sin(longitude),
          std::cos(v)};
}

// |w x r|
double lever(const Vector3d& axis, double v, double longitude) {
  return axis.cross(direction(v, longitude)).norm();
}

}  // namespace

std::vector<SeatReadout::Run> SeatReadout::runs(int j) const {
  std::vector<Run> runs;
  for (int i = 0; i < cells_.size(); ++i) {
    if (patch_.contact(i, j) == 0) continue;
    if (i == 0 || patch_.contact(i - 1, j) == 0) runs.push_back({i, i});
    runs.back().last = i;
  }
  return runs;
}

std::optional<SeatReadout::Cell> SeatReadout::cell(int k, int j) const {
  const int size = cells_.size(), opposite = solver_.order() - j;
  if (k >= 0 && k < size) return Cell{k, j, 1, 0};
  if (k < 0 && k >= -size && cells_.window.from == 0) {
    return Cell{-1 - k, opposite, -1, 0};
  }
  if (k >= size && k < 2 * size && cells_.window.to == pi) {
    return Cell{2 * size - 1 - k, opposite, -1, 2 * pi};
  }
  return {};
}

bool SeatReadout::touches(int k, int j) const {
  const auto at = cell(k, j);
  return at && patch_.contact(at->i, at->j) > 0;
}

// The five cells in contact that are nearest to one, or those there are.
SeatReadout::Run SeatReadout::around(int k, int j) const {
  Run run{k, k};
  while (run.last < k + 2 && touches(run.last + 1, j)) ++run.last;
  while (run.first > run.last - 4 && touches(run.first - 1, j)) --run.first;
  while (run.last < run.first + 4 && touches(run.last + 1, j)) ++run.last;
  return run;
}

// Parabola of f = p/g about the middle of the cell, whose means over cells with
// the weight w_i sin v are a_i p_i.
Vector3d SeatReadout::parabola(int k, int j) const {
  const Run run = around(k, j);
  const int count = run.last - run.first + 1;
  const int terms = std::min(3, count);
  Eigen::MatrixXd moments(count, 3);
  Eigen::VectorXd means(count);
  for (int n = 0; n < count; ++n) {
    const Cell of = *cell(run.first + n, j);
    const double mean = cells_.mean_angle(of.i);
    const double x = of.offset + of.sign * mean - cells_.mean_angle(k);
    moments.row(n) << 1, x, cells_.mean_square(of.i) - mean * mean + x * x;
    means(n) = cells_.mean_shape(of.i) * patch_.pressure(of.i, of.j);
  }
  Vector3d f = Vector3d::Zero();
  f.head(terms) = solve_least_squares(moments.leftCols(terms), means);
  return f;
}

// In a cell. Where the contact ends the parabola goes on below 0.
double SeatReadout::pressure(const Vector3d& f, int k, double v) const {
  const double x = v - cells_.mean_angle(k);
  const double value = f(0) + x * (f(1) + x * f(2));
  return value > 0 ? cells_.shape(v) * value : 0;
}

double SeatReadout::pressure(double v, int j) const {
  const double* begin = cells_.bound.data();
  const auto above = std::upper_bound(begin, begin + cells_.bound.size(), v);
  const int at =
      std::clamp(static_cast<int>(above - begin) - 1, 0, cells_.size() - 1);
  return touches(at, j) ? pressure(parabola(at, j), at, v) : 0;
}

double SeatReadout::pressure(double v, double longitude) const {
  const int last = solver_.order();
  const double turn = std::abs(std::remainder(longitude, 2 * pi));
  const double at = turn / solver_.longitude(1);
  const int j = std::min(static_cast<int>(at), last - 1);
  const double share = at - j;
  // At a rim both may be infinite.
  const double p = share < 1 ? (1 - share) * pressure(v, j) : 0;
  return share > 0 ? p + share * pressure(v, j + 1) : p;
}

double SeatReadout::half_width(double direction) const {
  const auto at = [&](double t) {
    const double v = std::acos(std::cos(t) * std::cos(direction));
    const double phi =
        std::atan2(std::sin(t), std::cos(t) * std::sin(direction));
    const bool on_seat = v >= cells_.window.from && v <= cells_.window.to;
    return on_seat ? pressure(v, phi) : 0;
  };
  const double step = solver_.longitude(1);
  double end = 0;
  while (end < pi && at(end) > 0) end += step / 8;
  // At the end the longitudes are too coarse. Before it p^2 is straight, over a
  // thin layer p.
  const double power = cells_.edge_width < step ? 1 : 2;
  const double far = end - 1.5 * step;
  const double p = std::pow(at(far), power);
  const double before = std::pow(at(far - step), power);
  if (!(far > step && before > p && p > 0)) return end;
  return std::clamp(far + step * p / (before - p), end - step, end);
}

SeatReadout::Peak SeatReadout::peak(double rim_distance) const {
  const SeatWindow& window = cells_.window;
  const double low = window.from + (window.rim[0] ? rim_distance : 0);
  const double high = window.to - (window.rim[1] ? rim_distance : 0);
  const Peak near = peak(low, high, 0);
  const Peak far = peak(low, high, solver_.order());
  return far.pressure > near.pressure ? far : near;
}

SeatReadout::Peak SeatReadout::peak(double low, double high, int j) const {
  constexpr int parts = 16;  // parts of a cell: a maximum is flat
  Peak peak{0, nan, nan};
  for (int i = 0; i < cells_.size(); ++i) {
    const double from = std::max(low, cells_.bound(i));
    const double to = std::min(high, cells_.bound(i + 1));
    if (patch_.contact(i, j) == 0 || !(to >= from)) continue;
    const Vector3d f = parabola(i, j);
    for (int k = 0; k <= parts; ++k) {
      const double v = from + (to - from) * k / parts;
      const double p = pressure(f, i, v);
      if (p > peak.pressure) peak = {p, v, solver_.longitude(j)};
    }
  }
  return peak;
}

// The largest p |w x r| on a longitude, k below 0 on the other side of the
// plane, between two polar angles.
SeatReadout::Best SeatReadout::best(const Vector3d& axis, double from,
                                    double to, int k) const {
  constexpr int parts = 32;  // over two cells: a maximum is flat
  const int j = std::abs(k);
  Best best{0, from};
  for (int i = 0; i <= parts; ++i) {
    const double v = from + (to - from) * i / parts;
    const double value = pressure(v, j) * lever(axis, v, longitude(k));
    if (value > best.value) best = {value, v};
  }
  return best;
}

double SeatReadout::longitude(int k) const {
  return k < 0 ? -solver_.longitude(-k) : solver_.longitude(k);
}

SeatReadout::Slip SeatReadout::slip(const Vector3d& axis,
                                    double rim_distance) const {
  const SeatWindow& window = cells_.window;
  const double low = window.from + (window.rim[0] ? rim_distance : 0);
  const double high = window.to - (window.rim[1] ? rim_distance : 0);
  const int last = solver_.order();
  Slip slip{0, nan, Vector3d::Constant(nan)};
  const Eigen::MatrixXd share = covered();
  double most = 0, area = 0;
  int cell = 0, node = 0;
  for (int k = 1 - last; k <= last; ++k) {
    const int j = std::abs(k);
    const double weight =
        solver_.longitude_weight(j) / (j == 0 || j == last ? 1 : 2);
    for (int i = 0; i < cells_.size(); ++i) {
      area += weight * cells_.unit(i) * share(i, j);
      if (patch_.contact(i, j) == 0) continue;
      const double v = cells_.mean_angle(i);
      const double p = patch_.pressure(i, j);
      slip.total += weight * cells_.unit(i) * p * lever(axis, v, longitude(k));
      const double inside = std::clamp(v, low, high);
      if (inside < cells_.bound(i) || inside > cells_.bound(i + 1)) continue;
      const double value = pressure(inside, j) * lever(axis, v, longitude(k));
      if (value > most) {
        most = value;
        cell = i;
        node = k;
      }
    }
  }
  if (!(most > 0)) return slip;
  const double from = std::max(low, cells_.mean_angle(std::max(cell - 1, 0)));
  const double to =
      std::min(high, cells_.mean_angle(std::min(cell + 1, cells_.size() - 1)));
  std::array<Best, 3> at;
  for (const int side : {-1, 0, 1}) {
    int k = node + side;
    if (k > last) k -= 2 * last;
    if (k <= -last) k += 2 * last;
    at[side + 1] = best(axis, from, to, k);
  }
  // The parabola through three longitudes.
  const double slope = (at[2].value - at[0].value) / 2;
  const double bend = at[2].value - 2 * at[1].value + at[0].value;
  const double x = bend < 0 ? std::clamp(-slope / bend, -1.0, 1.0) : 0;
  slip.largest = at[1].value + x * (slope + x * bend / 2);
  const double v =
      at[1].polar_angle + x * (at[2].polar_angle - at[0].polar_angle) / 2;
  slip.place = direction(v, longitude(node) + x * solver_.longitude(1));
  // It lies nearer to a rim.
  if (slip.largest < slip.total / area) {
    return {slip.total, nan, Vector3d::Constant(nan)};
  }
  return slip;
}

// f at the rim by the line through the two cells there.
double SeatReadout::rim_strength(int rim, int j) const {
  const int i = cells_.rim_cell(rim), next = rim == 0 ? i + 1 : i - 1;
  const auto f = [&](int cell) {
    return cells_.mean_shape(cell) * patch_.pressure(cell, j);
  };
  if (cells_.window.is_free) return f(i);
  const auto distance = [&](int cell) {
    return std::abs(cells_.mean_angle(cell) - cells_.window.angle(rim));
  };
  const double slope = patch_.contact(next, j) == 0
                           ? 0
                           : (f(next) - f(i)) / (distance(next) - distance(i));
  return std::max(f(i) - slope * distance(i), 0.0) * cells_.rim_shape(rim);
}

SeatReadout::Rim SeatReadout::rim(int rim) const {
  if (!cells_.window.rim[rim]) return {0, nan, 0};
  const int last = solver_.order();
  const int cell = cells_.rim_cell(rim);
  const bool far = rim_strength(rim, last) > rim_strength(rim, 0);
  // From the longitude where it is largest.
  const auto node = [&](int k) { return far ? last - k : k; };
  if (patch_.contact(cell, node(0)) == 0) return {0, nan, 0};
  int end = 0;
  while (end < last && patch_.contact(cell, node(end + 1)) > 0) ++end;
  double steps = end;
  if (end < last && end > 1) {
    // Like a root.
    const double p = std::pow(rim_strength(rim, node(end)), 2);
    const double before = std::pow(rim_strength(rim, node(end - 1)), 2);
    steps += before > p ? std::clamp(p / (before - p), 0.0, 1.0) : 0.5;
  }
  return {rim_strength(rim, node(0)), far ? pi : 0.0,
          solver_.longitude(1) * steps};
}

// Like a root: p^2 is smooth, but for the last cells, which are in contact to a
// part only or not counted at all.
double SeatReadout::end(const Run& run, int j, int side) const {
  const int edge = side == 0 ? run.first : run.last;
  const int inwards = side == 0 ? 1 : -1;
  const double bound = cells_.bound(edge + side);
  if (edge == cells_.rim_cell(side)) return bound;
  const double size = cells_.bound(edge + 1) - cells_.bound(edge);
  if (run.last - run.first < 4) return bound;
  Eigen::Matrix3d powers;
  Eigen::Vector3d square;
  for (int k = 0; k < 3; ++k) {
    const int i = edge + inwards * (2 + k);
    const double x = (cells_.mean_angle(i) - bound) * inwards;
    powers.row(k) << 1, x, x * x;
    square(k) = std::pow(patch_.pressure(i, j), 2);
  }
  const Eigen::Vector3d c = solve_square(powers, square);
  const double rest = c(1) * c(1) - 4 * c(0) * c(2);
  // Over a thin layer p itself is smooth, and the root a double one.
  const double slope = c(1) + 2 * c(2) * powers(0, 1);
  const bool is_double = rest < 0.1 * slope * slope;
  const double x = is_double  ? -c(1) / (2 * c(2))
                   : c(1) > 0 ? -2 * c(0) / (c(1) + std::sqrt(rest))
                              : (std::sqrt(rest) - c(1)) / (2 * c(2));
  return std::isfinite(x) ? bound + inwards * std::clamp(x, -size, size)
                          : bound;
}

SeatReadout::Ends SeatReadout::ends(int j) const {
  const std::vector<Run> all = runs(j);
  if (all.empty()) return {nan, nan};
  return {end(all.front(), j, 0), end(all.back(), j, 1)};
}

Eigen::MatrixXd SeatReadout::covered() const {
  Eigen::MatrixXd share =
      Eigen::MatrixXd::Zero(cells_.size(), solver_.order() + 1);
  for (int j = 0; j <= solver_.order(); ++j) {
    for (const Run& run : runs(j)) {
      const double from = end(run, j, 0), to = end(run, j, 1);
      for (int i = 0; i < cells_.size(); ++i) {
        const double low = std::max(from, cells_.bound(i));
        const double high = std::min(to, cells_.bound(i + 1));
        if (high <= low) continue;
        share(i, j) += (std::cos(low) - std::cos(high)) / cells_.unit(i);
      }
    }
  }
  return share;
}

}  // namespace contact::detail
