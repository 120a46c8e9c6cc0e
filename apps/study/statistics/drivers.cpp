#include "study/statistics/drivers.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Mean and its standard error.
struct Mean {
  double value;
  double error;
};
Mean mean_of(const std::vector<double>& terms) {
  const auto n = static_cast<double>(terms.size());
  const double mean = std::accumulate(terms.begin(), terms.end(), 0.0) / n;
  double squares = 0;
  for (const double term : terms) squares += (term - mean) * (term - mean);
  return {mean, std::sqrt(squares / (n - 1) / n)};
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
  // What does not vary correlates with nothing, not even itself.
  for (double& s : scale) s = s > 0 ? 1 / s : 0;
  covariance = scale.asDiagonal() * covariance * scale.asDiagonal();
  for (Eigen::Index i = 0; i < inputs; ++i) {
    if (scale[i] == 0) covariance(i, i) = 1;
  }
  const Eigen::VectorXd with_output = covariance.col(inputs).head(inputs);
  const Eigen::VectorXd solution =
      covariance.topLeftCorner(inputs, inputs).ldlt().solve(with_output);
  std::ranges::copy(solution, answer.standardised.begin());
  answer.explained = solution.dot(with_output);
  return answer;
}

std::vector<SobolIndex> sobol_indices(std::span<const double> outputs,
                                      std::size_t sources) {
  const std::size_t size = sources + 2;
  std::vector<std::span<const double>> groups;
  std::vector<double> both;
  for (std::size_t i = 0; i + size <= outputs.size(); i += size) {
    const auto group = outputs.subspan(i, size);
    if (std::ranges::any_of(group, [](double x) { return std::isnan(x); })) {
      continue;
    }
    groups.push_back(group);
    both.insert(both.end(), {group[0], group[1]});
  }
  std::vector<SobolIndex> result(sources, {nan, nan, nan, nan});
  if (groups.size() < 2) return result;
  const double mean = mean_of(both).value;
  double variance = 0;
  for (const double x : both) variance += (x - mean) * (x - mean);
  variance /= static_cast<double>(both.size() - 1);
  if (!(variance > 0)) return result;
  for (std::size_t i = 0; i < sources; ++i) {
    std::vector<double> first;
    std::vector<double> total;
    for (const auto& f : groups) {
      const double change = f[2 + i] - f[0];
      first.push_back((f[1] - mean) * change / variance);
      total.push_back(change * change / (2 * variance));
    }
    const auto [s, s_error] = mean_of(first);
    const auto [t, t_error] = mean_of(total);
    result[i] = {s, s_error, t, t_error};
  }
  return result;
}

}  // namespace study
