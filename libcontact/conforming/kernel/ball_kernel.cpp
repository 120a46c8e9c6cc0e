#include "libcontact/conforming/kernel/ball_kernel.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/bernoulli.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/constants.hpp"

namespace contact::detail {
namespace {

// N s(N) - 1 as a fraction, N = n + 1/2, with g = 2 (1 - nu):
//   ((1-2nu)^2 N^2 + a N + 9g/8) / (g (N - 3/2)(N^2 + 2 nu N + 3/4))
// The cavity has N e(N) = (-N) s(-N).
struct Fraction {
  explicit Fraction(double nu)
      : g(2 * (1 - nu)),
        numerator{9 * g / 8, nu - 0.5 - g * (0.75 - 3 * nu),
                  (1 - 2 * nu) * (1 - 2 * nu)},
        denominator{-9.0 / 8, 0.75 - 3 * nu, 2 * nu - 1.5, 1} {}

  double operator()(double n) const {
    return ((numerator[2] * n + numerator[1]) * n + numerator[0]) /
           (g *
            (((n + denominator[2]) * n + denominator[1]) * n + denominator[0]));
  }

  // Coefficients of N^-1, N^-2, ... for large N: long division.
  template <std::size_t count>
  std::array<double, count> expansion() const {
    std::array<double, count> q{};
    for (std::size_t k = 0; k < count; ++k) {
      q[k] = k < 3 ? numerator[2 - k] / g : 0;
      for (std::size_t j = 1; j <= std::min<std::size_t>(k, 3); ++j) {
        q[k] -= denominator[3 - j] * q[k - j];
      }
    }
    return q;
  }

  double g;
  std::array<double, 3> numerator;    // powers 0 to 2 of N
  std::array<double, 4> denominator;  // powers 0 to 3 of N
};

// zeta(s, 3/2) = sum_{n >= 1} (n + 1/2)^-s, continued to s < 1, for s = 8 - i.
template <int count>
std::array<double, count> zetas() {
  // The continuation is -B_m(3/2)/m, m = 1 - s.
  std::array<double, count> zetas = {
      0.039725830475806541565, 0.060358227504199008654,
      0.092612905020295802015, 0.14476040944446771627,
      0.23484850566707287274,  0.4143983221171599978,
      0.93480220054467930942,  std::numeric_limits<double>::quiet_NaN()};
  for (int i = 8; i < count; ++i) {
    const int m = i - 7;
    zetas[i] = -std::ldexp(1.0, 1 - m);
    if (m % 2 == 0) {
      zetas[i] += (1 - std::ldexp(2.0, -m)) *
                  boost::math::unchecked_bernoulli_b2n<double>(m / 2) / m;
    }
  }
  return zetas;
}

// Real part of i^k.
double real_power_of_i(int k) { return k % 2 != 0 ? 0 : (k % 4 == 0 ? 1 : -1); }

}  // namespace

double ball_compliance(int harmonic, double nu) {
  const double n = harmonic;
  const double g = 2 * (1 - nu);
  return ((g * n + nu) * n - 1 + 2 * nu) /
         (g * (n - 1) * ((n + 1) * n + 1 + nu * (2 * n + 1)));
}

double cavity_compliance(int harmonic, double nu) {
  const double n = harmonic;
  const double g = 2 * (1 - nu);
  return ((g * n + 4 - 5 * nu) * n + 1 - nu) /
         (g * (n + 2) * ((n + 1) * n + 1 - nu * (2 * n + 1)));
}

namespace {

// N (w_1 s_n + w_2 e_n) - 1.
class Excess {
 public:
  explicit Excess(const BallConstants& constants)
      : inner_share_(constants.inner_share),
        outer_share_(constants.outer_share),
        inner_(constants.inner_poisson),
        outer_(constants.outer_poisson) {}

  double operator()(double order) const {
    return inner_share_ * inner_(order) + outer_share_ * outer_(-order);
  }

  // Coefficients of N^-1, N^-2, ...
  template <std::size_t count>
  std::array<double, count> expansion() const {
    const auto inner = inner_.expansion<count>();
    const auto outer = outer_.expansion<count>();
    std::array<double, count> q;
    double sign = -1;
    for (std::size_t k = 0; k < count; ++k) {
      q[k] = inner_share_ * inner[k] + sign * outer_share_ * outer[k];
      sign = -sign;
    }
    return q;
  }

