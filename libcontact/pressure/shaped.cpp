#include "libcontact/pressure/shaped.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"

namespace contact {
namespace {

using detail::nan;
using detail::pi;
constexpr double widest = 175 * degree * (1 + 1e-15);

/// Points of a contact: enough for tops as flat as 1 - (t/theta0)^8. More lie
/// so near to the edge that rounding of theta is felt.
constexpr int point_count = 64;
using Values = std::array<double, point_count>;

/// Place by a variable in which shapes are smooth up to both ends: sin(phi),
/// phi = (pi/2) v^2, so that the distance from the edge grows like v^4.
struct Place {
  double theta;
  double rate;  ///< -d theta/dv

  Place(double v, double half_angle) {
    const double b = std::tan(half_angle / 2);
    const double phi = pi / 2 * v * v;
    const double tangent = b * std::cos(phi);
    theta = std::min(2 * std::atan(tangent), half_angle);
    rate = 2 * b * std::sin(phi) / (1 + tangent * tangent) * pi * v;
  }
};

const detail::GaussLegendre& gauss() {
  static const detail::GaussLegendre& rule =
      *new detail::GaussLegendre(point_count);
  return rule;
}

/// Interpolation at v = (1 + cos(pi i/last))/2: with the edge, the last one,
/// where theta is known only to rounding and all shapes are 0.
struct Chebyshev {
  static constexpr int last = point_count - 1;
  Values v;
  std::array<Values, point_count> factor;  // [i][j]

  Chebyshev() {
    for (int i = 0; i < point_count; ++i) {
      const double phase = pi * i / last;
      v[i] = (1 + std::cos(phase)) / 2;
      for (int j = 0; j < point_count; ++j) {
        factor[i][j] = end(i) * end(j) * 2 / last * std::cos(j * phase);
      }
    }
  }

  static double end(int i) { return i == 0 || i == last ? 0.5 : 1; }

  /// The series of df/dv.
  Values slope(const Values& f) const {
    Values c{}, d{};
    for (int i = 0; i < point_count; ++i) {
      for (int j = 0; j < point_count; ++j) c[j] += factor[i][j] * f[i];
    }
    for (int j = last; j > 0; --j) {
      d[j - 1] = 4 * j * c[j] + (j < last ? d[j + 1] : 0);
    }
    d[0] /= 2;
    return d;
  }

  static double value(const Values& series, double v) {
    const double y = 2 * v - 1;
    double next = 0, now = 0;
    for (int j = last; j > 0; --j) {
      next = std::exchange(now, 2 * y * now - next + series[j]);
    }
    return y * now - next + series[0];
  }
};

const Chebyshev& chebyshev() {
  static const Chebyshev rule;
  return rule;
}

}  // namespace

ShapedPressure::ShapedPressure(JointKind kind, std::string name,
                               double largest_half_angle)
    : PressureLaw(kind), name_(std::move(name)), largest_(largest_half_angle) {
  detail::require(largest_ > 0 && largest_ <= widest, "pressure law " + name_,
                  "largest_half_angle", largest_, "in (0, 175 deg]");
  gauss();  // Here, so that nothing allocates later.
  chebyshev();
}

// ∫ p cos t dS and ∫ p dS.
ShapedPressure::Resultants ShapedPressure::resultants(
    double half_angle) const noexcept {
  Resultants r{0, 0};
  for (int i = 0; i < point_count; ++i) {
    const Place place((1 + gauss().node(i)) / 2, half_angle);
    const double width =
        joint_kind() == JointKind::ball ? pi * std::sin(place.theta) : 1;
    const double p =
        gauss().weight(i) * place.rate * width * shape(place.theta, half_angle);
    r.force += p * std::cos(place.theta);
    r.sum += p;
  }
  return r;
}

double ShapedPressure::peak(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  if (half_angle == 0) return std::numeric_limits<double>::infinity();
  return shape(0, half_angle) / resultants(half_angle).force;
}

double ShapedPressure::force_ratio(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  if (half_angle == 0) return 1;
  const auto [force, sum] = resultants(half_angle);
  return sum / force;
}

double ShapedPressure::pressure(double theta,
                                double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  const double t = std::abs(theta);
  if (t > half_angle) return 0;
  if (half_angle == 0) return peak(half_angle);
  if (t == half_angle) return 0;  // rounding may give another value
  return shape(t, half_angle) / resultants(half_angle).force;
}

void ShapedPressure::edge_slopes(double half_angle,
                                 std::span<const double> edge_variable,
                                 std::span<double> out) const noexcept {
  if (!(half_angle > 0 && half_angle <= largest_)) {
    std::ranges::fill(out, nan);
    return;
  }
  Values f{};
  for (int i = 0; i < Chebyshev::last; ++i) {
    f[i] = shape(Place(chebyshev().v[i], half_angle).theta, half_angle);
  }
  const Values series = chebyshev().slope(f);
  const double force = resultants(half_angle).force;
  // Closer to the ends the quotient is of rounding errors.
  constexpr double edge = 1e-8;
  constexpr double centre = 1e-4;
  for (std::size_t i = 0; i < edge_variable.size(); ++i) {
    const double x = std::max(edge_variable[i], edge);
    const double dx = std::max(std::sqrt((1 - x) * (1 + x)), centre);
    const double v = std::sqrt(std::atan2(x, dx) / (pi / 2));
    out[i] = Chebyshev::value(series, v) / (pi * v * dx) / force;
  }
}

double ShapedPressure::slope(double theta, double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  if (theta == 0 || std::abs(theta) > half_angle) return 0;
  const double b = std::tan(half_angle / 2);
  const double tangent = std::tan(theta / 2);
  const double s = tangent / b;
  const double x = std::sqrt(std::max((1 - s) * (1 + s), 0.0));
  double slope = 0;
  edge_slopes(half_angle, {&x, 1}, {&slope, 1});
  return slope * (s / x) * (1 + tangent * tangent) / (2 * b);
}

}  // namespace contact
