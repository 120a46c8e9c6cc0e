#include "libcontact/pressure_exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/detail/edge_polynomial.hpp"
#include "libcontact/detail/gauss_legendre.hpp"

namespace contact {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double usual_largest = 2 * pi / 3;
// Series in theta0 that reached farther would be poor ones at small theta0.
constexpr double most_largest = 5 * pi / 6;

// What p = sum a_k sin((2k+1) phi) carries, and the sum of its pressures.
struct Resultants {
  double load;
  double sum;
};

// By Gauss' rule in x = sin phi, where p and the rest of the integrand are
// analytic: 40 nodes leave 1e-16 at 120 deg, 1e-13 at 165 deg.
Resultants resultants(JointKind kind, double half_angle,
                      std::span<const double> coefficients) {
  static const detail::GaussLegendre rule(40);
  const double h = std::sin(half_angle / 2);
  const double c = std::cos(half_angle / 2);
  Resultants r{0, 0};
  for (int i = 0; i < rule.node.size(); ++i) {
    const double phi = pi / 4 * (1 + rule.node(i));
    const double x = std::sin(phi);
    double p = 0;
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      p += coefficients[k] * std::sin((2 * static_cast<double>(k) + 1) * phi);
    }
    // tan(t/2) = b cos phi: 1/cos^2(t/2) = (1 - h^2 x^2)/c^2.
    const double rest = (1 - h * x) * (1 + h * x);
    const double cosine = 2 * c * c / rest - 1;
    // |dt| = 2 b x dphi cos^2(t/2); a pin has two sides.
    double area = pi / 4 * rule.weight(i) * 2 * h * c * x / rest;
    if (kind == JointKind::spherical) {
      // sin t = 2 h c cos(phi)/rest
      area *= 2 * pi * 2 * h * c * std::cos(phi) / rest;
    } else {
      area *= 2;
    }
    r.load += p * cosine * area;
    r.sum += p * area;
  }
  return r;
}

}  // namespace

ExactPressure::ExactPressure(JointKind kind, const ElasticPair& pair,
                             InnerLoading loading)
    : PressureLaw(kind) {
  if (kind == JointKind::spherical) {
    tabulate(BallContact(pair, loading));
    return;
  }
  const PinContact contact(pair, loading);
  if (contact.limit_half_angle().status == Status::ok) {
    tabulate(contact);
  } else {
    tabulate(PinContact(pair, loading, PinContact::max_unknowns));
  }
}

template <class Contact>
void ExactPressure::tabulate(const Contact& contact) {
  const JointKind kind = joint_kind();
  const bool ball = kind == JointKind::spherical;
  const ExactHalfAngle limit = contact.limit_half_angle();
  const double wanted =
      limit.status == Status::ok ? limit.half_angle : contact.largest();
  largest_ = std::min(
      {std::max(wanted, usual_largest), contact.largest(), most_largest});
  const int count = largest_ > usual_largest ? 48 : 28;
  series_.assign(count, Column{});
  for (int i = 0; i < count; ++i) {
    const double phase = pi * (i + 0.5) / count;
    const double share = (1 + std::cos(phase)) / 2;
    const double half_angle = largest_ * (ball ? share * share : share);
    const ContactPressure solved = contact.pressure(half_angle);
    Column value{};
    std::copy_n(solved.coefficients().begin(), terms, value.begin());
    const auto coefficients = std::span(value).first(terms);
    // The solver's own load is off by its truncation.
    const auto [load, sum] = resultants(kind, half_angle, coefficients);
    const double length = 2 * std::sin(half_angle / 2);
    for (double& a : coefficients)
      a *= (ball ? length * length : length) / load;
    value[terms] = sum / load;
    for (int j = 0; j < count; ++j) {
      const double factor = (j == 0 ? 1.0 : 2.0) / count * std::cos(j * phase);
      for (int k = 0; k <= terms; ++k) series_[j][k] += factor * value[k];
    }
    // Far below the accuracy of the law; equal materials need few terms.
    const double negligible = 1e-13 * std::abs(value[0]);
    for (int k = size_; k < terms; ++k) {
      if (std::abs(value[k]) > negligible) size_ = k + 1;
    }
  }
  for (const Column& column : series_) {
    std::array<double, terms> a;
    std::copy_n(column.begin(), terms, a.begin());
    std::fill(a.begin() + size_, a.end(), 0);
    polynomials_.push_back(detail::edge_polynomial(a));
  }
}

