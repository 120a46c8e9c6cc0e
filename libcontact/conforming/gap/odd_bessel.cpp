#include "libcontact/conforming/gap/odd_bessel.hpp"

#include <cmath>

namespace contact::detail {
namespace {

// Forward recurrence, which loses nothing where x is above the largest order.
void spherical_forward(double x, Eigen::VectorXd& out) {
  double before = std::sin(x) / x;
  double now = (before - std::cos(x)) / x;
  const Eigen::Index last = 2 * out.size() - 1;
  for (Eigen::Index m = 1; m <= last; ++m) {
    if (m % 2 == 1) out(m / 2) = now;
    const double next = (2 * static_cast<double>(m) + 1) / x * now - before;
    before = now;
    now = next;
  }
}

// Miller's algorithm below it: backwards from where j is below 1e-17, scaled
// by sum (2m + 1) j_m^2 = 1.
void spherical_backward(double x, Eigen::VectorXd& out) {
  const Eigen::Index last = 2 * out.size() - 1;
  const int start = std::max(static_cast<int>(x + 12 * std::cbrt(x)),
                             static_cast<int>(last)) +
                    16;
  double after = 0;
  double now = 1e-150;
  double sum = 0;
  for (int m = start; m > 0; --m) {
    sum += (2 * m + 1) * now * now;
    if (m % 2 == 1 && m <= last) out(m / 2) = now;
    const double before = (2 * m + 1) / x * now - after;
    after = now;
    now = before;
    if (std::abs(now) > 1e100) {  // small x: what came before is nothing
      constexpr double down = 1e-100;
      now *= down;
      after *= down;
      sum *= down * down;
      for (Eigen::Index k = m / 2; k < out.size(); ++k) out(k) *= down;
    }
  }
  sum += now * now;
  // Takes the sign of j_0 or, near its zeros, of j_1.
  const double zeroth = std::sin(x) / x;
  const bool same = std::abs(now) > std::abs(after)
                        ? now * zeroth > 0
                        : after * (zeroth - std::cos(x)) > 0;
  out *= (same ? 1 : -1) / std::sqrt(sum);
}

}  // namespace

void odd_spherical_bessel(double x, Eigen::VectorXd& out) {
  constexpr double small = 1e-8;  // leaves x^2/10 of j_1
  if (x < small) {
    out.setZero();
    if (out.size() > 0) out(0) = x / 3;
  } else if (x > 2 * static_cast<double>(out.size())) {
    spherical_forward(x, out);
  } else {
    spherical_backward(x, out);
  }
}

}  // namespace contact::detail
