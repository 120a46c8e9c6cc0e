#include "libcontact/friction/rules/log_corrections.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/base/gauss_legendre.hpp"

namespace contact::detail::rules {

/// @param vanishing, weight  T and weight of node i of n
/// @param moment  integral of T^j ln T
template <class Vanishing, class Weight, class Moment>
LogCorrections::LogCorrections(int n, Vanishing vanishing, Weight weight,
                               Moment moment) {
  const int count = std::min(most, n - 1);
  first_ = n - count;
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, most, most> powers(
      count, count);
  Column missing(count);
  for (int row = 0; row < count; ++row) {
    const int j = row + 2;
    missing[row] = moment(j);
    for (int i = 0; i < n; ++i) {
      const Real t = vanishing(i);
      const Real value = weight(i) * std::pow(t, j);
      missing[row] -= value * std::log(t);
      if (i >= first_) powers(row, i - first_) = value;
    }
  }
  value_ = powers.fullPivLu().solve(missing);
}

LogCorrections LogCorrections::midpoint(int n, Real steps) {
  const Real quarter = pi / 2;
  const auto vanishing = [=](int i) {
    const Real c = std::cos(quarter * (i + 0.5L) / steps);
    return c * c;
  };
  // The derivative of half of Euler's B(j + 1/2, 1/2).
  const auto moment = [=](int j) {
    Real beta = quarter;
    Real log = -2 * std::numbers::ln2_v<Real>;
    for (int i = 1; i <= j; ++i) {
      beta *= (2 * i - Real(1)) / (2 * i);
      log += Real(2) / (2 * i - 1) - Real(1) / i;
    }
    return beta * log;
  };
  return {n, vanishing, [=](int) { return quarter / steps; }, moment};
}

LogCorrections LogCorrections::gauss(const GaussRule<Real>& rule) {
  const int n = static_cast<int>(rule.node.size()) / 2;
  const auto vanishing = [&](int i) {
    const Real x = rule.node(n + i);
    return (1 - x) * (1 + x);
  };
  const auto weight = [&](int i) { return rule.weight(n + i); };
  // The derivative of half of B(1/2, j + 1).
  const auto moment = [](int j) {
    Real beta = 1;
    Real log = 2 * std::numbers::ln2_v<Real> - 2;
    for (int i = 1; i <= j; ++i) {
      beta *= 2 * i / (2 * i + Real(1));
      log += Real(1) / i - Real(2) / (2 * i + 1);
    }
    return beta * log;
  };
  return {n, vanishing, weight, moment};
}

Real LogCorrections::log_square(Real cosine, int i) const {
  return 2 * std::log(cosine) + (i < first_ ? 0 : value_[i - first_]);
}

}  // namespace contact::detail::rules