template <std::size_t size>
void ExactPressure::chebyshev_sum(
    const std::vector<std::array<double, size>>& series, double half_angle,
    std::array<double, size>& sum) const noexcept {
  const double share = half_angle / largest_;
  const bool ball = joint_kind() == JointKind::spherical;
  const double v = 2 * (ball ? std::sqrt(share) : share) - 1;
  // T_{j+1} = 2 v T_j - T_{j-1}
  double last = v;  // T_{-1}
  double now = 1;
  for (const auto& row : series) {
    for (std::size_t k = 0; k < size; ++k) sum[k] += now * row[k];
    const double next = 2 * v * now - last;
    last = now;
    now = next;
  }
}

ExactPressure::Column ExactPressure::evaluate(
    double half_angle) const noexcept {
  Column sum{};
  if (has(half_angle)) {
    chebyshev_sum(series_, half_angle, sum);
  } else {
    sum.fill(nan);
  }
  return sum;
}

double ExactPressure::in_pressure_units(double value,
                                        double half_angle) const noexcept {
  const double length = 2 * std::sin(half_angle / 2);
  return joint_kind() == JointKind::spherical ? value / length / length
                                              : value / length;
}

ContactPressure ExactPressure::contact(double half_angle) const noexcept {
  Column values = evaluate(half_angle);
  for (int k = 0; k < terms; ++k) {
    values[k] = in_pressure_units(values[k], half_angle);
  }
  return {half_angle, values[terms], std::span(values).first(terms)};
}

double ExactPressure::pressure(double theta, double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  if (theta == 0) return peak(half_angle);
  if (std::abs(theta) > half_angle) return 0;
  return contact(half_angle).pressure(theta);
}

double ExactPressure::slope(double theta, double half_angle) const noexcept {
  if (std::isnan(theta) || !has(half_angle)) return nan;
  if (theta == 0 || std::abs(theta) > half_angle) return 0;
  return contact(half_angle).slope(theta);
}

void ExactPressure::edge_slopes(double half_angle,
                                std::span<const double> edge_variable,
                                std::span<double> out) const noexcept {
  Column values = evaluate(half_angle);
  const double unit = in_pressure_units(1, half_angle);
  for (int k = 0; k < terms; ++k) values[k] *= (2 * k + 1) * unit;
  // cos((2k+1) phi)/cos(phi) = f_k, f_{k+1} = 2 cos(2 phi) f_k - f_{k-1},
  // f_0 = f_{-1} = 1.
  // Clenshaw's recurrence on blocks, which compilers vectorise.
  constexpr std::size_t block = 8;
  for (std::size_t first = 0; first < edge_variable.size(); first += block) {
    const std::size_t size = std::min(block, edge_variable.size() - first);
    std::array<double, block> twice{};
    for (std::size_t i = 0; i < size; ++i) {
      const double x = edge_variable[first + i];
      twice[i] = 2 * (1 - 2 * x * x);
    }
    std::array<double, block> b0{};
    std::array<double, block> b1{};
    for (int k = terms - 1; k >= 0; --k) {
      for (std::size_t i = 0; i < block; ++i) {
        const double b = twice[i] * b0[i] - b1[i] + values[k];
        b1[i] = b0[i];
        b0[i] = b;
      }
    }
    for (std::size_t i = 0; i < size; ++i) out[first + i] = b0[i] - b1[i];
  }
}

PressureExpansion ExactPressure::expansion(double half_angle) const noexcept {
  PressureExpansion result{.size = size_};
  if (!has(half_angle)) {
    result.coefficient.fill(nan);
    return result;
  }
  chebyshev_sum(polynomials_, half_angle, result.coefficient);
  const double unit = in_pressure_units(1, half_angle);
  for (double& c : result.coefficient) c *= unit;
  return result;
}

double ExactPressure::peak(double half_angle) const noexcept {
  const Column values = evaluate(half_angle);
  double sum = 0;
  for (int k = terms - 1; k >= 0; --k) sum = values[k] - sum;
  return in_pressure_units(sum, half_angle);
}

double ExactPressure::force_ratio(double half_angle) const noexcept {
  return evaluate(half_angle)[terms];
}

}  // namespace contact