 private:
  double inner_share_, outer_share_;
  Fraction inner_, outer_;
};

}  // namespace

BallKernel::BallKernel(const BallConstants& constants)
    : BallKernel(Excess(constants).expansion<powers>(), [&] {
        const Excess excess(constants);
        Direct d;
        // n = 1 is a rigid motion: any d_1 will do, the approach takes it up.
        for (int n = 0; n < direct_terms; ++n) {
          d[n] = n == 1 ? 0 : excess(n + 0.5);
        }
        return d;
      }()) {}

BallKernel BallKernel::of_gap(const BallConstants& constants) {
  const Excess excess(constants);
  const Powers q = excess.expansion<powers>();
  Powers inverse;  // 1/(1 + q_0/N + q_1/N^2 + ...), without the 1
  for (int k = 0; k < powers; ++k) {
    inverse[k] = -q[k];
    for (int j = 0; j < k; ++j) inverse[k] -= q[j] * inverse[k - 1 - j];
  }
  Direct e{};
  for (int n = 2; n < direct_terms; ++n) {
    const double d = excess(n + 0.5);
    e[n] = -d / (1 + d);
  }
  return {inverse, e};
}

BallKernel::BallKernel(const Powers& q, const Direct& direct) {
  // The closed sums begin with n = 1: of N = 1/2 the last powers are thousands,
  // which would only leave their roundings.
  direct_[0] = direct[0];
  for (int n = 1; n < direct_terms; ++n) {
    const double order = n + 0.5;
    double closed = 0;
    for (int k = powers - 1; k >= 0; --k) closed = (closed + q[k]) / order;
    direct_[n] = direct[n] - closed;
  }

  // sum_{n >= 1} cos(N x)/N^(m+1) is the real part of (Erdelyi, Higher
  // Transcendental Functions, 1.11 (8))
  //   (ix)^m/m! (H_m + 2 ln 2 - 2 - ln(-ix)) + sum_{k != m} zeta(m+1-k, 3/2)
  //   (ix)^k/k!,  -ln(-ix) = -ln x + i pi/2.
  static_assert(powers == 8);
  static const auto zeta = zetas<powers + 2 * series_terms>();
  double harmonic = 0;
  double factorial_m = 1;
  for (int m = 0; m < powers; ++m) {
    if (m > 0) {
      harmonic += 1.0 / m;
      factorial_m *= m;
    }
    const double leading = q[m] / factorial_m;
    if (m % 2 == 0) {
      const double c = leading * real_power_of_i(m);
      even_[m / 2] += c * (harmonic + 2 * std::numbers::ln2 - 2);
      logarithmic_[m / 2] = -c;
    } else {
      odd_[m / 2] = leading * real_power_of_i(m + 1) * pi / 2;
    }
    double factorial_k = 1;
    for (int j = 0; j < series_terms; ++j) {
      const int k = 2 * j;
      if (k > 0) factorial_k *= k * (k - 1.0);
      if (k == m) continue;
      even_[j] +=
          q[m] * zeta[powers - m - 1 + k] * real_power_of_i(k) / factorial_k;
    }
  }
}

void BallKernel::evaluate(std::span<const double> x,
                          std::span<double> kappa) const {
  // Lanes over nodes: as many as there are registers for.
  constexpr int lanes = 8;
  using Lanes = Eigen::Array<double, lanes, 1>;
  const auto horner = [](const auto& coefficients, const Lanes& y2) {
    Lanes sum = Lanes::Constant(coefficients.back());
    for (int k = static_cast<int>(coefficients.size()) - 2; k >= 0; --k) {
      sum = sum * y2 + coefficients[k];
    }
    return sum;
  };
  for (std::size_t first = 0; first < x.size(); first += lanes) {
    const std::size_t used = std::min<std::size_t>(lanes, x.size() - first);
    Lanes given = Lanes::Constant(x[first]);
    std::copy_n(x.begin() + first, used, given.begin());
    // kappa(2 pi - x) = -kappa(x).
    const Lanes y = given.min(2 * pi - given);
    const Lanes y2 = y * y;
    const Lanes half = (y / 2).cos();
    const Lanes c = 4 * half * half - 2;
    Lanes b0 = Lanes::Zero();
    Lanes b1 = Lanes::Zero();
    for (int n = direct_terms - 1; n >= 0; --n) {
      const Lanes next = c * b0 - b1 + direct_[n];
      b1 = b0;
      b0 = next;
    }
    const Lanes sum = horner(even_, y2) + horner(logarithmic_, y2) * y.log() +
                      horner(odd_, y2) * y + (b0 - b1) * half;
    const Lanes result = (given > pi).select(-sum, sum);
    std::copy_n(result.begin(), used, kappa.begin() + first);
  }
}

}  // namespace contact::detail
