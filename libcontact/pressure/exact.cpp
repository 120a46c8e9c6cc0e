#include "libcontact/pressure/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/edge_fit.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/wide_edge.hpp"
#include "libcontact/pressure/edge_polynomial.hpp"
#include "libcontact/pressure/plain_logarithm.hpp"

namespace contact {
namespace {

using detail::EdgeFit;
using detail::WideEdge;

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double usual_largest = 2 * pi / 3;

// What p carries, and the sum of its pressures.
struct Resultants {
  double load;
  double sum;
};

// By Gauss' rule in phi, where the integrand is analytic but for
// phi^4 ln(phi).
Resultants resultants(JointKind kind, const ContactPressure& p) {
  static const detail::GaussLegendre usual(48);
  static const detail::GaussLegendre fine(128);
  const detail::GaussLegendre& rule =
      p.coefficients().size() > EdgeFit::wide_terms ? fine : usual;
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
  rows_.resize(count);
  for (int j = 0; j < count; ++j) {
    const double factor =
        (j == 0 ? 1.0 : 2.0) / count * std::cos(j * pi * (i + 0.5) / count);
    for (int k = 0; k < width_; ++k) rows_[j][k] += factor * values[k];
  }
  if (i + 1 < count) return;
  // The last point: rows that are rounding go.
  const auto largest = [&](const Column& row) {
    double m = 0;
    for (const double v : row) m = std::max(m, std::abs(v));
    return m;
  };
  const double rounding = 1e-15 * largest(rows_.front());
  while (largest(rows_.back()) < rounding) rows_.pop_back();
}

ExactPressure::Column ExactPressure::Series::evaluate(double v) const {
  // T_{2j} = 2 T_j^2 - 1, T_{2j+1} = 2 T_j T_{j+1} - v: no long chain.
  const std::size_t rows = rows_.size();
  std::array<double, most_rows + 1> t{1, v};
  for (std::size_t j = 1; 2 * j < rows; ++j) {
    t[2 * j] = 2 * t[j] * t[j] - 1;
    t[2 * j + 1] = 2 * t[j] * t[j + 1] - v;
  }
  Column sum{};
  // So many columns at a time as the processor has registers for.
  constexpr int block = 8;
  static_assert(max_width % block == 0);
  for (int first = 0; first < width_; first += block) {
    std::array<double, block> part{};
    for (std::size_t j = 0; j < rows; ++j) {
      for (int k = 0; k < block; ++k) part[k] += t[j] * rows_[j][first + k];
    }
    std::ranges::copy(part, sum.begin() + first);
  }
  return sum;
}

ExactPressure::ExactPressure(JointKind kind, const ElasticPair& pair,
                             InnerLoading loading)
    : PressureLaw(kind) {
  if (kind == JointKind::spherical) {
    // More unknowns for the pressure; the limit is that of the half-angles.
    tabulate(BallContact(pair, loading, 24),
             BallContact(pair, loading).limit_half_angle(), infinity);
    return;
  }
  const PinContact contact(pair, loading);
  const ExactHalfAngle limit = contact.limit_half_angle();
  if (limit.status == Status::ok) {
    tabulate(contact, limit, infinity);
  } else {
    const PinContact fine(pair, loading, PinContact::max_unknowns);
    tabulate(fine, fine.limit_half_angle(), infinity);
  }
}

ExactPressure::ExactPressure(JointKind kind, const LayeredPair& pair,
                             InnerLoading loading)
    : PressureLaw(kind) {
  const double thickness = pair.relative_thickness();
  if (kind == JointKind::spherical) {
    const BallContact contact(pair, loading);
    tabulate(contact, contact.limit_half_angle(), thickness);
  } else {
    const PinContact contact(pair, loading);
    tabulate(contact, contact.limit_half_angle(), thickness);
  }
}

template <class Contact>
void ExactPressure::tabulate(const Contact& contact,
                             const ExactHalfAngle& limit, double thickness) {
  const JointKind kind = joint_kind();
  const double wanted =
      limit.status == Status::ok ? limit.half_angle : contact.largest();
  largest_ = std::min(std::max(wanted, usual_largest), contact.largest());
  variable_.emplace(kind, largest_, thickness);
  const bool wide = largest_ > usual_largest;
  terms_ = has_walls() ? contact.terms()
           : wide      ? EdgeFit::wide_terms
                       : EdgeFit::usual_terms;
  const int count = wide || has_walls() ? 64 : 28;
  contact_ = Series(terms_ + logarithms + 1);
  for (int i = 0; i < count; ++i) {
    const double half_angle = chebyshev_half_angle(i, count);
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
  }
  tabulate_expansion();
}

void ExactPressure::tabulate_expansion() {
  constexpr int terms = PressureExpansion::max_terms;
  // More than contact_ has: the share of the logarithm depends on theta0 too.
  const int count = largest_ > usual_largest || has_walls() ? 96 : 44;
  // What friction under walls is good for; beyond 16 terms it is slower.
  const double small = has_walls() ? 1e-7 : 1e-13;
  const int most = has_walls() ? terms : 16;
  for (int i = 0; i < count; ++i) {
    const double half_angle = chebyshev_half_angle(i, count);
    if (half_angle > usual_largest) continue;
    const Column value = evaluate(half_angle);
    // Far below the accuracy of the law; equal materials need few terms.
    const double negligible = small * std::abs(value[0]);
    for (int k = expansion_size_; k < std::min(most, terms_); ++k) {
      if (std::abs(value[k]) > negligible) expansion_size_ = k + 1;
    }
  }
  expansion_ = Series(logarithms + expansion_size_);
  for (int i = 0; i < count; ++i) {
    const double half_angle = chebyshev_half_angle(i, count);
    const Column value = evaluate(half_angle);
    const std::span b = std::span(value).subspan(terms_, logarithms);
    std::array<double, terms> a{};
    std::copy_n(value.begin(), expansion_size_, a.begin());
    auto c = detail::edge_polynomial(a);
    detail::to_plain_logarithm(WideEdge(half_angle).cosine(), b,
                               std::span(c).first(expansion_size_));
    Column expansion{};
    const auto rest = std::ranges::copy(b, expansion.begin()).out;
    std::copy_n(c.begin(), expansion_size_, rest);
    expansion_.add(expansion, i, count);
  }
}

double ExactPressure::chebyshev_half_angle(int i, int count) const noexcept {
  const double share = (1 + std::cos(pi * (i + 0.5) / count)) / 2;
  return variable_->half_angle(share, 1 - share).first;
}

double ExactPressure::chebyshev_variable(double half_angle) const noexcept {
  if (!has(half_angle)) return nan;
  return 2 * (*variable_)(half_angle).first - 1;
}

ExactPressure::Column ExactPressure::evaluate(
    double half_angle) const noexcept {
  return contact_.evaluate(chebyshev_variable(half_angle));
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
  if (theta == 0) return centre(half_angle);
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
  const Column values = expansion_.evaluate(chebyshev_variable(half_angle));
  const double unit = in_pressure_units(1, half_angle);
  const auto scaled = [unit](double value) { return value * unit; };
  const std::span all(values);
  std::ranges::transform(all.first(logarithms), result.logarithmic.begin(),
                         scaled);
  std::ranges::transform(all.subspan(logarithms, expansion_size_),
                         result.coefficient.begin(), scaled);
  result.edge_constant = WideEdge(half_angle).constant();
  return result;
}

double ExactPressure::peak(double half_angle) const noexcept {
  if (!has_walls() || !(half_angle > 0)) return centre(half_angle);
  return contact(half_angle).peak();
}

double ExactPressure::centre(double half_angle) const noexcept {
  const Column values = evaluate(half_angle);
  double sum = 0;
  for (int k = terms_ - 1; k >= 0; --k) sum = values[k] - sum;
  return in_pressure_units(sum, half_angle);
}

double ExactPressure::force_ratio(double half_angle) const noexcept {
  return evaluate(half_angle)[contact_.width() - 1];
}

}  // namespace contact
