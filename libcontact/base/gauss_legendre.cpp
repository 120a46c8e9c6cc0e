#include "libcontact/base/gauss_legendre.hpp"

#include <boost/math/special_functions/chebyshev.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <numbers>

namespace contact::detail {

GaussLegendre::GaussLegendre(int size) : node(size), weight(size) {
  using Array = Eigen::ArrayX<long double>;
  const int half = (size + 1) / 2;
  // The largest zeros, decreasing, by Tricomi's formula to order size^-4.
  const double n3 = 8.0 * size * size * size;
  Array x(half);
  for (int i = 0; i < half; ++i) {
    x(i) = (1 - (size - 1) / n3) *
           std::cos(std::numbers::pi * (i + 0.75) / (size + 0.5));
  }
  Array rest, slope;
  // Three of Newton's steps, and the slope.
  for (int step = 0; step < 4; ++step) {
    Array previous = Array::Ones(half);
    Array current = x;
    for (int n = 2; n <= size; ++n) {
      previous = (2 * n - 1.0L) / n * x * current - (n - 1.0L) / n * previous;
      previous.swap(current);
    }
    rest = (1 - x) * (1 + x);
    slope = size * (previous - x * current) / rest;
    if (step < 3) x -= current / slope;
  }
  const Array w = 2 / (rest * slope.square());
  node.head(half) = -x.matrix().cast<double>();
  node.tail(half) = x.matrix().reverse().cast<double>();
  if (size % 2 == 1) node(half - 1) = 0;
  weight.head(half) = w.matrix().cast<double>();
  weight.tail(half) = weight.head(half).reverse();
}

Eigen::MatrixXd even_legendre(int count, const Eigen::VectorXd& x) {
  Eigen::MatrixXd values(x.size(), count);
  Eigen::ArrayXd previous = Eigen::ArrayXd::Ones(x.size());
  Eigen::ArrayXd current = x;
  for (int n = 0; n < 2 * count - 1; ++n) {
    if (n % 2 == 0) values.col(n / 2) = previous;
    previous = (2 * n + 3.0) / (n + 2) * x.array() * current -
               (n + 1.0) / (n + 2) * previous;
    previous.swap(current);
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
