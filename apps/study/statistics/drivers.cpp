#include "study/statistics/drivers.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <set>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"

namespace study {
namespace {

using contact::detail::nan;

double square(double x) { return x * x; }

// Outputs of a point of Saltelli's design.
struct Group {
  Eigen::Index shift;
  std::span<const double> f;
};
std::vector<Group> whole_groups(std::span<const double> outputs,
                                std::size_t size, std::size_t shifts) {
  std::vector<Group> groups;
  for (std::size_t i = 0; (i + 1) * size <= outputs.size(); ++i) {
    const auto f = outputs.subspan(i * size, size);
    if (std::ranges::any_of(f, [](double x) { return std::isnan(x); })) {
      continue;
    }
    groups.push_back({static_cast<Eigen::Index>(i % shifts), f});
  }
  return groups;
}

// The ratio of two sums of independent parts, and its standard error from the
// spread of the parts' excess over the ratio times their own divisor. The mean
// of the parts' ratios would be biased, and their spread would not show the
// bias.
struct Ratio {
  double value;
  double error;
};
Ratio ratio(const Eigen::VectorXd& parts, const Eigen::VectorXd& divisors,
            std::size_t count) {
  const double value = parts.sum() / divisors.sum();
  const auto n = static_cast<double>(count);
  return {value, std::sqrt(n / (n - 1)) * (parts - value * divisors).norm() /
                     divisors.sum()};
}

}  // namespace

std::vector<double> ranks(std::span<const double> values) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isnan(values[i])) order.push_back(i);
  }
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<double> result(values.size(), nan);
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    const double rank = static_cast<double>(i + 1 + end) / 2;
    for (; i < end; ++i) result[order[i]] = rank;
  }
  return result;
}

double correlation(std::span<const double> a, std::span<const double> b) {
  double count = 0;
  double mean_a = 0;
  double mean_b = 0;
  double aa = 0;
  double bb = 0;
  double ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) || std::isnan(b[i])) continue;
    ++count;
    const double da = a[i] - mean_a;
    const double db = b[i] - mean_b;
    mean_a += da / count;
    mean_b += db / count;
    aa += da * (a[i] - mean_a);
    bb += db * (b[i] - mean_b);
    ab += da * (b[i] - mean_b);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : nan;
}

Regression::Regression(std::size_t inputs)
    : sums_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(inputs) + 1)),
      products_(Eigen::MatrixXd::Zero(sums_.size(), sums_.size())) {}

void Regression::add(std::span<const double> inputs, double output) {
  Eigen::VectorXd row(sums_.size());
  std::ranges::copy(inputs, row.begin());
  row[row.size() - 1] = output;
  if (row.hasNaN()) return;
  if (count_ == 0) origin_ = row;
  row -= origin_;
  ++count_;
  sums_ += row;
  products_.selfadjointView<Eigen::Lower>().rankUpdate(row);
}

Regression::Answer Regression::solve() const {
  const Eigen::Index inputs = sums_.size() - 1;
  Answer answer{std::vector<double>(static_cast<std::size_t>(inputs), nan),
                nan};
  if (count_ < static_cast<double>(inputs) + 2) return answer;
  Eigen::MatrixXd covariance = products_.selfadjointView<Eigen::Lower>();
  covariance -= sums_ * sums_.transpose() / count_;
  Eigen::VectorXd scale = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  if (!(scale[inputs] > 0)) return answer;
  // Constants have no correlation, not even with themselves.
  for (double& s : scale) s = s > 0 ? 1 / s : 0;
  covariance = scale.asDiagonal() * covariance * scale.asDiagonal();
  for (Eigen::Index i = 0; i < inputs; ++i) {
    if (scale[i] == 0) covariance(i, i) = 1;
  }
  const Eigen::VectorXd with_output = covariance.col(inputs).head(inputs);
  const Eigen::VectorXd solution = contact::detail::solve_symmetric(
      covariance.topLeftCorner(inputs, inputs), with_output);
  std::ranges::copy(solution, answer.standardised.begin());
  answer.explained = solution.dot(with_output);
  return answer;
}

std::vector<SobolIndex> sobol_indices(std::span<const double> outputs,
                                      std::size_t sources, std::size_t shifts) {
  const std::vector<Group> groups = whole_groups(outputs, sources + 2, shifts);
  double mean = 0;
  std::set<Eigen::Index> present;
  for (const auto& [shift, f] : groups) {
    present.insert(shift);
    mean += (f[0] + f[1]) / 2 / static_cast<double>(groups.size());
  }
  std::vector<SobolIndex> result(sources, {nan, nan, nan, nan});
  if (present.size() < 2) return result;
  // Sums of each shift.
  const auto zero = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(shifts));
  Eigen::VectorXd variance = zero;
  for (const auto& [shift, f] : groups) {
    variance[shift] += (square(f[0] - mean) + square(f[1] - mean)) / 2;
  }
  if (!(variance.sum() > 0)) return result;
  for (std::size_t i = 0; i < sources; ++i) {
    Eigen::VectorXd first = zero;
    Eigen::VectorXd total = zero;
    for (const auto& [shift, f] : groups) {
      const double change = f[2 + i] - f[0];
      first[shift] += (f[1] - mean) * change;
      total[shift] += square(change) / 2;
    }
    const auto [s, s_error] = ratio(first, variance, present.size());
    const auto [t, t_error] = ratio(total, variance, present.size());
    result[i] = {s, s_error, t, t_error};
  }
  return result;
}

}  // namespace study
