#include "libcontact/seat/compliance.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libcontact/base/linear/solve.hpp"
#include "libcontact/conforming/layer_compliance.hpp"

namespace contact::detail {
namespace {

constexpr int lanes = 8;
using Lanes = Eigen::Array<double, lanes, 1>;

// N_nm at some angles for all n of one m. Where sin^m v is too small for a
// double it starts from 1e250 times as much, once or several times, and counts
// as 0 until these are used up.
class LegendreFunctions {
 public:
  explicit LegendreFunctions(const Lanes& v)
      : z_(v.cos()), log_sine_(v.sin().log()) {}

  // Columns: angles; rows: n = m, m + 1, ..., degree. m by steps of 1 from 0.
  void next(int m, int degree,
            Eigen::Array<double, Eigen::Dynamic, lanes>& out) {
    if (m > 0) log_norm_ += 0.5 * std::log((2 * m + 1) / (2.0 * m));
    const Lanes log_first = log_norm_ + m * log_sine_;
    const double log_factor = 250 * std::log(10.0);
    Lanes factors = (-log_first / log_factor).ceil().max(0.0);
    Lanes now = (log_first + factors * log_factor).exp();
    Lanes before = Lanes::Zero();
    bool scaled = (factors > 0).any();
    double beta = 0;
    for (int n = m; n <= degree; ++n) {
      if (scaled) {
        scaled = use_up(now, before, factors);
        out.row(n - m) = (factors > 0).select(0, now);
      } else {
        out.row(n - m) = now;
      }
      const double next_beta = ratio(n + 1, m);
      const Lanes next = (z_ * now - beta * before) / next_beta;
      before = now;
      now = next;
      beta = next_beta;
    }
  }

 private:
  // sqrt((n^2 - m^2)/(4 n^2 - 1))
  static double ratio(double n, double m) {
    return std::sqrt((n - m) * (n + m) / ((2 * n - 1) * (2 * n + 1)));
  }
  static bool use_up(Lanes& now, Lanes& before, Lanes& factors) {
    for (int k = 0; k < lanes; ++k) {
      if (factors(k) > 0 && std::abs(now(k)) > 1e125) {
        now(k) *= 1e-250;
        before(k) *= 1e-250;
        factors(k) -= 1;
      }
    }
    return (factors > 0).any();
  }

  Lanes z_, log_sine_;
  double log_norm_ = 0.5 * std::log(0.5);
};

// c_n of both bodies, in units of 4 rho/E.
Eigen::VectorXd compliances(const LayeredPair& pair, int degree) {
  using Side = LayerCompliance::Side;
  const LayerCompliance inner(JointKind::ball, Side::inner, pair);
  const LayerCompliance outer(JointKind::ball, Side::outer, pair);
  Eigen::VectorXd c(degree + 1);
  for (int n = 0; n <= degree; ++n) c(n) = inner(n).total + outer(n).total;
  return c;
}

// Sum over the degrees beyond the last one: N_nm is sqrt(2/(pi sin v)) times a
// cosine whose square is 1/2 in the mean, alike for all m << n.
Eigen::MatrixXd tail(const SeatCells& cells, int degree) {
  const int size = cells.size();
  const double n = degree + 0.5;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (const int rim : {0, 1}) {
    if (!cells.window.rim[rim]) continue;
    const int i = cells.rim_cell(rim);
    const double strength = cells.mean_shape(i) * cells.rim_shape(rim);
    const double sine = std::sin(cells.window.angle(rim));
    sum(i, i) += strength * strength * sine / n;
    if (!cells.window.is_free) continue;
    const double jump = cells.mean_shape(i);
    sum(i, i) += jump * jump * sine / (2 * std::numbers::pi * n * n);
  }
  for (int i = 0; i + 1 < size; ++i) {
    const double v = cells.bound(i + 1);
    const Eigen::Vector2d jump(cells.mean_shape(i), -cells.mean_shape(i + 1));
    sum.block<2, 2>(i, i) += jump * jump.transpose() *
                             (std::pow(cells.shape(v), 2) * std::sin(v) /
                              (2 * std::numbers::pi * n * n));
  }
  return sum;
}

// Near a pole the harmonics of an order m only begin at the degree m/sin v. Of
// cells where that is beyond the last one the whole pressure is missing from
// the sum, by sum_n B_n^2 = ∫ w_i^2 sin v dv: it begins there. Without,
// pressures that change from longitude to longitude would press in nothing.
void add_pole(int m, int degree, const SeatCells& cells,
              const Eigen::ArrayXd& square, Eigen::MatrixXd& matrix,
              const Eigen::MatrixXd& b) {
  for (int i = 0; i < cells.size(); ++i) {
    const double sine = std::sin((cells.bound(i) + cells.bound(i + 1)) / 2);
    const double begin = m / sine;
    if (begin < 0.7 * degree) continue;
    const double missing = square(i) - b.col(i).squaredNorm();
    matrix(i, i) += std::max(missing, 0.0) / std::max<double>(begin, degree);
  }
}

}  // namespace

SeatCompliance::SeatCompliance(const LayeredPair& pair, const SeatCells& cells,
                               int order, const SideFaceCompliance* side_face)
    // Below 6 wave numbers a cell those at a rim oscillate.
    : degree(static_cast<int>(
          std::ceil(std::max(8 / cells.smallest(), 1.5 * order)))) {
  const SeatCells::Rule rule = cells.rule(degree);
  const Eigen::VectorXd c = compliances(pair, degree);
  const Eigen::MatrixXd rest = tail(cells, degree);
  const auto count = rule.angle.size();
  Eigen::ArrayXd square = Eigen::ArrayXd::Zero(cells.size());
  for (Eigen::Index k = 0; k < count; ++k) {
    const int i = rule.cell(k);
    square(i) +=
        rule.weight(k) * cells.mean_shape(i) * cells.shape(rule.angle(k));
  }
  std::vector<LegendreFunctions> functions;
  for (Eigen::Index k = 0; k < count; k += lanes) {
    Lanes v = Lanes::Constant(rule.angle(count - 1));
    const auto some = std::min<Eigen::Index>(lanes, count - k);
    v.head(some) = rule.angle.segment(k, some);
    functions.emplace_back(v);
  }
  const auto more =
      side_face ? side_face->on(cells) : std::vector<Eigen::MatrixXd>();
  Eigen::Array<double, Eigen::Dynamic, lanes> legendre(degree + 1, lanes);
  for (int m = 0; m <= order; ++m) {
    const int terms = degree - m + 1;
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(terms, cells.size());
    for (Eigen::Index k = 0; k < count; ++k) {
      if (k % lanes == 0) functions[k / lanes].next(m, degree, legendre);
      b.col(rule.cell(k)) +=
          rule.weight(k) * legendre.col(k % lanes).head(terms).matrix();
    }
    matrix.push_back(rest);
    matrix.back().noalias() += b.transpose() * (c.tail(terms).asDiagonal() * b);
    add_pole(m, degree, cells, square, matrix.back(), b);
    if (side_face) matrix.back() += more[m];
  }
  // A_m alone is nearly singular for large m, where narrow cells are alike.
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(cells.size());
  for (const auto& a : matrix) mean += a.diagonal() / matrix.size();
  for (Eigen::MatrixXd a : matrix) {
    a.diagonal() += 1e-3 * mean;
    inverse.push_back(inverse_of_positive(a));
  }
}

}  // namespace contact::detail
