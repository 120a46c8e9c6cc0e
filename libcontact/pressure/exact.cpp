#include "libcontact/pressure/exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/instruction_set.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/edge_fit.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"
#include "libcontact/conforming/wide_edge.hpp"
#include "libcontact/pressure/edge_polynomial.hpp"
#include "libcontact/pressure/expansion.hpp"
#include "libcontact/pressure/gap/lifted.hpp"
#include "libcontact/pressure/plain_logarithm.hpp"
#include "libcontact/pressure/profile.hpp"
#include "libcontact/pressure/registry.hpp"

namespace contact {
namespace {

using detail::EdgeFit;
using detail::WideEdge;

using detail::infinity;
using detail::nan;
using detail::pi;
constexpr double usual_largest = 2 * pi / 3;

// Load that p carries, and the sum of its pressures.
struct Resultants {
  double load;
  double sum;
};

// Gauss' rule for integrals over x = sin(phi) with x^2 ln x, phi = (pi/2) v^2.
template <int size>
struct EdgeRule {
  EdgeRule() {
    const detail::GaussLegendre gauss(size);
    for (int i = 0; i < size; ++i) {
      const double v = (1 + gauss.node(i)) / 2;
      const double phi = pi / 2 * v * v;
      square[i] = std::sin(phi) * std::sin(phi);
      weight[i] = pi / 2 * gauss.weight(i) * v * std::cos(phi);
    }
  }
  std::array<double, size> square;  // x^2
  std::array<double, size> weight;
};

// By parts, which take the slope dp/dx for p.
template <int size>
Resultants resultants(JointKind kind, const ContactPressure& p) {
  static const EdgeRule<size> rule;
  std::array<double, size> slope;
  p.edge_slopes(rule.square, slope);
  const WideEdge edge(p.half_angle());
  const double b = std::tan(p.half_angle() / 2);
  Resultants r{0, 0};
  for (int i = 0; i < size; ++i) {
    const double tangent2 =
        b * b * (1 - rule.square[i] * edge.tangent_share(rule.square[i]));
    const double u = 2 * tangent2 / (1 + tangent2);  // 1 - cos t
    const double dp = rule.weight[i] * slope[i];
    if (kind == JointKind::ball) {
      r.sum += 2 * pi * u * dp;
      r.load += pi * u * (2 - u) * dp;
    } else {
      r.sum += 4 * std::atan(std::sqrt(tangent2)) * dp;
      r.load += 2 * std::sqrt(u * (2 - u)) * dp;
    }
  }
  return r;
}

// Whether the limit half-angle is less than usual_largest.
template <class Contact>
bool ends_early(const Contact& contact) {
  return contact.reciprocal_load(usual_largest) < 0;
}

// The limit half-angle, unless it is less than usual_largest; infinite if the
// solver does not reach it.
template <class Contact>
double end(const Contact& contact) {
  if (ends_early(contact)) return usual_largest;
  const ExactHalfAngle limit = contact.limit_half_angle();
  return limit.status == Status::ok ? limit.half_angle : infinity;
}

// Adds t_j times row j. Columns at a time: as many as the processor has
// registers for.
template <class Column>
[[gnu::always_inline]] inline void add_rows(const double* t,
                                            const std::vector<Column>& rows,
                                            int width, Column& sum) {
  constexpr int block = 8;
  static_assert(std::tuple_size_v<Column> % block == 0);
  for (int first = 0; first < width; first += block) {
    double part[block] = {};
    const double* factor = t;
    for (const Column& row : rows) {
      const double* from = row.data() + first;
      for (int k = 0; k < block; ++k) part[k] += *factor * from[k];
      ++factor;
    }
    std::copy_n(part, block, sum.data() + first);
  }
}

template <class Column>
void add_rows_baseline(const double* t, const std::vector<Column>& rows,
                       int width, Column& sum) {
  add_rows(t, rows, width, sum);
}

// With AVX-512, too: there are few numbers.
template <class Column>
#ifdef __x86_64__
[[gnu::target("avx2,fma")]]
#endif
void add_rows_avx2(const double* t, const std::vector<Column>& rows, int width,
                   Column& sum) {
  add_rows(t, rows, width, sum);
}

}  // namespace

ExactPressure::Series::Series(const Eigen::MatrixXd& values)
    : width_(static_cast<int>(values.cols())) {
  const int count = static_cast<int>(values.rows());
  Eigen::MatrixXd chebyshev(count, count);  // one degree in each column
  for (int i = 0; i < count; ++i) {
    chebyshev(i, 1) = std::cos(pi * (i + 0.5) / count);
  }
  chebyshev.col(0).setConstant(0.5);
  for (int j = 2; j < count; ++j) {
    chebyshev.col(j) = 2 * chebyshev.col(1).cwiseProduct(chebyshev.col(j - 1)) -
                       (j == 2 ? 2 : 1) * chebyshev.col(j - 2);
  }
  const Eigen::MatrixXd series = 2.0 / count * chebyshev.transpose() * values;
  // Rows that are rounding, or little more, are none.
  const double negligible = 1e-13 * series.row(0).cwiseAbs().maxCoeff();
  int rows = count;
  while (series.row(rows - 1).cwiseAbs().maxCoeff() < negligible) --rows;
  rows_.resize(rows);
  for (int j = 0; j < rows; ++j) {
    std::ranges::copy(series.row(j), rows_[j].begin());
  }
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
  const auto add_rows = instruction_set() == InstructionSet::baseline
                            ? add_rows_baseline<Column>
                            : add_rows_avx2<Column>;
  add_rows(t.data(), rows_, width_, sum);
  return sum;
}

ExactPressure::ExactPressure(JointKind kind, const ElasticPair& pair,
                             InnerLoading loading)
    : PressureLaw(kind, MadeFor(pair, {.loading = loading})) {
  set_interference(detail::without_layers(pair), loading);
  if (kind == JointKind::ball) {
    // More unknowns for the pressure; the half-angles set the limit.
    const BallContact contact(pair, loading, 24);
    tabulate(
        contact,
        ends_early(contact) ? usual_largest : end(BallContact(pair, loading)),
        infinity);
    tabulate_expansion();
    return;
  }
  const PinContact contact(pair, loading);
  if (const double last = end(contact); std::isfinite(last)) {
    tabulate(contact, last, infinity);
  } else {
    const PinContact fine(pair, loading, PinContact::max_unknowns);
    tabulate(fine, end(fine), infinity);
  }
  tabulate_expansion();
}

ExactPressure::ExactPressure(JointKind kind, const LayeredPair& pair,
                             InnerLoading loading)
    : PressureLaw(kind, MadeFor(pair.surfaces(), {loading, pair})) {
  set_interference(pair, loading);
  if (kind == JointKind::ball) {
    tabulate(BallContact(pair, loading), pair);
  } else {
    tabulate(PinContact(pair, loading), pair);
  }
}

ExactPressure::~ExactPressure() = default;

void ExactPressure::set_interference(const LayeredPair& pair,
                                     const InnerLoading& loading) {
  if (loading.is_back()) return;
  if (detail::can_have_interference(joint_kind(), pair)) interference_ = pair;
}

const detail::LiftedPressure* ExactPressure::lifted() const noexcept {
  std::call_once(lifted_asked_, [this] {
    if (!interference_) return;
    lifted_ = std::make_unique<const detail::LiftedPressure>(
        joint_kind(), *interference_, pi - largest_);
  });
  return lifted_.get();
}

double ExactPressure::closing_half_angle() const noexcept {
  return interference_ ? pi : largest_;
}

bool ExactPressure::harmonics(double half_angle,
                              std::span<double> out) const noexcept {
  if (joint_kind() == JointKind::pin || !is_lifted(half_angle)) return false;
  lifted()->harmonics(pi - half_angle, out);
  return true;
}

template <class Contact>
void ExactPressure::tabulate(const Contact& contact, const LayeredPair& pair) {
  // Thinner free rings have more than 32 sines that count.
  constexpr double thinnest_expanded = 0.045;
  tabulate(contact, end(contact), pair.relative_thickness());
  if (detail::free_ring_thickness(pair) < thinnest_expanded) {
    expansion_size_ = 0;
  } else {
    tabulate_expansion();
  }
}

template <class Contact>
void ExactPressure::tabulate(const Contact& contact, double end,
                             double thickness) {
  const JointKind kind = joint_kind();
  largest_ = std::min(std::max(end, usual_largest), contact.largest());
  variable_.emplace(kind, largest_, thickness);
  const bool wide = largest_ > usual_largest;
  terms_ = has_walls() ? contact.terms()
           : wide      ? EdgeFit::wide_terms
                       : EdgeFit::usual_terms;
  const int count = wide || has_walls() ? 64 : 28;
  Eigen::MatrixXd values(count, terms_ + logarithms + 1);
  for (int i = 0; i < count; ++i) {
    const double half_angle = chebyshev_half_angle(i, count);
    const ContactPressure solved = contact.pressure(half_angle, terms_);
    // The solver's own load is off by its truncation.
    const auto [load, sum] = terms_ > EdgeFit::usual_terms
                                 ? resultants<128>(kind, solved)
                                 : resultants<48>(kind, solved);
    const double scale = 1 / (load * in_pressure_units(1, half_angle));
    auto row = values.row(i);
    for (int k = 0; k < terms_; ++k) row(k) = scale * solved.coefficients()[k];
    for (int k = 0; k < logarithms; ++k) {
      row(terms_ + k) = scale * solved.logarithmic()[k];
    }
    row(terms_ + logarithms) = sum / load;
  }
  contact_ = Series(values);
}

void ExactPressure::tabulate_expansion() {
  constexpr int terms = PressureExpansion::max_terms;
  // More than contact_ has: the share of the logarithm depends on theta0 too.
  const int count = largest_ > usual_largest || has_walls() ? 96 : 44;
  // Accuracy of friction under walls; beyond 16 terms it is slower.
  const double small = has_walls() ? 1e-7 : 1e-13;
  const int most = has_walls() ? terms : 16;
  std::vector<Column> contacts;
  for (int i = 0; i < count; ++i) {
    const double half_angle = chebyshev_half_angle(i, count);
    const Column& value = contacts.emplace_back(evaluate(half_angle));
    if (half_angle > usual_largest) continue;
    // Far below the accuracy of the law; equal materials need few terms.
    const double negligible = small * std::abs(value[0]);
    for (int k = expansion_size_; k < std::min(most, terms_); ++k) {
      if (std::abs(value[k]) > negligible) expansion_size_ = k + 1;
    }
  }
  Eigen::MatrixXd values(count, logarithms + expansion_size_);
  for (int i = 0; i < count; ++i) {
    const Column& value = contacts[i];
    const std::span b = std::span(value).subspan(terms_, logarithms);
    std::array<double, terms> a{};
    std::copy_n(value.begin(), expansion_size_, a.begin());
    auto t = detail::edge_chebyshev(a);
    detail::to_plain_logarithm(
        WideEdge(chebyshev_half_angle(i, count)).cosine(), b,
        std::span(t).first(expansion_size_));
    const auto c = detail::edge_polynomial(t);
    auto row = values.row(i);
    for (int k = 0; k < logarithms; ++k) row(k) = b[k];
    for (int k = 0; k < expansion_size_; ++k) row(logarithms + k) = c[k];
  }
  expansion_ = Series(values);
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
  return joint_kind() == JointKind::ball ? value / length / length
                                         : value / length;
}

ContactPressure ExactPressure::contact(double half_angle) const noexcept {
  Column values = evaluate(half_angle);
  const double force_ratio = values[terms_ + logarithms];
  for (double& v : values) v = in_pressure_units(v, half_angle);
  const std::span all(values);
  return {half_angle, force_ratio, all.first(terms_),
          all.subspan(terms_, logarithms)};
}

namespace {

// p_1 in pressure units.
double first_harmonic(JointKind kind) {
  return kind == JointKind::ball ? 3 / (4 * pi) : 1 / pi;
}

}  // namespace

double ExactPressure::pressure(double theta, double half_angle) const noexcept {
  if (is_lifted(half_angle)) {
    return first_harmonic(joint_kind()) *
           lifted()->pressure(std::abs(theta), pi - half_angle);
  }
  if (std::isnan(theta) || !has(half_angle)) return nan;
  if (theta == 0) return centre(half_angle);
  if (std::abs(theta) > half_angle) return 0;
  return contact(half_angle).pressure(theta);
}

double ExactPressure::slope(double theta, double half_angle) const noexcept {
  if (is_lifted(half_angle) && !std::isnan(theta)) {
    return detail::PressureProfile(*this, half_angle).slope(theta);
  }
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
  if (expansion_size_ == 0) return result;
  const Column values = expansion_.evaluate(chebyshev_variable(half_angle));
  const double unit = in_pressure_units(1, half_angle);
  for (int k = 0; k < logarithms; ++k) result.logarithmic[k] = unit * values[k];
  for (int k = 0; k < expansion_size_; ++k) {
    result.coefficient[k] = unit * values[logarithms + k];
  }
  result.edge_constant = WideEdge(half_angle).constant();
  return result;
}

double ExactPressure::peak(double half_angle) const noexcept {
  if (is_lifted(half_angle)) {
    return first_harmonic(joint_kind()) * lifted()->centre(pi - half_angle);
  }
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
  if (is_lifted(half_angle)) {
    return (joint_kind() == JointKind::ball ? 3 : 2) *
           lifted()->mean(pi - half_angle);
  }
  return evaluate(half_angle)[terms_ + logarithms];
}

namespace detail {

extern constexpr PressureEntry exact_pressure = {
    .about = {.name = "exact",
              .meaning = "the theory of elasticity for this pair",
              .accuracy = "2e-7 of the peak",
              .needs = LawEntry::Needs::conditions,
              .allows_back = true,
              .allows_walls = true,
              .least_clearance = Clearance::interference,
              .is_slow_to_make = true},
    .shape = "series in an edge variable, with x^3 ln x",
    .make = [](const PressureRequest& asked) -> std::unique_ptr<PressureLaw> {
      const auto& [loading, walls, clearance] = asked.conditions;
      return walls
                 ? std::make_unique<ExactPressure>(asked.kind, *walls, loading)
                 : std::make_unique<ExactPressure>(asked.kind, asked.pair,
                                                   loading);
    }};

}  // namespace detail
}  // namespace contact
