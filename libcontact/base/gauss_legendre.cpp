#include "libcontact/base/gauss_legendre.hpp"

#include <boost/math/special_functions/chebyshev.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <numbers>

namespace contact::detail {

GaussLegendre::GaussLegendre(int size) : node(size), weight(size) {
  // The zeros that are not negative, increasing.
  const auto zeros = boost::math::legendre_p_zeros<double>(size);
  const int half = size / 2;
  const int middle = size % 2;
  for (int i = 0; i < static_cast<int>(zeros.size()); ++i) {
    const double x = zeros[i];
    const double slope = boost::math::legendre_p_prime(size, x);
    const double w = 2 / ((1 - x) * (1 + x) * slope * slope);
    const int right = half + i;
    const int left = half + middle - 1 - i;
    node(right) = x;
    weight(right) = w;
    node(left) = -x;
    weight(left) = w;
  }
}

Eigen::VectorXd even_legendre(int count, double x) {
  Eigen::VectorXd values(count);
  double previous = 1;
  double current = x;
  for (int n = 0; n < 2 * count - 1; ++n) {
    if (n % 2 == 0) values(n / 2) = previous;
    const double next = boost::math::legendre_next(n + 1, x, current, previous);
    previous = current;
    current = next;
  }
  return values;
}

EvenLegendreSlope::EvenLegendreSlope(std::span<const double> u)
    : terms_(static_cast<int>(u.size()) - 1) {
  // u' = sum over odd k of c_k P_k, c_k = (2k+1) sum_{2j > k} u_j, from
  // P_{n+1}' - P_{n-1}' = (2n+1) P_n.
  std::array<double, max_terms> c;
  double sum = 0;
  for (int j = terms_; j >= 1; --j) {
    sum += u[j];
    c[j - 1] = (4 * j - 1) * sum;
  }
  // A polynomial of degree terms_ - 1 in v^2: its values at as many Chebyshev
  // points make the series.
  for (int i = 0; i < terms_; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / terms_;
    const double v = std::cos(angle / 2);
    double previous = 1;
    double current = v;
    double value = 0;
    for (int k = 1; k < 2 * terms_; ++k) {
      if (k % 2 == 1) value += c[k / 2] * current / v;
      const double next = boost::math::legendre_next(k, v, current, previous);
      previous = current;
      current = next;
    }
    for (int k = 0; k < terms_; ++k) {
      series_[k] += 2 * value / terms_ * std::cos(k * angle);
    }
  }
}

double EvenLegendreSlope::operator()(double v) const {
  return boost::math::chebyshev_clenshaw_recurrence(series_.data(), terms_,
                                                    2 * v * v - 1);
}

}  // namespace contact::detail
