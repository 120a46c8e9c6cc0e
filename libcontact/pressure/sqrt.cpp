#include "libcontact/pressure/sqrt.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/conforming/wide_edge.hpp"
#include "libcontact/pressure/edge_polynomial.hpp"
#include "libcontact/pressure/expansion.hpp"
#include "libcontact/pressure/registry.hpp"

namespace contact {
namespace {

using detail::nan;
using detail::pi;
constexpr double largest = 3.0543261909900767;  // 175 deg

// Moments of SqrtTanPressure on a ball, with M_n = ∫ x^2/(1 - h^2 x^2)^n dx
// over [0, 1], h = sin(theta0/2): its load, 2 cos^2(theta0/2) M_3 - M_2, and
// its sum, M_2.
struct Moments {
  double load;
  double sum;
};

// Even and odd powers side by side: half the latency of Horner's rule.
template <std::size_t size>
double power_series(const std::array<double, size>& f, double x) {
  static_assert(size % 2 == 0);
  const double x2 = x * x;
  double even = 0;
  double odd = 0;
  for (std::size_t k = size; k > 0; k -= 2) {
    odd = odd * x2 + f[k - 1];
    even = even * x2 + f[k - 2];
  }
  return even + x * odd;
}

Moments moments(double half_angle) {
  const double h = std::sin(half_angle / 2);
  const double h2 = h * h;
  if (h2 < 0.25) {
    // Power series: 4^-28 is below rounding.
    using Series = std::array<double, 28>;
    static constexpr Series sum = [] {
      Series f{};
      for (std::size_t k = 0; k < f.size(); ++k) {
        const auto j = static_cast<double>(k);
        f[k] = (j + 1) / (2 * j + 3);
      }
      return f;
    }();
    static constexpr Series load = [] {
      Series f = sum;
      for (std::size_t k = 0; k < f.size(); ++k) {
        f[k] /= 2 * static_cast<double>(k) + 1;
      }
      return f;
    }();
    return {power_series(load, h2), power_series(sum, h2)};
  }
  const double c = std::cos(half_angle / 2);
  const double logarithm = std::atanh(h) / h;
  return {((1 + h2) * logarithm - 1) / (4 * h2),
          (1 / (c * c) - logarithm) / (2 * h2)};
}

// H_1(z)/z^2 of Struve's function, z in [0, 2 pi): (2/pi)/3 at 0.
double struve_over_square(double z) {
  // Terms grow to 30 times the sum at z = 6; 24 of them leave 1e-17.
  constexpr int terms = 24;
  static constexpr auto inverse = [] {
    std::array<double, terms + 1> f{};
    for (int k = 1; k <= terms; ++k) f[k] = 1 / ((2 * k + 1.0) * (2 * k + 3.0));
    return f;
  }();
  const double z2 = z * z;
  double sum = 0;
  for (int k = terms; k >= 1; --k) sum = (1 - sum) * (z2 * inverse[k]);
  return 2 / (3 * pi) * (1 - sum);
}

// J_1(z)/z of Bessel's function, z in [0, pi]: 1/2 at 0.
double bessel_over_argument(double z) {
  constexpr int terms = 16;
  const double quarter = z * z / 4;
  double sum = 0;
  for (int k = terms; k >= 1; --k) {
    sum = (1 - sum) * quarter / (k * (k + 1.0));
  }
  return (1 - sum) / 2;
}

// sqrt(1 - (t/theta0)^2) = sum a_k sin((2k+1) phi) in detail::WideEdge, as an
// edge polynomial; for theta0 <= 120 deg its coefficients as Chebyshev series
// in theta0^2. Both converge like 6^-k or faster.
class CircleExpansion {
 public:
  static constexpr int terms = 16;
  static_assert(terms <= PressureExpansion::max_terms);
  using Coefficients = std::array<double, terms>;

  CircleExpansion() {
    for (int i = 0; i < degrees; ++i) {
      const double phase = pi * (i + 0.5) / degrees;
      const double half_angle =
          tabulated * std::sqrt((1 + std::cos(phase)) / 2);
      const Coefficients c = solve(half_angle);
      for (int j = 0; j < degrees; ++j) {
        const double factor =
            (j == 0 ? 1.0 : 2.0) / degrees * std::cos(j * phase);
        for (int k = 0; k < terms; ++k) series_[j][k] += factor * c[k];
      }
    }
  }

