#include "libcontact/conforming/ball.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/conforming/back_displacement.hpp"
#include "libcontact/conforming/edge_fit.hpp"
#include "libcontact/conforming/gap/signed_contact.hpp"
#include "libcontact/conforming/half_angle_root.hpp"
#include "libcontact/conforming/kernel/ball_kernel.hpp"
#include "libcontact/conforming/kernel/ball_wall_kernel.hpp"
#include "libcontact/conforming/legendre_galerkin.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"
#include "libcontact/conforming/wide_edge.hpp"

// Letters as in docs/internals/conforming_methods.md: h(f) is the Abel
// transform of the pressure, H_n its moment with cos((n + 1/2) f).
namespace contact {
namespace {

using detail::LegendreGalerkin;

using detail::infinity;
using detail::nan;
using detail::pi;

constexpr int most_unknowns = BallContact::max_walled_unknowns;
static_assert(most_unknowns == LegendreGalerkin::max_unknowns);

template <int columns>
using Columns =
    Eigen::Matrix<double, Eigen::Dynamic, columns, 0, most_unknowns, columns>;
using Vector = Columns<1>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0,
                             most_unknowns, most_unknowns>;
using Lanes = Eigen::Array<double, 8, 1>;
template <int max>
using Buffer = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max, 1>;

// cos(3f/2) - cos(f/2)
double cosine_difference(double f) {
  return -2 * std::sin(f) * std::sin(f / 2);
}

// h'(v)/v from the series of h and the term that it converges slowly for. Near
// the edge h = s (1 - v) + (A theta0/(2 pi)) s (1 - v)^2 ln(1 - v) + ...: the
// kernel -A ln|x| turns the linear term into the logarithm. The term is taken
// out of the series as chi(v) = ((1 - v^2)^2/4) ln(1 - v^2) and put back whole.
class EdgeCorrectedSlope {
 public:
  // log_coefficient: A theta0.
  EdgeCorrectedSlope(const Vector& h, const LegendreGalerkin& galerkin,
                     double log_coefficient)
      : at_edge_(slope(h) /
                 (1 + log_coefficient / (2 * pi) * slope(galerkin.edge_term))),
        edge_(log_coefficient / (2 * pi) * at_edge_) {
    smooth_.noalias() = galerkin.slope * (h - edge_ * galerkin.edge_term);
  }

  // s: slope of the series without its part of chi, whose slope is 0.
  double at_edge() const { return at_edge_; }

  // By v^2, 1 - v^2 and its logarithm; Clenshaw's recurrence.
  Lanes operator()(const Lanes& square, const Lanes& rest,
                   const Lanes& log_rest) const {
    const Lanes twice = 4 * square - 2;
    Lanes b0 = Lanes::Zero();
    Lanes b1 = Lanes::Zero();
    for (Eigen::Index k = smooth_.size() - 1; k > 0; --k) {
      const Lanes b = twice * b0 - b1 + smooth_(k);
      b1 = b0;
      b0 = b;
    }
    return twice / 2 * b0 - b1 + smooth_(0) - edge_ * rest * (log_rest + 0.5);
  }

 private:
  // -h'(1) of a series, P_n'(1) = n (n + 1)/2.
  static double slope(const Eigen::Ref<const Eigen::VectorXd>& h) {
    double sum = 0;
    for (int j = 1; j < h.size(); ++j) sum -= j * (2 * j + 1) * h(j);
    return sum;
  }

  double at_edge_;
  double edge_;
  Vector smooth_;
};

// f^2 = t^2 + (theta0^2 - t^2) s^2 with s = 1 - u^2 and Gauss' rule in u on
// [0, 1]; half of ds.
struct EdgeRule {
  explicit EdgeRule(int size) {
    const detail::GaussLegendre gauss(size);
    const Eigen::ArrayXd u = (1 + gauss.node.array()) / 2;
    weight = gauss.weight.array() * u;
    share = (1 - u.square()).square();
    rest = u.square() * (2 - u.square());
    log_rest = rest.log();
  }
  Eigen::ArrayXd weight, share;   // s^2
  Eigen::ArrayXd rest, log_rest;  // 1 - s^2
};

// (cos t - cos f)/(f^2 - t^2) for f and t up to pi, by synthetic division of
// the cosine's power series in f^2.
class CosineQuotient {
 public:
  explicit CosineQuotient(double t) {
    double factorial = 1;
    for (int k = 1; k <= terms; ++k) {
      factorial *= -2 * k * (2 * k - 1.0);
      coefficient_[k - 1] = -1 / factorial;
    }
    for (int k = terms - 1; k > 0; --k) {
      coefficient_[k - 1] += t * t * coefficient_[k];
    }
  }
  Lanes operator()(const Lanes& square) const {
    Lanes sum = Lanes::Constant(coefficient_[terms - 1]);
    for (int k = terms - 2; k >= 0; --k) {
      sum = sum * square + coefficient_[k];
    }
    return sum;
  }

