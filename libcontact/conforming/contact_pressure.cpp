#include "libcontact/conforming/contact_pressure.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "libcontact/conforming/wide_edge.hpp"

namespace contact {
namespace {

// ln x by x^2; what it is multiplied with is 0 at x = 0.
double logarithm(double square) {
  return square > 0 ? std::log(square) / 2 : 0;
}
template <class Block>
Block logarithm(const Block& square) {
  return square.max(1e-300).log() / 2;
}

}  // namespace

ContactPressure::ContactPressure(double half_angle, double force_ratio,
                                 std::span<const double> coefficients,
                                 std::span<const double> logarithmic)
    : half_angle_(half_angle),
      force_ratio_(force_ratio),
      terms_(static_cast<int>(
          std::min<std::size_t>(coefficients.size(), max_terms))) {
  std::copy_n(coefficients.begin(), terms_, coefficients_.begin());
  std::copy_n(logarithmic.begin(),
              std::min<std::size_t>(logarithmic.size(), logarithms),
              logarithmic_.begin());
}

// Clenshaw's recurrence, y = cos(2 phi) = 1 - 2 x^2:
// sin((2k+1) phi)/sin(phi) = f_k, f_{k+1} = 2 y f_k - f_{k-1}, f_{-1} = -1,
// f_0 = 1.
template <class V>
V ContactPressure::pressure_at(const V& square) const noexcept {
  using std::sqrt;
  const V twice = 2 - 4 * square;
  V b0 = 0 * square;
  V b1 = b0;
  for (int k = terms_ - 1; k >= 0; --k) {
    const V b = twice * b0 - b1 + coefficients_[k];
    b1 = b0;
    b0 = b;
  }
  V log_sum = 0 * square;
  for (int k = logarithms - 1; k >= 0; --k) {
    log_sum = (log_sum + logarithmic_[k]) * square;
  }
  return sqrt(square) * (b0 + b1 + log_sum * logarithm(square));
}

// cos((2k+1) phi)/cos(phi) = f_k with f_{-1} = 1, f_0 = 1.
template <class V>
V ContactPressure::slope_at(const V& square) const noexcept {
  const V twice = 2 - 4 * square;
  V b0 = 0 * square;
  V b1 = b0;
  for (int k = terms_ - 1; k >= 0; --k) {
    const V b = twice * b0 - b1 + (2 * k + 1) * coefficients_[k];
    b1 = b0;
    b0 = b;
  }
  // d(x^n ln x)/dx = x^(n-1) (n ln x + 1), n = 2k + 3.
  V with_log = 0 * square;
  V without = with_log;
  for (int k = logarithms - 1; k >= 0; --k) {
    with_log = (with_log + (2 * k + 3) * logarithmic_[k]) * square;
    without = (without + logarithmic_[k]) * square;
  }
  return b0 - b1 + with_log * logarithm(square) + without;
}

void ContactPressure::edge_slopes(std::span<const double> edge_square,
                                  std::span<double> out) const noexcept {
  using Block = Eigen::Array<double, 8, 1>;
  constexpr std::size_t size = Block::SizeAtCompileTime;
  for (std::size_t first = 0; first < edge_square.size(); first += size) {
    const std::size_t used = std::min(size, edge_square.size() - first);
    Block square = Block::Constant(edge_square[first]);
    std::copy_n(edge_square.begin() + first, used, square.begin());
    const Block slope = slope_at(square);
    std::copy_n(slope.begin(), used, out.begin() + first);
  }
}

double ContactPressure::pressure(double theta) const noexcept {
  theta = std::abs(theta);
  if (theta >= half_angle_) return 0;
  return pressure_at(detail::WideEdge(half_angle_).square(theta));
}

double ContactPressure::slope(double theta) const noexcept {
  const double t = std::abs(theta);
  if (t > half_angle_) return 0;
  const detail::WideEdge edge(half_angle_);
  const double square = edge.square(t);
  // d(x^2) = 2 x dx
  // A free ring's pressure rises towards the edge: the sign is the series'.
  return std::copysign(1.0, theta) * slope_at(square) * edge.square_slope(t) /
         (2 * std::sqrt(square));
}

double ContactPressure::peak() const noexcept { return pressure(peak_angle()); }

// Places from the centre to the edge, ever closer towards it, where a free ring
// presses on a narrow strip: fine enough to see each maximum, if not
// how high it is.
double ContactPressure::scan_angle(int i) const noexcept {
  static const auto shares = [] {
    using std::numbers::pi;
    std::array<double, scan_steps + 1> share{};
    for (int k = 0; k <= scan_steps; ++k) {
      share[k] = std::sin(pi / 2 * std::sin(pi / 2 * k / scan_steps));
    }
    return share;
  }();
  return half_angle_ * shares[i];
}

bool ContactPressure::falls_outwards() const noexcept {
  double last = pressure_at(1.0);
  for (int i = 1; i < scan_steps; ++i) {
    // x^2, close together at both ends; angles would cost more than the series.
    const double s = 1 - double(i) / scan_steps;
    const double q = s * s;
    const double p = pressure_at(q * q * (3 - 2 * q));
    if (p > last) return false;
    last = p;
  }
  return true;
}

double ContactPressure::peak_angle() const noexcept {
  std::array<double, scan_steps + 1> p{};
  for (int i = 0; i < scan_steps; ++i) p[i] = pressure(scan_angle(i));
  double place = 0;
  double largest = p[0];
  for (int i = 1; i < scan_steps; ++i) {
    if (!(p[i] > p[i - 1] && p[i] >= p[i + 1])) continue;
    // Half the digits of a double: a maximum has no more.
    const auto [theta, least] = boost::math::tools::brent_find_minima(
        [this](double at) { return -pressure(at); }, scan_angle(i - 1),
        scan_angle(i + 1), 26);
    if (-least <= largest) continue;
    place = theta;
    largest = -least;
  }
  return place;
}

}  // namespace contact