  // Times a factor, without the last terms if they do not count.
  PressureExpansion operator()(double half_angle, double factor) const {
    PressureExpansion result{
        .edge_constant = detail::WideEdge(half_angle).constant(),
        .size = terms};
    std::ranges::copy(
        half_angle > tabulated ? solve(half_angle) : evaluate(half_angle),
        result.coefficient.begin());
    const double negligible = 1e-13 * std::abs(result.coefficient[0]);
    while (result.size > 1 &&
           std::abs(result.coefficient[result.size - 1]) < negligible) {
      --result.size;
    }
    for (int k = 0; k < terms; ++k) result.coefficient[k] *= factor;
    return result;
  }

 private:
  static constexpr int degrees = 15;
  static constexpr double tabulated = 2 * pi / 3;

  static Coefficients solve(double half_angle) {
    // More points than terms keep aliasing away.
    constexpr int points = 2 * terms;
    const detail::WideEdge edge(half_angle);
    const double b = std::tan(half_angle / 2);
    Coefficients a{};
    for (int n = 0; n < points; ++n) {
      const double phi = pi / 2 * (n + 0.5) / points;
      const double x = std::sin(phi);
      const double share = edge.cosine() * edge.tangent_share(x * x);
      const double t = 2 * std::atan(b * std::cos(phi) * std::sqrt(share));
      const double y = std::sqrt((1 - t / half_angle) * (1 + t / half_angle));
      for (int k = 0; k < terms; ++k) {
        a[k] += 2 * y / points * std::sin((2 * k + 1) * phi);
      }
    }
    return detail::edge_polynomial(detail::edge_chebyshev(a));
  }

  Coefficients evaluate(double half_angle) const {
    const double share = half_angle / tabulated;
    const double v = 2 * share * share - 1;
    double last = v;  // T_{-1}
    double now = 1;
    Coefficients c{};
    for (const auto& row : series_) {
      for (int k = 0; k < terms; ++k) c[k] += now * row[k];
      const double next = 2 * v * now - last;
      last = now;
      now = next;
    }
    return c;
  }

