#include "libcontact/conforming/back_displacement.hpp"

#include <cmath>
#include <complex>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/conforming/kernel/ball_kernel.hpp"

namespace contact::detail {
namespace {

using Complex = std::complex<double>;

// s(N) = sum over its poles of residue/(N - pole): sigma(s) is the sum of
// residue exp(pole s). Poles: 3/2 and -nu +- i omega.
class Density {
 public:
  explicit Density(double nu)
      : pole_(-nu, std::sqrt(0.75 - nu * nu)),
        real_residue_((numerator(1.5, nu) / (g(nu) * (3 + 3 * nu))).real()),
        residue_(numerator(pole_, nu) /
                 (g(nu) * (pole_ - 1.5) * Complex(0, 2 * pole_.imag()))) {}

  double operator()(double s) const {
    return real_residue_ * std::exp(1.5 * s) +
           2 * (residue_ * std::exp(pole_ * s)).real();
  }

 private:
  static double g(double nu) { return 2 * (1 - nu); }
  static Complex numerator(Complex n, double nu) {
    return (g(nu) * n + (3 * nu - 2)) * n + (nu - 0.5);
  }

  Complex pole_;
  double real_residue_;
  Complex residue_;
};

}  // namespace

BackDisplacement::BackDisplacement(double nu, double psi)
    : cosine_patch_(std::cos(psi)), series_end_(0.8 * (pi - psi)) {
  const Density density(nu);
  const GaussLegendre rule(nodes);
  std::array<double, nodes> s;
  for (int i = 0; i < nodes; ++i) {
    // s = upper_end y^3: crowded at s = 0, towards the singularity at
    // s = +-i (pi - psi - f).
    const double y = (1 + rule.node(i)) / 2;
    s[i] = upper_end * y * y * y;
    decay_[i] = std::exp(-s[i]);
    half_decay_[i] = std::exp(-s[i] / 2);
    weight_[i] = 1.5 * upper_end * y * y * rule.weight(i) * density(s[i]);
  }

  // q_n = (-1)^n (P_{n-1}(c) - P_{n+1}(c))/(2 sin^2 psi) =
  // (-1)^n (2n+1)/(2 n (n+1)) P_n'(c), q_0 = 1/(2 (1+c)): no cancellation at
  // psi = 0. P_n' by its own recurrence.
  const double c = cosine_patch_;
  double slope_before = 0;  // P_{n-1}'
  double slope = 1;         // P_n' at n = 1
  for (int n = 0; n < head_terms; ++n) {
    double q = 1 / (2 * (1 + c));
    if (n > 0) {
      q = (n % 2 == 0 ? 1 : -1) * (2 * n + 1) / (2.0 * n * (n + 1)) * slope;
      const double next =
          ((2 * n + 1) * c * slope - (n + 1) * slope_before) / n;
      slope_before = slope;
      slope = next;
    }
    double covered = 0;
    for (int i = 0; i < nodes; ++i) {
      covered += weight_[i] * std::exp(-(n + 0.5) * s[i]);
    }
    head_[n] = q * ((n == 1 ? 0 : ball_compliance(n, nu)) - covered);
  }

  series_ = {series_terms, [&](double half_phase) {
               return Eigen::RowVectorXd::Constant(
                   1, by_quadrature(series_end_ * std::cos(half_phase)));
             }};
}

double BackDisplacement::operator()(double f) const {
  const double v = f / series_end_;
  if (std::abs(v) > 1) return by_quadrature(f);
  return series_.value(0, 2 * v * v - 1);
}

double BackDisplacement::by_quadrature(double f) const {
  // sum q_n r^(n+1/2) = sqrt(r) (1-r) / ((1+c) S (1+r+S)),
  // S = sqrt(1 + 2 c r + r^2), r = exp(-s + i f).
  const Complex turn = std::polar(1.0, f);
  const Complex half_turn = std::polar(1.0, f / 2);
  double sum = 0;
  for (int i = 0; i < nodes; ++i) {
    const Complex r = decay_[i] * turn;
    const Complex root = std::sqrt(1.0 + r * (2 * cosine_patch_ + r));
    sum += weight_[i] * half_decay_[i] *
           (half_turn * (1.0 - r) / (root * (1.0 + r + root))).real();
  }
  sum /= 1 + cosine_patch_;
  for (int n = 0; n < head_terms; ++n)
    sum += head_[n] * std::cos((n + 0.5) * f);
  return 2 / pi * sum;
}

}  // namespace contact::detail
