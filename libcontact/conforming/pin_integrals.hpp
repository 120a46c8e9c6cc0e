#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

/// Integrals of the Chebyshev-Galerkin solutions of a pin in a hole, by its
/// pressure (pin.cpp) or by its gap (pin_gap.cpp). tan(t/2) = b s, b = tan of
/// half the half-angle of the interval on which the unknown function lives,
/// q = tan of a quarter.
namespace contact::detail {

/// m_i = ∫ T_{2i}(s)/(1 + b^2 s^2) ds over [-1, 1], i < count. They satisfy
///   b^2 (m_{i-1} + 2 m_i + m_{i+1}) + 4 m_i = 4 ∫ T_{2i} ds.
/// Forward recursion is unstable; as a diagonally dominant system, closed far
/// out by the asymptotic value, it is not.
class ChebyshevMoments {
 public:
  static constexpr int max_count = 160;

  ChebyshevMoments(double b2, int count) {
    // The closure's error at index `count` is q^(4 extra_rows) of its own:
    // below 1e-15 for theta0 < 140 deg, 1e-9 at 165 deg.
    const int n = count + extra_rows;
    const auto right_side = [](int i) { return 2 / (1 - 4.0 * i * i); };
    const double order = 2.0 * n;
    const double end =
        right_side(n) / (1 + b2) * (1 - 6 * b2 / (1 + b2) / (order * order));
    std::array<double, max_rows> ratio;
    double diagonal = 2 * b2 + 4;
    double above = 2 * b2;  // row 0: m_{-1} = m_1
    moments_[0] = 4 * right_side(0) / diagonal;
    for (int i = 1; i < n; ++i) {
      ratio[i - 1] = above / diagonal;
      diagonal = 2 * b2 + 4 - b2 * ratio[i - 1];
      moments_[i] = (4 * right_side(i) - b2 * moments_[i - 1]) / diagonal;
      above = b2;
    }
    moments_[n - 1] -= b2 * end / diagonal;
    for (int i = n - 2; i >= 0; --i) {
      moments_[i] -= ratio[i] * moments_[i + 1];
    }
  }

  /// K_jk = ∫ (1 - s^2) U_{2j} U_{2k}/(1 + b^2 s^2) ds.
  double matrix_element(int j, int k) const {
    return 0.5 * (moments_[std::abs(j - k)] - moments_[j + k + 1]);
  }

  /// ∫ U_{2j}/(1 + b^2 s^2) ds, j < out.size().
  template <class Vector>
  void second_kind(Vector& out) const {
    double sum = moments_[0];
    for (int j = 0; j < out.size(); ++j) {
      out(j) = sum;
      sum += 2 * moments_[j + 1];
    }
  }

 private:
  static constexpr int extra_rows = 24;
  static constexpr int max_rows = max_count + extra_rows;
  std::array<double, max_rows> moments_;
};

/// ∫ sqrt(1 - s^2) U_{2k} g/(1 + b^2 s^2) ds, k < constant.size(), for g = 1
/// and g = cos t.
template <class Vector>
void project_first_harmonics(double half_angle, Vector& constant,
                             Vector& cosine) {
  const double q = std::tan(half_angle / 4);
  const double q2 = q * q;
  double term = std::numbers::pi / 2 * (1 - q2);
  for (int k = 0; k < constant.size(); ++k) {
    constant(k) = term;
    cosine(k) = term * (2 * k + 1) * (1 - q2) / (1 + q2);
    term *= -q2;
  }
}

/// (L_n + L_{n-1})/2, 1 <= n < end, of Legendre's functions L by the first two.
inline std::vector<double> legendre_averages(double x, double before,
                                             double now, int end) {
  std::vector<double> average = {before};
  for (int n = 1; n < end; ++n) {
    average.push_back((now + before) / 2);
    const double next = ((2 * n + 1) * x * now - n * before) / (n + 1);
    before = std::exchange(now, next);
  }
  return average;
}

/// Harmonics of the weight cos(t/2)/sqrt(sin^2(theta0/2) - sin^2(t/2)):
/// (P_n + P_{n-1})(cos theta0)/2, n < end; 1 at n = 0.
inline std::vector<double> edge_averages(double half_angle, int end) {
  return legendre_averages(std::cos(half_angle), 1, std::cos(half_angle), end);
}

/// The same with -2/pi Q_n for P_n, n > 0: what Y is to J.
inline std::vector<double> second_edge_averages(double half_angle, int end) {
  const double x = std::cos(half_angle);
  const double zeroth = -2 / std::numbers::pi * std::atanh(x);
  return legendre_averages(x, zeroth, x * zeroth + 2 / std::numbers::pi, end);
}

}  // namespace contact::detail