  std::array<Coefficients, degrees> series_{};
};

// Edge variable of an angle in [0, theta0].
double edge_variable_of(double theta, double half_angle) {
  return std::sqrt(std::sin((half_angle - theta) / 2) /
                   std::sin(half_angle / 2)) *
         std::sqrt(std::sin((half_angle + theta) / 2) /
                   std::sin(half_angle / 2)) /
         std::cos(theta / 2);
}

// sqrt(1 - (theta/theta0)^2)
double circle(double theta, double half_angle) {
  return std::sqrt((half_angle - theta) / half_angle *
                   ((half_angle + theta) / half_angle));
}

}  // namespace

double SqrtTanPressure::largest_half_angle() const noexcept { return largest; }

double SqrtTanPressure::peak(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  const double c = std::cos(half_angle / 2);
  if (joint_kind() == JointKind::pin) {
    return 1 / (2 * pi * std::tan(half_angle / 4) * c);
  }
  const double h = std::sin(half_angle / 2);
  return 1 / (8 * pi * c * c * moments(half_angle).load) / h / h;
}

double SqrtTanPressure::force_ratio(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  const double c = std::cos(half_angle / 2);
  if (joint_kind() == JointKind::pin) return 1 / c;
  const auto [load, sum] = moments(half_angle);
  return sum / load;
}

double SqrtTanPressure::pressure(double theta,
                                 double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  const double t = std::abs(theta);
  if (t > half_angle) return 0;
  if (t == 0) return peak(half_angle);
  return peak(half_angle) * edge_variable_of(t, half_angle);
}

double SqrtTanPressure::slope(double theta, double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  const double t = std::abs(theta);
  if (theta == 0 || t > half_angle) return 0;
  const double b = std::tan(half_angle / 2);
  const double cosine = std::cos(t / 2);
  return peak(half_angle) * (std::tan(theta / 2) / b) /
         (2 * b * cosine * cosine * edge_variable_of(t, half_angle));
}

void SqrtTanPressure::edge_slopes(double half_angle, std::span<const double>,
                                  std::span<double> out) const noexcept {
  const double value = peak(half_angle);
  for (double& slope : out) slope = value;
}

PressureExpansion SqrtTanPressure::expansion(double half_angle) const noexcept {
  PressureExpansion result{.size = 1};
  result.coefficient[0] = peak(half_angle);
  return result;
}

double SqrtThetaPressure::largest_half_angle() const noexcept {
  return largest;
}

double SqrtThetaPressure::peak(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  const double t = half_angle;
  if (joint_kind() == JointKind::pin) {
    return 1 / (pi * bessel_over_argument(t)) / t;
  }
  return 1 / (pi * pi * struve_over_square(2 * t)) / t / t;
}

double SqrtThetaPressure::force_ratio(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  if (joint_kind() == JointKind::pin) {
    return 1 / (2 * bessel_over_argument(half_angle));
  }
  return struve_over_square(half_angle) / struve_over_square(2 * half_angle);
}

PressureExpansion SqrtThetaPressure::expansion(
    double half_angle) const noexcept {
  static const CircleExpansion circle_expansion;
  return circle_expansion(half_angle, peak(half_angle));
}

double SqrtThetaPressure::pressure(double theta,
                                   double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  const double t = std::abs(theta);
  if (t > half_angle) return 0;
  if (t == 0) return peak(half_angle);
  return peak(half_angle) * circle(t, half_angle);
}

double SqrtThetaPressure::slope(double theta,
                                double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  const double t = std::abs(theta);
  if (theta == 0 || t > half_angle) return 0;
  return peak(half_angle) * (theta / half_angle) /
         (half_angle * circle(t, half_angle));
}

void SqrtThetaPressure::edge_slopes(double half_angle,
                                    std::span<const double> edge_variable,
                                    std::span<double> out) const noexcept {
  // p = peak y, y = sqrt(1 - (t/theta0)^2), t = 2 atan(b s), s^2 + x^2 = 1:
  // dp/dx = peak t/(theta0 s) 2b cos^2(t/2)/theta0 x/y.
  const double b = std::tan(half_angle / 2);
  const double scale = peak(half_angle) * 2 * b / half_angle;
  for (std::size_t i = 0; i < edge_variable.size(); ++i) {
    const double x = edge_variable[i];
    const double s = std::sqrt((1 - x) * (1 + x));
    const double bs = b * s;
    const double t_over_s = s > 0 ? 2 * std::atan(bs) / s : 2 * b;
    const double t = t_over_s * s;
    // (theta0 - t)/x^2, from the tangent of half of it.
    const double tangent = b / ((1 + s) * (1 + b * bs));
    const double rest =
        x > 0 ? 2 * std::atan(tangent * x * x) / (x * x) : 2 * tangent;
    const double y_over_x =
        std::sqrt(rest / half_angle * ((half_angle + t) / half_angle));
    out[i] = scale * (t_over_s / half_angle) / (1 + bs * bs) / y_over_x;
  }
}

namespace detail {

extern constexpr PressureEntry sqrt_tan_pressure = {
    .about = {.name = "sqrt_tan",
              .meaning = "Hertz' edge; small contacts",
              .accuracy = "S 5 %, peak 16 %",
              .allows_back = true},
    .shape = "x = sqrt(1 - tan^2(t/2)/tan^2(theta0/2))",
    .make = [](const PressureRequest& asked) -> std::unique_ptr<PressureLaw> {
      return std::make_unique<SqrtTanPressure>(asked.kind);
    }};

extern constexpr PressureEntry sqrt_theta_pressure = {
    .about = {.name = "sqrt_theta",
              .meaning = "the same, a little closer",
              .accuracy = "S 4 %, peak 11 %",
              .allows_back = true},
    .shape = "sqrt(1 - (t/theta0)^2)",
    .make = [](const PressureRequest& asked) -> std::unique_ptr<PressureLaw> {
      return std::make_unique<SqrtThetaPressure>(asked.kind);
    }};

}  // namespace detail
}  // namespace contact
