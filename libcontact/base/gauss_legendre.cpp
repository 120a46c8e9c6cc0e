#include "libcontact/base/gauss_legendre.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace contact::detail {

namespace {

// P_size and P_{size - 1}.
template <class Array>
std::pair<Array, Array> last_two(int size, const Array& x) {
  using Scalar = typename Array::Scalar;
  Array previous = Array::Ones(x.size());
  Array current = x;
  for (int n = 2; n <= size; ++n) {
    const Scalar part = Scalar(n - 1) / n;
    previous = x * current + part * (x * current - previous);
    previous.swap(current);
  }
  return {std::move(current), std::move(previous)};
}

}  // namespace

GaussLegendre::GaussLegendre(int size) : node(size), weight(size) {
  const int half = (size + 1) / 2;
  // The largest zeros, decreasing, by Tricomi's formula to order size^-4.
  const double n3 = 8.0 * size * size * size;
  Eigen::ArrayXd x(half);
  for (int i = 0; i < half; ++i) {
    x(i) = (1 - (size - 1) / n3) *
           std::cos(std::numbers::pi * (i + 0.75) / (size + 0.5));
  }
  // Newton's steps. Only the last one needs more digits: where software
  // computes these, they cost fifty times as much.
  for (int step = 0; step < 3; ++step) {
    const auto [value, previous] = last_two(size, x);
    x -= value * (1 - x) * (1 + x) / (size * (previous - x * value));
  }
  using Long = Eigen::ArrayX<long double>;
  const Long at = x.cast<long double>();
  const auto [value, previous] = last_two(size, at);
  const Long rest = (1 - at) * (1 + at);
  const Long slope = size * (previous - at * value) / rest;
  const Long step = -value / slope;
  const Long zero = at + step;
  // The slope at the zero, (1 - x^2) P'' = 2 x P' there.
  const Long w = 2 / ((rest - 2 * at * step) *
                      (slope * (1 + 2 * at * step / rest)).square());
  node.head(half) = -zero.matrix().cast<double>();
  node.tail(half) = zero.matrix().reverse().cast<double>();
  if (size % 2 == 1) node(half - 1) = 0;
  weight.head(half) = w.matrix().cast<double>();
  weight.tail(half) = weight.head(half).reverse();
}

namespace {

// P_first, P_{first + 2}, ..., `count` of them.
Eigen::MatrixXd every_other_legendre(int first, int count,
                                     const Eigen::VectorXd& x) {
  Eigen::MatrixXd values(x.size(), count);
  Eigen::ArrayXd previous = Eigen::ArrayXd::Ones(x.size());
  Eigen::ArrayXd current = x;
  for (int n = 0; n < 2 * count - 1 + first; ++n) {
    if (n % 2 == first) values.col(n / 2) = previous;
    previous = (2 * n + 3.0) / (n + 2) * x.array() * current -
               (n + 1.0) / (n + 2) * previous;
    previous.swap(current);
  }
  return values;
}

}  // namespace

Eigen::MatrixXd even_legendre(int count, const Eigen::VectorXd& x) {
  return every_other_legendre(0, count, x);
}

Eigen::MatrixXd odd_legendre(int count, const Eigen::VectorXd& x) {
  return every_other_legendre(1, count, x);
}

Eigen::MatrixXd even_legendre_slope(int count) {
  // Polynomials of degree `terms` - 1 in v^2: their values at as many Chebyshev
  // points make the series.
  const int terms = count - 1;
  Eigen::MatrixXd value(terms, count);
  Eigen::MatrixXd transform(terms, terms);
  for (int i = 0; i < terms; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / terms;
    const double v = std::cos(angle / 2);
    // P_{2j}' - P_{2j-2}' = (4j - 1) P_{2j-1}.
    double even = 1;
    double odd = v;
    value(i, 0) = 0;
    for (int j = 1; j < count; ++j) {
      value(i, j) = value(i, j - 1) + (4 * j - 1) * odd / v;
      even = ((4 * j - 1) * v * odd - (2 * j - 1) * even) / (2 * j);
      odd = ((4 * j + 1) * v * even - 2 * j * odd) / (2 * j + 1);
    }
    for (int k = 0; k < terms; ++k) {
      transform(k, i) = (k == 0 ? 1.0 : 2.0) / terms * std::cos(k * angle);
    }
  }
  return transform * value;
}

}  // namespace contact::detail
