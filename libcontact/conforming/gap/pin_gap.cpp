#include "libcontact/conforming/gap/pin_gap.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/conforming/gap/harmonic_fade.hpp"
#include "libcontact/conforming/kernel/pin_wall_modes.hpp"
#include "libcontact/conforming/pin_integrals.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"

// Letters as in docs/explanation/preload.md: t' = pi - t, tan(t'/2) = b s, s =
// cos phi, b = tan(psi/2); the gap is b sum y_k sin((2k+1) phi), its harmonics
// g_n.
namespace contact::detail {
namespace {

// Number of harmonics of a gap: the rest of the sums leaves 1/(3 psi N^3) of x.
int harmonics(double opening, double share, std::size_t corrected) {
  const double smooth = share * std::max(2500.0, 3500 / std::cbrt(opening));
  return std::max(static_cast<int>(smooth), static_cast<int>(corrected));
}

}  // namespace

PinGap::PinGap(const LayeredPair& pair, int unknowns, double harmonics)
    : beta_(pair.surfaces().dundurs_beta()),
      unknowns_(unknowns == 0 ? gap_unknowns(pair) : unknowns),
      harmonics_(harmonics) {
  const WallHarmonics walls(JointKind::pin, pair);
  mean_ = walls.mean;
  first_ = walls.first;
  correction_ = walls.correction;
}

double PinGap::stiffness_rest(int n) const {
  const double wall = static_cast<std::size_t>(n) < correction_.size()
                          ? (n - 1.0) * (n + 1.0) * correction_[n]
                          : 0;
  return (beta_ * beta_ - 1 - (n - beta_) * wall) / (n + beta_ + wall);
}

GapField PinGap::field(double psi) const {
  const int count = unknowns_;
  const double b = std::tan(psi / 2);
  const double sine = std::sin(psi / 2);
  Eigen::VectorXd constant(count);
  Eigen::VectorXd cosine(count);
  project_first_harmonics(psi, constant, cosine);
  Eigen::VectorXd difference(count);  // cos t' - 1, without cancellation
  const double q = std::tan(psi / 4);
  for (int k = 0; k < count; ++k) {
    difference(k) = constant(k) * (2 * k - 2 * (k + 1) * q * q) / (1 + q * q);
  }
  const ChebyshevMoments moments(b * b, 2 * count);
  const PinWallModes modes(psi, count);
  const Eigen::MatrixXd& t = modes.transformation();

  // sum r_n G_n G_n^T, and the edge's sum r_n om_n G_n.
  const int end = harmonics(psi, harmonics_, correction_.size());
  const GradedSamples samples(psi, end, modes.smooth_from());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(t.rows(), t.rows());
  Eigen::VectorXd edge_sum = Eigen::VectorXd::Zero(t.rows());
  const auto adder = [&](const auto& order, const auto& weight,
                         const std::vector<double>& average) {
    return [&](int first, const auto& g) {
      Eigen::VectorXd rest(g.rows());
      Eigen::VectorXd at_edge(g.rows());
      for (int i = 0; i < g.rows(); ++i) {
        const int n = static_cast<int>(order[first + i]);
        rest(i) = weight[first + i] * stiffness_rest(n);
        at_edge(i) = rest(i) * average[n];
      }
      const Eigen::MatrixXd weighted = rest.asDiagonal() * g;
      sum.triangularView<Eigen::Lower>() += weighted.transpose() * g;
      edge_sum += g.transpose() * at_edge;
    };
  };
  const std::vector<double> average = edge_averages(psi, end);
  const HarmonicSamples& swinging = samples.swinging;
  modes.visit(swinging.n, adder(swinging.n, swinging.weight, average));
  if (!samples.n.empty()) {
    const auto second = second_edge_averages(psi, end);
    modes.visit(samples.n, adder(samples.n, samples.weight, average));
    modes.visit_second_kind(samples.n,
                            adder(samples.n, samples.weight, second));
  }
  const Eigen::MatrixXd all = sum.selfadjointView<Eigen::Lower>() * t;
  Eigen::MatrixXd matrix = t.transpose() * all / (2 * pi);
  for (int k = 0; k < count; ++k) {
    for (int j = 0; j < count; ++j) {
      matrix(j, k) -= beta_ * b * moments.matrix_element(j, k);
    }
    matrix(k, k) += (2 * k + 1) * pi / 4;
  }
  // The gap is -(Q_0 - Q_1) y_0 + Q_1 y_2, Q_1 = 1.
  Eigen::MatrixXd y(count, 2);
  y << constant, difference;
  solve_in_place(matrix, y);
  const Eigen::RowVector2d mean = b * b / pi * constant.transpose() * y;
  const Eigen::RowVector2d first = 2 * b * b / pi * cosine.transpose() * y;

  // The square root's amplitude at the edge is 0.
  Eigen::VectorXd second(count);
  moments.second_kind(second);
  const Eigen::VectorXd edge = beta_ * b * std::sqrt(1 + b * b) / pi * second -
                               b / pi * t.transpose() * edge_sum;
  const Eigen::RowVector2d at_edge = edge.transpose() * y;
  const double excess = (at_edge(1) - sine * sine) / (1 + at_edge(0));

  const double g0 = mean(1) - excess * mean(0);
  const double g1 = first(1) - excess * first(0);
  const double k1 = 1 - (1 - beta_) * g1;
  const double k0_less_k1 = excess - beta_ * g0 + (1 - beta_) * g1;

  // As the shift grows at constant clearance the root has an amplitude, and
  // c_0 K_0 = g_0.
  const double factor = 1 + mean_ * beta_;
  const double rate = (factor * mean(1) - mean_) / (mean_ + factor * mean(0));
  const double g1_rate = first(1) - rate * first(0);
  const double k1_rate = 1 - (1 - beta_) * g1_rate;

  const Eigen::VectorXd gap = y.col(1) - excess * y.col(0);
  const double beyond = (g0 - mean_ * k0_less_k1) / k1;
  return {
      {beyond - mean_, beyond, -k0_less_k1 / k1, g1 / k1, g1_rate / k1_rate},
      psi,
      g0 / k1,
      gap / k1};
}

// sum r_n g_n cos(n t'), n >= 2
double PinGap::smooth(const GapField& field, double opposite) const {
  const double b = std::tan(field.opening / 2);
  const PinWallModes modes(field.opening,
                           static_cast<int>(field.series.size()));
  const Eigen::VectorXd series =
      b / pi * (modes.transformation() * field.series);
  const HarmonicFade fade(opposite - field.opening,
                          static_cast<int>(correction_.size()));
  std::vector<double> order;
  for (int n = 2; n < fade.end(); ++n) order.push_back(n);
  double sum = 0;
  modes.visit(order, [&](int start, const auto& g) {
    const Eigen::VectorXd harmonic = g * series;
    for (int i = 0; i < g.rows(); ++i) {
      const int n = static_cast<int>(order[start + i]);
      sum += fade(n) * stiffness_rest(n) * harmonic(i) * std::cos(n * opposite);
    }
  });
  return sum;
}

double PinGap::centre(const GapField& field) const {
  const SignedContact& c = field.contact;
  const double b = std::tan(field.opening / 2);
  return 2 - c.mean_deficit - b * b / 4 * field.series(0) +
         beta_ * field.mean_gap + (1 - beta_) * c.gap_shift + smooth(field, pi);
}

double PinGap::pressure(const GapField& field, double theta) const {
  const double psi = field.opening;
  const double opposite = pi - theta;
  const double b = std::tan(psi / 2);
  const double s = std::tan(opposite / 2) / b;
  if (!(s > 1)) return s <= 1 ? 0 : s;
  const double cosine = std::cos(opposite);
  const double root = std::sqrt((s - 1) * (s + 1));
  const double z = 1 / (s + root);
  // The square root's amplitude at the edge is 0 by the equation; what the
  // series has of it is taken out.
  double sum = 0;
  double power = z;
  for (int k = 0; k < field.series.size(); ++k) {
    sum += (2 * k + 1) * field.series(k) * (power - z);
    power *= z * z;
  }
  // The gap's series has the factor b.
  const double singular = (1 + b * b * s * s) / (2 * root) * sum;
  const SignedContact& c = field.contact;
  return 1 - c.mean_deficit - cosine - singular + beta_ * field.mean_gap -
         (1 - beta_) * c.gap_shift * cosine + smooth(field, opposite);
}

}  // namespace contact::detail