 private:
  static constexpr int terms = 15;
  std::array<double, terms> coefficient_;
};

}  // namespace

struct BallContact::Tables {
  Tables(const ElasticPair& pair, InnerLoading loading, int unknowns,
         const detail::WallHarmonics& walls, double thickness)
      : kernel({pair.inner_compliance_share(), pair.inner().poissons_ratio,
                pair.outer_compliance_share(), pair.outer().poissons_ratio}),
        galerkin(LegendreGalerkin::table(unknowns)),
        // R_n = 2 pi rho^2 H_1 is twice the resultant that it is made for.
        back_factor(2 * pair.inner_compliance_share()),
        mean(walls.mean),
        // The kernel has d_1 = 0, which is c_1 = 2/3.
        first_shift(walls.first - 2.0 / 3) {
    if (loading.is_back() && back_factor > 0) {
      back.emplace(pair.inner().poissons_ratio, loading.patch_half_angle());
    }
    if (!walls.correction.empty()) {
      wall.emplace(walls.correction, thickness);
    }
    if (loading.is_back()) first_shift = nan;
  }

  double back_displacement(double f) const {
    return back ? back_factor * (*back)(f) : 0;
  }

  detail::BallKernel kernel;
  const LegendreGalerkin& galerkin;
  double back_factor;
  std::optional<detail::BackDisplacement> back;
  std::optional<detail::BallWallKernel> wall;
  double mean;         // c_0
  double first_shift;  // c_1 - 2/3
};

// The equation at one half-angle in v = f/theta0, ready for any number of
// unknowns that the tables cover.
struct BallContact::Galerkin {
  Galerkin(const Tables& tables, double theta0);
  Solution solve(int unknowns) const;

  Matrix system;
  // Columns: right sides cos(f/2), cos(3f/2) - cos(f/2), back displacement.
  Columns<3> right;
  Eigen::Matrix<double, 3, 1> right_at_edge;
  Vector edge;           // (theta0/pi) ∫ kappa(theta0 (1 - v)) P_2i dv
  Vector mean_moment;    // H_0 of P_2i
  Vector force_moment;   // H_1 of P_2i
  Vector excess_moment;  // H_0 - H_1 of P_2i
};

// Scaled so that H_1 = 1: R_n = 2 pi rho^2.
struct BallContact::Solution {
  Vector h;          // coefficients of P_2i(f/theta0)
  double clearance;  // ebar in units of 2 pi/E
  double delta;      // likewise: the approach with c_1 = 2/3
  double stiffness;  // d(force)/d(delta) for it
  double force_ratio;
  double excess;                                             // S - 1
  double reciprocal() const { return 2.0 / 3 * clearance; }  // 1/mu
};

BallContact::Galerkin::Galerkin(const Tables& tables, double theta0) {
  const LegendreGalerkin& g = tables.galerkin;
  const auto n = g.edge.rows();
  const auto nodes = g.node.size();

  Buffer<LegendreGalerkin::max_nodes> x = theta0 * g.node;
  Buffer<LegendreGalerkin::max_nodes> kappa(nodes);
  tables.kernel.evaluate({x.data(), static_cast<std::size_t>(nodes)},
                         {kappa.data(), static_cast<std::size_t>(nodes)});
  if (tables.wall) {
    for (int k = 0; k < nodes; ++k) kappa(k) += (*tables.wall)(x(k));
  }
  kappa *= theta0 / pi;
  Buffer<most_unknowns*(most_unknowns + 1) / 2> packed(g.correlation.rows());
  packed.noalias() = g.correlation * kappa;
  edge.noalias() = g.edge * kappa;
  system.resize(n, n);
  for (int i = 0, row = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j, ++row) system(i, j) = packed(row);
    system(i, i) += 2.0 / (4 * i + 1);
  }

  const auto count = g.projection_node.size();
  Eigen::Matrix<double, Eigen::Dynamic, 3, 0,
                LegendreGalerkin::max_projection_nodes, 3>
      given(count, 3);
  for (int k = 0; k < count; ++k) {
    const double f = theta0 * g.projection_node(k);
    given.row(k) << std::cos(f / 2), cosine_difference(f),
        tables.back_displacement(f);
  }
  right.noalias() = g.projection * given;
  right_at_edge << std::cos(theta0 / 2), cosine_difference(theta0),
      tables.back_displacement(theta0);
  mean_moment = theta0 / 2 * right.col(0);
  force_moment = theta0 / 2 * (right.col(0) + right.col(1));
  excess_moment = -theta0 / 2 * right.col(1);
}

