#include "libcontact/half_angle/closing_table.hpp"

#include <algorithm>
#include <cmath>

namespace contact::detail {
namespace {

double square(double v) { return v * v; }

}  // namespace

ClosingTable::ClosingTable(const Solver& solver, double largest,
                           double thickness, double mean, double first,
                           int nodes)
    : largest_(largest),
      mean_(mean),
      first_(first),
      series_(std::min({thickness, 1.0, std::sqrt(mean)}), largest) {
  const auto row = [&](double opening) -> Eigen::RowVectorXd {
    const SignedContact c = solver(opening);
    const double unit = square(std::sin(opening / 2));
    return Eigen::RowVector4d(std::log(c.beyond_closure / unit),
                              c.mean_deficit / unit, c.gap_shift,
                              c.gap_compliance);
  };
  for (const int count : {nodes, 64, 96}) {
    series_.tabulate(count, row);
    if (series_.is_resolved()) break;
  }
}

SignedContact ClosingTable::at(double opening) const {
  const Eigen::RowVectorXd s = series_.at(opening, series_.columns());
  const double unit = square(std::sin(opening / 2));
  const double beyond = unit * std::exp(s(0));
  return {beyond - mean_, beyond, unit * s(1), s(2), s(3)};
}

ClosingTable::Root ClosingTable::opening(double inverse) const {
  // Newton's steps in ln psi, because ln(x + c_0) is nearly 2 ln psi; a step
  // that leaves the bracket is replaced by halving it.
  const double target = std::log(inverse + mean_);
  double low = 0;
  double high = largest_;
  double opening = std::min(
      largest_, 2 * std::asin(std::min(
                        1.0, std::exp((target - series_.first(0).value) / 2))));
  // Four steps are usual.
  constexpr int step_limit = 80;
  // The step after one of this size would be rounding.
  constexpr double last_step = 1e-8;
  double slope = 0;
  for (int step = 0; step < step_limit; ++step) {
    const OpeningSeries::Value w = series_.first(opening);
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
