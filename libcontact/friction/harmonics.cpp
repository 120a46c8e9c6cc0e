#include "libcontact/friction/harmonics.hpp"

#include <array>

#include "libcontact/base/constants.hpp"

namespace contact::detail {
namespace {

constexpr int size = max_pressure_harmonics;

// Integrals over z in [-1, 1]: W_n of sqrt(1 - z^2) P_n, 0 for odd n, and
// B_n/(2n(n+1)) of sqrt(1 - z^2) P_n', 0 for even n.
struct Moments {
  Moments() {
    std::array<double, size + 2> c{};  // coefficients of P_n/sqrt(1 - z^2)
    c[0] = pi;
    mean[0] = pi / 2;
    for (int n = 0; n < size; n += 2) {
      const double ratio = (n + 1.0) / (n + 2.0);
      c[n + 2] = c[n] * ratio * ratio;
      if (n + 2 < size) {
        mean[n + 2] = mean[n] * (n - 1.0) * (n + 1.0) / ((n + 4.0) * (n + 2.0));
      }
    }
    for (int n = 1; n < size; n += 2) {
      const double b = ((n + 1.0) * c[n + 1] + n * c[n - 1]) / (2.0 * n + 1);
      force[n] = b / (2.0 * n * (n + 1.0));
    }
  }
  std::array<double, size> mean{};
  std::array<double, size> force{};
};

}  // namespace

FrictionTriple coefficients_by_harmonics(std::span<const double> harmonics,
                                         SlipAxis axis) {
  static const Moments moments;
  const double z = axis.sin;
  double before = 1;        // P_{n-1}
  double legendre = z;      // P_n
  double slope_before = 0;  // P_{n-1}'
  double slope = 1;         // P_n'
  double along = harmonics[0] * moments.mean[0];
  double turn = 0;
  double force = harmonics[1] * moments.force[1];
  for (std::size_t n = 2; n < harmonics.size(); ++n) {
    const double order = static_cast<double>(n);
    const double next =
        ((2 * order - 1) * z * legendre - (order - 1) * before) / order;
    const double next_slope = slope_before + (2 * order - 1) * legendre;
    before = legendre;
    legendre = next;
    slope_before = slope;
    slope = next_slope;
    if (n % 2 == 0) {
      along += harmonics[n] * moments.mean[n] * legendre;
      turn += harmonics[n] * moments.mean[n] * slope;
    } else {
      force += harmonics[n] * moments.force[n] * slope;
    }
  }
  // Over R_n = (4 pi/3) rho^2 p_1: the moment about w, and its change over a.
  along *= 1.5;
  turn *= 1.5 * axis.cos;
  return {3 * force * axis.cos, along * axis.cos - turn * axis.sin,
          along * axis.sin + turn * axis.cos};
}

FrictionTriple viscous_by_harmonics(std::span<const double> harmonics,
                                    SlipAxis axis) {
  // S = 3 p_0/p_1; the second moment of p about n over R_n.
  const double second = harmonics.size() > 2 ? harmonics[2] : 0;
  const double moment = 2 * (harmonics[0] - second / 5);
  return {axis.cos, (3 * harmonics[0] - moment / 2) * axis.cos,
          moment * axis.sin};
}

}  // namespace contact::detail