BallContact::Solution BallContact::Galerkin::solve(int n) const {
  // d_n > -1 makes the system positive definite.
  // Factored in its place and as a matrix of any size: another copy, and
  // Eigen's buffers for one of this largest size, take 200 kB of the stack.
  Matrix leading = system.topLeftCorner(n, n);
  Columns<3> u = right.topRows(n);
  detail::factor_positive(leading);
  detail::solve_factored(leading, u);
  // Values at the edge from the equation itself, not from the series: twice
  // its order.
  const Eigen::Matrix<double, 3, 1> at_edge =
      right_at_edge - u.transpose() * edge.head(n);
  const Eigen::Matrix<double, 3, 1> force =
      u.transpose() * force_moment.head(n);
  // h = D u_1 + delta u_0 - u_2 with h(theta0) = 0, H_1 = 1; delta = D - ebar
  // and D are in units of 2 pi/E.
  const double ratio = at_edge(1) / at_edge(0);
  const double shift = at_edge(2) / at_edge(0);
  const double approach =
      (1 + force(2) - shift * force(0)) / (force(1) - ratio * force(0));
  const double delta = shift - approach * ratio;
  Solution result;
  result.h = approach * u.col(1) + delta * u.col(0) - u.col(2);
  result.clearance = approach - delta;
  result.delta = delta;
  result.stiffness = force(0) + force(1);
  result.force_ratio = mean_moment.head(n).dot(result.h);
  result.excess = excess_moment.head(n).dot(result.h);
  return result;
}

BallContact::BallContact(const ElasticPair& pair, InnerLoading loading,
                         int unknowns)
    : unknowns_(unknowns) {
  detail::require(unknowns >= 8 && unknowns <= max_unknowns, "ball contact",
                  "unknowns", unknowns, "8 to 32");
  tables_ = std::make_shared<const Tables>(
      pair, loading, unknowns,
      detail::WallHarmonics(JointKind::ball, detail::without_layers(pair)),
      infinity);
  set_largest(loading);
}

BallContact::BallContact(const LayeredPair& pair, InnerLoading loading,
                         int unknowns)
    : unknowns_(unknowns == 0 ? detail::walled_unknowns(pair) : unknowns) {
  detail::require(unknowns_ >= 8 && unknowns_ <= max_walled_unknowns,
                  "ball contact", "unknowns", unknowns, "8 to 64");
  detail::require_uncoated(pair, loading);
  tables_ = std::make_shared<const Tables>(
      pair.surfaces(), loading, unknowns_,
      detail::WallHarmonics(JointKind::ball, pair), pair.relative_thickness());
  set_largest(loading);
}

void BallContact::set_largest(InnerLoading loading) {
  largest_ = largest_half_angle;
  if (loading.is_back()) {
    // The edges of the contact and of the loaded patch must not touch.
    largest_ = std::min(largest_, pi - loading.patch_half_angle() - 1e-3);
  }
}

double BallContact::reciprocal_load(double half_angle) const noexcept {
  if (!(half_angle > 0 && half_angle <= largest_)) return nan;
  return Galerkin(*tables_, half_angle).solve(unknowns_).reciprocal();
}

ExactLoad BallContact::load_parameter(double half_angle) const noexcept {
  if (half_angle == 0) return {0, Status::ok, 0};
  if (!(half_angle > 0 && half_angle <= largest_)) {
    return {nan, Status::out_of_range, nan};
  }
  const Galerkin galerkin(*tables_, half_angle);
  const double reciprocal = galerkin.solve(unknowns_).reciprocal();
  if (!(reciprocal >= 0)) return {nan, Status::out_of_range, nan};
  const double coarse = galerkin.solve(unknowns_ - 4).reciprocal();
  return {1 / reciprocal, Status::ok, std::abs(reciprocal - coarse)};
}

ExactHalfAngle BallContact::half_angle(double load_parameter) const noexcept {
  if (!(load_parameter >= 0)) return {nan, Status::out_of_range, nan, 0};
  if (load_parameter == 0) return {0, Status::ok, 0, 0};
  return detail::half_angle_root(
      [this](double theta) { return reciprocal_load(theta); },
      1 / load_parameter, std::cbrt(load_parameter), 3, largest_);
}

ExactHalfAngle BallContact::limit_half_angle() const noexcept {
  return half_angle(infinity);
}

