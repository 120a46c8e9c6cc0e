#include "libcontact/pressure_exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/detail/edge_fit.hpp"
#include "libcontact/detail/edge_polynomial.hpp"
#include "libcontact/detail/gauss_legendre.hpp"
#include "libcontact/detail/wide_edge.hpp"

namespace contact {
namespace {

using detail::EdgeFit;
using detail::WideEdge;

constexpr double pi = std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double usual_largest = 2 * pi / 3;

// Sines of a law that its expansion() takes over.
int expansion_terms(int terms) {
  return std::min(terms, PressureExpansion::max_terms);
}

// What p carries, and the sum of its pressures.
struct Resultants {
  double load;
  double sum;
};

// By Gauss' rule in phi, where the integrand is analytic but for
// phi^4 ln(phi).
Resultants resultants(JointKind kind, const ContactPressure& p) {
  static const detail::GaussLegendre rule(48);
  const WideEdge edge(p.half_angle());
  const double b = std::tan(p.half_angle() / 2);
  Resultants r{0, 0};
  for (int i = 0; i < rule.node.size(); ++i) {
    const double phi = pi / 4 * (1 + rule.node(i));
    const double x = std::sin(phi);
    const double share = edge.cosine() * edge.tangent_share(x * x);
    const double t = 2 * std::atan(b * std::cos(phi) * std::sqrt(share));
    // dt by d(x^2); a pin has two sides.
    const double area =
        pi / 4 * rule.weight(i) * std::sin(2 * phi) / edge.square_slope(t) *
        (kind == JointKind::spherical ? 2 * pi * std::sin(t) : 2.0);
    r.sum += p.pressure(t) * area;
    r.load += p.pressure(t) * area * std::cos(t);
  }
  return r;
}

}  // namespace

void ExactPressure::Series::add(std::span<const double> values, int i,
                                int count) {
  rows_.resize(static_cast<std::size_t>(count) * width_);
  double* row = rows_.data();
  for (int j = 0; j < count; ++j, row += width_) {
    const double factor =
        (j == 0 ? 1.0 : 2.0) / count * std::cos(j * pi * (i + 0.5) / count);
    for (int k = 0; k < width_; ++k) row[k] += factor * values[k];
  }
  if (i + 1 < count) return;
  // The last point: rows that are rounding go.
  const auto largest = [&](std::span<const double> row_values) {
    double m = 0;
    for (const double v : row_values) m = std::max(m, std::abs(v));
    return m;
  };
  const auto width = static_cast<std::size_t>(width_);
  const double rounding = 1e-15 * largest(std::span(rows_).first(width));
  while (largest(std::span(rows_).last(width)) < rounding) {
    rows_.resize(rows_.size() - width);
  }
}

void ExactPressure::Series::evaluate(double v, std::span<double> sum) const {
  std::fill_n(sum.begin(), width_, 0);
  // T_{j+1} = 2 v T_j - T_{j-1}
  double last = v;  // T_{-1}
  double now = 1;
  for (auto row = rows_.begin(); row != rows_.end(); row += width_) {
    for (int k = 0; k < width_; ++k) sum[k] += now * row[k];
    const double next = 2 * v * now - last;
    last = now;
    now = next;
  }
}

ExactPressure::ExactPressure(JointKind kind, const ElasticPair& pair,
                             InnerLoading loading)
    : PressureLaw(kind) {
  if (kind == JointKind::spherical) {
    // More unknowns for the pressure; the limit is that of the half-angles.
    tabulate(BallContact(pair, loading, 24),
             BallContact(pair, loading).limit_half_angle());
    return;
  }
  const PinContact contact(pair, loading);
  const ExactHalfAngle limit = contact.limit_half_angle();
  if (limit.status == Status::ok) {
    tabulate(contact, limit);
  } else {
    const PinContact fine(pair, loading, PinContact::max_unknowns);
    tabulate(fine, fine.limit_half_angle());
  }
}

template <class Contact>
void ExactPressure::tabulate(const Contact& contact,
                             const ExactHalfAngle& limit) {
  const JointKind kind = joint_kind();
  const bool ball = kind == JointKind::spherical;
  const double wanted =
      limit.status == Status::ok ? limit.half_angle : contact.largest();
  largest_ = std::min(std::max(wanted, usual_largest), contact.largest());
  const bool wide = largest_ > usual_largest;
  terms_ = wide ? EdgeFit::wide_terms : EdgeFit::usual_terms;
  const int count = wide ? 64 : 28;
  contact_ = Series(terms_ + logarithms + 1);
  expansion_ = Series(expansion_terms(terms_) + logarithms);
  for (int i = 0; i < count; ++i) {
    const double share = (1 + std::cos(pi * (i + 0.5) / count)) / 2;
    const double half_angle = largest_ * (ball ? share * share : share);
    const ContactPressure solved = contact.pressure(half_angle, terms_);
    // The solver's own load is off by its truncation.
    const auto [load, sum] = resultants(kind, solved);
    const double scale = 1 / (load * in_pressure_units(1, half_angle));

    Column value{};
    const auto end = std::ranges::copy(solved.coefficients(), value.begin());
    std::ranges::copy(solved.logarithmic(), end.out);
    for (double& v : value) v *= scale;
    value[contact_.width() - 1] = sum / load;
    contact_.add(value, i, count);

    std::array<double, PressureExpansion::max_terms> a{};
    std::copy_n(value.begin(), expansion_terms(terms_), a.begin());
    // Far below the accuracy of the law; equal materials need few terms.
    const double negligible = 1e-13 * std::abs(value[0]);
    for (int k = expansion_size_; k < PressureExpansion::max_terms; ++k) {
      if (half_angle <= usual_largest && std::abs(a[k]) > negligible) {
        expansion_size_ = k + 1;
      }
    }
    const auto c = detail::edge_polynomial(a);
    Column expansion{};
    const auto rest =
        std::copy_n(c.begin(), expansion_terms(terms_), expansion.begin());
    std::copy_n(value.begin() + terms_, logarithms, rest);
    expansion_.add(expansion, i, count);
  }
}

double ExactPressure::chebyshev_variable(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  const double share = half_angle / largest_;
  const bool ball = joint_kind() == JointKind::spherical;
  return 2 * (ball ? std::sqrt(share) : share) - 1;
}

ExactPressure::Column ExactPressure::evaluate(
    double half_angle) const noexcept {
  Column column{};
  contact_.evaluate(chebyshev_variable(half_angle), column);
  return column;
}

double ExactPressure::in_pressure_units(double value,
                                        double half_angle) const noexcept {
  const double length = 2 * std::sin(half_angle / 2);
  return joint_kind() == JointKind::spherical ? value / length / length
                                              : value / length;
}

ContactPressure ExactPressure::contact(double half_angle) const noexcept {
  Column values = evaluate(half_angle);
  const double force_ratio = values[contact_.width() - 1];
  for (double& v : values) v = in_pressure_units(v, half_angle);
  const std::span all(values);
  return {half_angle, force_ratio, all.first(terms_),
          all.subspan(terms_, logarithms)};
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
  const ContactPressure p = contact(half_angle);
  const WideEdge edge(half_angle);
  // x^2 = share y^2, dx/dy = share^(3/2)/c.
  for (std::size_t i = 0; i < edge_variable.size(); ++i) {
    const double y2 = edge_variable[i] * edge_variable[i];
    out[i] = edge.share(y2) * y2;
  }
  p.edge_slopes(out, out);
  for (std::size_t i = 0; i < edge_variable.size(); ++i) {
    const double share = edge.share(edge_variable[i] * edge_variable[i]);
    out[i] *= share * std::sqrt(share) / edge.cosine();
  }
}

PressureExpansion ExactPressure::expansion(double half_angle) const noexcept {
  PressureExpansion result{.size = expansion_size_};
  Column values{};
  expansion_.evaluate(chebyshev_variable(half_angle), values);
  const double unit = in_pressure_units(1, half_angle);
  const auto scaled = [unit](double value) { return value * unit; };
  const std::span all(values);
  const int terms = expansion_terms(terms_);
  std::ranges::transform(all.first(terms), result.coefficient.begin(), scaled);
  std::ranges::transform(all.subspan(terms, logarithms),
                         result.logarithmic.begin(), scaled);
  result.edge_constant = WideEdge(half_angle).constant();
  return result;
}

double ExactPressure::peak(double half_angle) const noexcept {
  const Column values = evaluate(half_angle);
  double sum = 0;
  for (int k = terms_ - 1; k >= 0; --k) sum = values[k] - sum;
  return in_pressure_units(sum, half_angle);
}

double ExactPressure::force_ratio(double half_angle) const noexcept {
  return evaluate(half_angle)[contact_.width() - 1];
}

}  // namespace contact
