#include "libcontact/tools/friction_rules/log_corrections.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/multiprecision/eigen.hpp>

namespace contact::detail::rules {
namespace {

/// By measurement; with 8 of 8 nodes the corrections are wild.
constexpr int most = 7;

/// @param moment  integral of T^j ln T
template <class Moment>
std::vector<Real> corrections(const std::vector<Real>& t,
                              const std::vector<Real>& weight, Moment moment) {
  const int n = static_cast<int>(t.size());
  const int count = std::min(most, n - 1);
  const int first = n - count;
  Eigen::MatrixX<Real> powers(count, count);
  Eigen::VectorX<Real> missing(count);
  for (int row = 0; row < count; ++row) {
    const int j = row + 2;
    missing[row] = moment(j);
    for (int i = 0; i < n; ++i) {
      const Real value = weight[i] * pow(t[i], j);
      missing[row] -= value * log(t[i]);
      if (i >= first) powers(row, i - first) = value;
    }
  }
  const Eigen::VectorX<Real> found = powers.fullPivLu().solve(missing);
  std::vector<Real> result(first);
  result.insert(result.end(), found.begin(), found.end());
  return result;
}

const Real ln_2 = boost::math::constants::ln_two<Real>();

}  // namespace

std::vector<Real> midpoint_log_corrections(int n) {
  const Real step = pi / (2 * n + 1);
  std::vector<Real> t;
  for (int i = 0; i < n; ++i) t.push_back(pow(cos(step * (i + 0.5)), 2));
  // The derivative of half of Euler's B(j + 1/2, 1/2).
  return corrections(t, std::vector<Real>(n, step), [](int j) {
    Real beta = pi / 2;
    Real sum = -2 * ln_2;
    for (int i = 1; i <= j; ++i) {
      beta *= (2 * i - Real(1)) / (2 * i);
      sum += Real(2) / (2 * i - 1) - Real(1) / i;
    }
    return beta * sum;
  });
}

std::vector<Real> gauss_log_corrections(const std::vector<Real>& x,
                                        const std::vector<Real>& weight) {
  std::vector<Real> t;
  for (const Real& v : x) t.push_back((1 - v) * (1 + v));
  // The derivative of half of B(1/2, j + 1).
  return corrections(t, weight, [](int j) {
    Real beta = 1;
    Real sum = 2 * ln_2 - 2;
    for (int i = 1; i <= j; ++i) {
      beta *= 2 * i / (2 * i + Real(1));
      sum += Real(1) / i - Real(2) / (2 * i + 1);
    }
    return beta * sum;
  });
}

}  // namespace contact::detail::rules
