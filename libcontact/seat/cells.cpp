#include "libcontact/seat/cells.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"

namespace contact::detail {
namespace {

constexpr double growth = 1.25;  // growth of cells away from a rim

// Sizes of the cells from a rim on that are smaller than the even ones.
std::vector<double> graded(double first, double even) {
  std::vector<double> sizes;
  for (double h = first; h < even / std::sqrt(growth); h *= growth) {
    sizes.push_back(h);
  }
  return sizes;
}

Eigen::ArrayXd bounds(const SeatWindow& window, int count, double thickness) {
  const double even = window.width() / count;
  const double first = std::min(0.4 * even, thickness / 4);
  const std::vector<double> at_rim = graded(first, even);
  const std::vector<double> none;
  const auto& low = window.rim[0] ? at_rim : none;
  const auto& high = window.rim[1] ? at_rim : none;
  std::vector<double> sizes = low;
  double rest = window.width();
  for (const double h : low) rest -= h;
  for (const double h : high) rest -= h;
  const int middle = std::max(1, static_cast<int>(std::lround(rest / even)));
  sizes.insert(sizes.end(), middle, rest / middle);
  sizes.insert(sizes.end(), high.rbegin(), high.rend());
  Eigen::ArrayXd v(sizes.size() + 1);
  v(0) = window.from;
  for (std::size_t i = 0; i < sizes.size(); ++i) v(i + 1) = v(i) + sizes[i];
  v(v.size() - 1) = window.to;
  return v;
}

}  // namespace

SeatCells::SeatCells(const SeatWindow& of, int count, double thickness)
    : window(of),
      edge_width(std::min(thickness, window.width())),
      bound(bounds(window, count, thickness)) {
  const auto n = bound.size() - 1;
  unit = bound.head(n).cos() - bound.tail(n).cos();
  mean_shape = unit;
  // Moments, which are as smooth as g: 1e-15.
  const Rule rule = rule_of_shape(0);
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(n);
  sine = cosine = mean_angle = mean_square = sum;
  for (Eigen::Index k = 0; k < rule.cell.size(); ++k) {
    const int i = rule.cell(k);
    const double v = rule.angle(k), weight = rule.weight(k);
    sum(i) += weight;
    sine(i) += weight * std::sin(v);
    cosine(i) += weight * std::cos(v);
    mean_angle(i) += weight * v;
    mean_square(i) += weight * v * v;
  }
  mean_angle /= sum;
  mean_square /= sum;
  mean_shape = unit / sum;
  sine *= mean_shape;
  cosine *= mean_shape;
}

double SeatCells::shape(double v) const {
  if (window.is_free) return 1;
  double square = 1;
  if (window.rim[0]) square *= 1 + edge_width / (v - window.from);
  if (window.rim[1]) square *= 1 + edge_width / (window.to - v);
  return std::sqrt(square);
}

double SeatCells::rim_shape(int rim) const {
  if (window.is_free) return 0;
  const bool other = window.rim[1 - rim];
  return std::sqrt(edge_width *
                   (other ? 1 + edge_width / window.width() : 1.0));
}

double SeatCells::smallest() const {
  const auto n = bound.size() - 1;
  return (bound.tail(n) - bound.head(n)).minCoeff();
}

SeatCells::Rule SeatCells::rule(int degree) const {
  Rule rule = rule_of_shape(degree);
  for (Eigen::Index k = 0; k < rule.cell.size(); ++k) {
    rule.weight(k) *= mean_shape(rule.cell(k));
  }
  return rule;
}

// With g sin v dv. Near a rim Gauss' rule in sqrt(s), in which g ds is smooth.
SeatCells::Rule SeatCells::rule_of_shape(int degree) const {
  std::vector<double> angle, weight;
  std::vector<int> cell;
  for (int i = 0; i + 1 < bound.size(); ++i) {
    const double low = bound(i), high = bound(i + 1), size = high - low;
    const bool lower = window.rim[0] && low - window.from < 6 * size;
    const bool upper = !lower && window.rim[1] && window.to - high < 6 * size;
    // N_nm turns n h/pi times by half a turn; fewer points alias.
    const GaussLegendre gauss(
        8 + static_cast<int>(std::ceil(1.6 * degree * size / pi)));
    for (Eigen::Index k = 0; k < gauss.node.size(); ++k) {
      double v = low + size * (1 + gauss.node(k)) / 2;
      double dv = size / 2 * gauss.weight(k);
      if (lower || upper) {
        const double near =
            std::sqrt(lower ? low - window.from : window.to - high);
        const double far =
            std::sqrt(lower ? high - window.from : window.to - low);
        const double root = near + (far - near) * (1 + gauss.node(k)) / 2;
        v = lower ? window.from + root * root : window.to - root * root;
        dv = (far - near) * root * gauss.weight(k);
      }
      angle.push_back(v);
      weight.push_back(shape(v) * std::sin(v) * dv);
      cell.push_back(i);
    }
  }
  const auto n = static_cast<Eigen::Index>(angle.size());
  return {Eigen::Map<Eigen::ArrayXd>(angle.data(), n),
          Eigen::Map<Eigen::ArrayXd>(weight.data(), n),
          Eigen::Map<Eigen::ArrayXi>(cell.data(), n)};
}

}  // namespace contact::detail
