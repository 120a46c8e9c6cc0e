#include "libcontact/half_angle/closing_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contact::detail {
namespace {

constexpr double pi = std::numbers::pi;

// Of the last coefficients: what is cut off is as large.
constexpr double negligible = 1e-8;

double square(double v) { return v * v; }

}  // namespace

ClosingTable::ClosingTable(const Solver& solver, double largest,
                           double thickness, double mean, double first,
                           int nodes)
    : largest_(largest),
      thickness_(std::min({thickness, 1.0, std::sqrt(mean)})),
      range_(std::log1p(largest / thickness_)),
      mean_(mean),
      first_(first) {
  for (const int count : {nodes, 64, 96}) {
    tabulate(solver, count);
    if (is_resolved()) break;
  }
}

void ClosingTable::tabulate(const Solver& solver, int count) {
  Eigen::MatrixXd values(count, columns);
  Eigen::MatrixXd chebyshev(count, count);
  for (int i = 0; i < count; ++i) {
    const double phi = pi * (i + 0.5) / count;
    const double share = square(std::cos(phi / 2));
    const double opening = thickness_ * std::expm1(range_ * share);
    const SignedContact c = solver(opening);
    const double unit = square(std::sin(opening / 2));
    values.row(i) << std::log(c.beyond_closure / unit), c.mean_deficit / unit,
        c.gap_shift, c.gap_compliance;
    for (int k = 0; k < count; ++k) {
      chebyshev(k, i) = (k == 0 ? 1.0 : 2.0) / count * std::cos(k * phi);
    }
  }
  coefficients_ = chebyshev * values;
}

bool ClosingTable::is_resolved() const {
  return (coefficients_.col(0).tail(3).array().abs() < negligible).all();
}

double ClosingTable::variable(double opening) const {
  return 2 * std::log1p(opening / thickness_) / range_ - 1;
}

Eigen::RowVectorXd ClosingTable::series(double opening) const {
  const double v = variable(opening);
  Eigen::RowVectorXd b0 = Eigen::RowVectorXd::Zero(columns);
  Eigen::RowVectorXd b1 = b0;
  for (Eigen::Index k = coefficients_.rows() - 1; k > 0; --k) {
    b1 = 2 * v * b0 - b1 + coefficients_.row(k);
    b0.swap(b1);
  }
  return v * b0 - b1 + coefficients_.row(0);
}

ClosingTable::Value ClosingTable::logarithm(double opening) const {
  const double v = variable(opening);
  double b0 = 0, b1 = 0, d0 = 0, d1 = 0;
  for (Eigen::Index k = coefficients_.rows() - 1; k > 0; --k) {
    const double d = 2 * b0 + 2 * v * d0 - d1;
    d1 = d0;
    d0 = d;
    const double b = coefficients_(k, 0) + 2 * v * b0 - b1;
    b1 = b0;
    b0 = b;
  }
  const double slope = b0 + v * d0 - d1;
  return {coefficients_(0, 0) + v * b0 - b1,
          slope * 2 / (range_ * (thickness_ + opening))};
}

SignedContact ClosingTable::at(double opening) const {
  const Eigen::RowVectorXd s = series(opening);
  const double unit = square(std::sin(opening / 2));
  const double beyond = unit * std::exp(s(0));
  return {beyond - mean_, beyond, unit * s(1), s(2), s(3)};
}

ClosingTable::Root ClosingTable::opening(double inverse) const {
  // Newton's steps in ln psi, of which ln(x + c_0) is nearly twice; a step that
  // leaves the bracket is replaced by halving it.
  const double target = std::log(inverse + mean_);
  double low = 0;
  double high = largest_;
  double opening = std::min(
      largest_, 2 * std::asin(std::min(
                        1.0, std::exp((target - logarithm(0).value) / 2))));
  // Four steps are usual.
  constexpr int step_limit = 80;
  // The step after one of this size would be rounding.
  constexpr double last_step = 1e-8;
  double slope = 0;
  for (int step = 0; step < step_limit; ++step) {
    const Value w = logarithm(opening);
    const double half = opening / 2;
    const double residual = w.value + 2 * std::log(std::sin(half)) - target;
    slope = w.slope + 1 / std::tan(half);
    const double move = -residual / (slope * opening);
    if (std::abs(move) <= last_step) {
      opening = std::min(opening * (1 + move), largest_);
      break;
    }
    (residual > 0 ? high : low) = opening;
    opening *= std::exp(move);
    if (!(opening > low && opening < high)) opening = (low + high) / 2;
  }
  return {opening, 1 / slope};
}

}  // namespace contact::detail