ForcePoint BallContact::force_point(double half_angle) const noexcept {
  if (!(half_angle > 0 && half_angle <= largest_)) {
    return {nan, {nan, nan}, nan};
  }
  const Solution s = Galerkin(*tables_, half_angle).solve(unknowns_);
  // c_1 p_1 in units of eps, p_1 = 3 R_n/(4 pi rho^2).
  const double shift = 3 / pi * tables_->first_shift;
  return {s.reciprocal(),
          {(s.delta + shift) / s.clearance, 1 / (1 / s.stiffness + shift)},
          s.excess};
}

detail::SignedContact BallContact::signed_contact(
    double half_angle) const noexcept {
  if (!(half_angle > 0 && half_angle <= largest_) || tables_->back) {
    return {nan, nan, nan, nan, nan};
  }
  const Solution s = Galerkin(*tables_, half_angle).solve(unknowns_);
  const double inverse = pi / 2 * s.reciprocal();
  // R_n = (4 pi/3) rho^2 p_1; D and the approach are in units of 2 pi/E.
  return {inverse, inverse + tables_->mean, 1 - s.force_ratio / 3,
          pi / 3 * (s.delta + s.clearance) - 2.0 / 3,
          pi / 3 / s.stiffness - 2.0 / 3};
}

int BallContact::terms() const noexcept {
  return detail::EdgeFit::terms_for(unknowns_);
}

ContactPressure BallContact::pressure(double half_angle,
                                      int terms) const noexcept {
  // p(t) = -(1/sqrt 2) ∫_t^theta0 h'(f)/sqrt(cos t - cos f) df. With
  // f^2 = t^2 + (theta0^2 - t^2) s^2 the integrand is smooth in s on [0, 1],
  // but for a logarithm at s = 1, which s = 1 - u^2 takes away.
  // As h has twice the unknowns for its degree, 32 nodes take 32 of them.
  static const EdgeRule& usual = *new EdgeRule(32);
  static const EdgeRule& fine = *new EdgeRule(2 * most_unknowns);
  const EdgeRule& rule = unknowns_ > max_unknowns ? fine : usual;
  const detail::EdgeFit& fit =
      detail::EdgeFit::table(terms == 0 ? this->terms() : terms);
  if (!(half_angle > 0 && half_angle <= largest_)) return {nan, nan, {}, {}};
  const double theta0 = half_angle;
  const Solution solution = Galerkin(*tables_, theta0).solve(unknowns_);
  const double log_coefficient = tables_->kernel.log_coefficient();
  const EdgeCorrectedSlope slope(solution.h, tables_->galerkin,
                                 theta0 * log_coefficient);
  const double b = std::tan(theta0 / 2);
  const detail::WideEdge edge(theta0);
  detail::EdgeFit::Points values(fit.points());
  for (int i = 0; i < fit.points(); ++i) {
    // tan^2(t/2) = b^2 (1 - y^2); theta0 - t without cancellation.
    const double share = edge.tangent_share(fit.square(i));
    const double cosine = fit.cosine(i) * std::sqrt(edge.cosine() * share);
    const double t = 2 * std::atan(b * cosine);
    const double rest = 2 * std::atan(b * fit.square(i) * share /
                                      ((1 + cosine) * (1 + b * b * cosine)));
    const double square = rest * (theta0 + t);  // theta0^2 - t^2
    const CosineQuotient quotient(t);
    const double largest_rest = square / (theta0 * theta0);
    const double log_largest = std::log(largest_rest);
    Lanes p = Lanes::Zero();
    for (int k = 0; k < rule.share.size(); k += Lanes::SizeAtCompileTime) {
      const auto at = [k](const Eigen::ArrayXd& x) -> Lanes {
        return x.segment<Lanes::SizeAtCompileTime>(k);
      };
      const Lanes f2 = t * t + square * at(rule.share);
      p -= at(rule.weight) *
           slope(f2 / (theta0 * theta0), largest_rest * at(rule.rest),
                 log_largest + at(rule.log_rest)) /
           quotient(f2).sqrt();
    }
    // In units of R_n/rho^2 = 2 pi H_1.
    values(i) = p.sum() * std::sqrt(square / 2) / (2 * pi * theta0 * theta0);
  }
  // dp/dx at the edge, where theta0 - t = sin(theta0/2) x^2.
  const double edge_slope =
      slope.at_edge() / (2 * pi * theta0 * std::sqrt(edge.cosine()));
  return fit(
      theta0, solution.force_ratio, values,
      detail::EdgeFit::leading_logarithm(edge_slope, log_coefficient, theta0));
}

}  // namespace contact
