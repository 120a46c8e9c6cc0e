#include "libcontact/conforming/gap/ball_gap.hpp"

#include <Eigen/Core>
#include <cmath>

#include "libcontact/base/constants.hpp"
#include "libcontact/base/gauss_legendre.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/conforming/gap/harmonic_fade.hpp"
#include "libcontact/conforming/gap/odd_bessel.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"

// Letters as in docs/explanation/preload.md: N = n + 1/2, Phi_n = ∫_0^psi phi
// sin(N f) df.
namespace contact::detail {
namespace {

BallConstants constants_of(const ElasticPair& pair) {
  return {pair.inner_compliance_share(), pair.inner().poissons_ratio,
          pair.outer_compliance_share(), pair.outer().poissons_ratio};
}

double homogeneous_compliance(const BallConstants& c, int n) {
  return c.inner_share * ball_compliance(n, c.inner_poisson) +
         c.outer_share * cavity_compliance(n, c.outer_poisson);
}

}  // namespace

BallGap::BallGap(const LayeredPair& pair, int unknowns)
    : constants_(constants_of(pair.surfaces())),
      unknowns_(unknowns == 0 ? gap_unknowns(pair) : unknowns),
      kernel_(BallKernel::of_gap(constants_)),
      galerkin_(
          LegendreGalerkin::table(unknowns_, LegendreGalerkin::Parity::odd)) {
  const WallHarmonics walls(JointKind::ball, pair);
  mean_ = walls.mean;
  first_ = walls.first;
  correction_ = walls.correction;
  if (correction_.empty()) return;
  // Change of e_n by the walls, over N.
  std::vector<double> change(correction_.size(), 0);
  for (int n = 2; n < static_cast<int>(change.size()); ++n) {
    const double order = n + 0.5;
    const double c = order * homogeneous_compliance(constants_, n);
    change[n] = -correction_[n] / (c * (c + order * correction_[n]));
  }
  wall_kernel_.emplace(change, pair.relative_thickness());
}

double BallGap::stiffness_rest(int n) const {
  const double wall =
      static_cast<std::size_t>(n) < correction_.size() ? correction_[n] : 0;
  return 1 / (homogeneous_compliance(constants_, n) + wall) - (n + 0.5);
}

double BallGap::rest_limit() const {
  // Second term of N s_n = 1 + (1 - 2 nu)^2/(2 (1 - nu) N) + ...; the cavity
  // has the other sign.
  const auto excess = [](double nu) {
    return (1 - 2 * nu) * (1 - 2 * nu) / (2 * (1 - nu));
  };
  return constants_.outer_share * excess(constants_.outer_poisson) -
         constants_.inner_share * excess(constants_.inner_poisson);
}

GapField BallGap::field(double psi) const {
  const int count = unknowns_;
  const Eigen::VectorXd x = psi * galerkin_.node;
  Eigen::VectorXd kappa(x.size());
  kernel_.evaluate({x.data(), static_cast<std::size_t>(x.size())},
                   {kappa.data(), static_cast<std::size_t>(x.size())});
  if (wall_kernel_) {
    for (Eigen::Index k = 0; k < x.size(); ++k)
      kappa(k) += (*wall_kernel_)(x(k));
  }
  kappa *= psi / pi;
  const Eigen::VectorXd packed = galerkin_.correlation * kappa;
  Eigen::MatrixXd matrix(count, count);
  for (int i = 0, row = 0; i < count; ++i) {
    for (int j = 0; j <= i; ++j, ++row) {
      matrix(i, j) = matrix(j, i) = packed(row);
    }
    matrix(i, i) += 2.0 / (4 * i + 3);
  }

  // Right sides, times 2/pi: of -Y, sin(f/2), and of X_1, sin(3f/2) -
  // 3 sin(f/2) = -4 sin^3(f/2); the third one is for moments alone, sin(3f/2).
  const auto given = [](double f) {
    const double s = std::sin(f / 2);
    return Eigen::RowVector3d(s, -4 * s * s * s, std::sin(3 * f / 2));
  };
  Eigen::MatrixXd values(galerkin_.projection_node.size(), 3);
  for (Eigen::Index k = 0; k < values.rows(); ++k) {
    values.row(k) = given(psi * galerkin_.projection_node(k));
  }
  const Eigen::MatrixXd projected = galerkin_.projection * values;
  const Eigen::MatrixXd right = 2 / pi * projected.leftCols<2>();
  const Eigen::MatrixXd u = solve_symmetric(matrix, right);
  // Edge values by the equation, not by the series: twice its order.
  const Eigen::RowVector2d at_edge =
      2 / pi * given(psi).head<2>() - (galerkin_.edge * kappa).transpose() * u;
  // Halves: the moments are over [0, psi].
  const Eigen::RowVector2d mean = psi / 2 * projected.col(0).transpose() * u;
  const Eigen::RowVector2d first = psi / 2 * projected.col(2).transpose() * u;

  // phi = u_2 - Y u_1, X_1 = 1.
  const double y = at_edge(1) / at_edge(0);
  const double phi0 = mean(1) - y * mean(0);
  const double phi1 = first(1) - y * first(0);
  const double k1 = 1.5 * (1 - phi1);
  const double k0_less_k1 = (y + phi0) / 2 + 1.5 * phi1;

  // As the shift grows at constant clearance: c_0 K_0 = Phi_0.
  const double rate =
      ((2 - mean_) * mean(1) - 3 * mean_) / (mean_ + (2 - mean_) * mean(0));
  const double phi1_rate = first(1) - rate * first(0);
  const double k1_rate = 1.5 * (1 - phi1_rate);

  const Eigen::VectorXd phi = u.col(1) - y * u.col(0);
  const double beyond = (phi0 - mean_ * k0_less_k1) / k1;
  return {{beyond - mean_, beyond, -k0_less_k1 / k1, phi1 / k1,
           phi1_rate / k1_rate},
          psi,
          phi0 / k1,
          phi / k1};
}

// Phi_n by the series.
void BallGap::moments(const GapField& field, std::span<double> out) const {
  Eigen::VectorXd bessel(field.series.size());
  for (std::size_t n = 0; n < out.size(); ++n) {
    odd_spherical_bessel((static_cast<double>(n) + 0.5) * field.opening,
                         bessel);
    double sum = 0;
    for (int j = 0; j < bessel.size(); ++j) {
      sum += (j % 2 == 0 ? 1 : -1) * bessel(j) * field.series(j);
    }
    out[n] = field.opening * sum;
  }
}

void BallGap::harmonics(const GapField& field, std::span<double> out) const {
  moments(field, out);
  if (!out.empty()) out[0] = 1 - field.contact.mean_deficit;
  if (out.size() > 1) out[1] = 1;
  for (std::size_t n = 2; n < out.size(); ++n) {
    // 1/c_n
    const int order = static_cast<int>(n);
    out[n] *= (order % 2 == 0 ? 1 : -1) * (stiffness_rest(order) + order + 0.5);
  }
}

// sum (1/c_n - N) Phi_n P_n(cos t'), n >= 2. Of a constant in the bracket the
// whole sum, n >= 0, is 0 beyond the gap.
double BallGap::smooth(const GapField& field, double opposite) const {
  const HarmonicFade fade(opposite - field.opening,
                          static_cast<int>(correction_.size()));
  std::vector<double> moment(static_cast<std::size_t>(fade.end()));
  moments(field, moment);
  const double limit = rest_limit();
  const double cosine = std::cos(opposite);
  double before = 1;
  double legendre = cosine;
  double sum = -limit * (moment[0] + moment[1] * cosine);
  for (int n = 2; n < fade.end(); ++n) {
    const double next =
        ((2 * n - 1) * cosine * legendre - (n - 1) * before) / n;
    before = legendre;
    legendre = next;
    sum += fade(n) * (stiffness_rest(n) - limit) *
           moment[static_cast<std::size_t>(n)] * legendre;
  }
  return sum;
}

double BallGap::centre(const GapField& field) const {
  const double psi = field.opening;
  // ∫ phi'/(2 cos(f/2)) df by parts.
  Eigen::VectorXd weight(galerkin_.projection_node.size());
  for (Eigen::Index k = 0; k < weight.size(); ++k) {
    const double f = psi * galerkin_.projection_node(k);
    const double c = std::cos(f / 2);
    weight(k) = std::sin(f / 2) / (4 * c * c);
  }
  const double by_parts =
      -psi / 2 * (galerkin_.projection * weight).dot(field.series);
  const SignedContact& c = field.contact;
  return 2 - c.mean_deficit + by_parts - field.mean_gap / 2 +
         1.5 * c.gap_shift + smooth(field, pi);
}

double BallGap::pressure(const GapField& field, double theta) const {
  // f = t' sin u makes the integral of phi'(f)/sqrt(2 (cos f - cos t'))
  // smooth up to the edge.
  static const GaussLegendre& gauss = *new GaussLegendre(64);
  const double psi = field.opening;
  const double opposite = pi - theta;
  if (!(opposite > psi)) return opposite <= psi ? 0 : opposite;
  const double largest = std::asin(psi / opposite);
  double integral = 0;
  for (int i = 0; i < gauss.node.size(); ++i) {
    const double u = largest * (1 + gauss.node(i)) / 2;
    const double f = opposite * std::sin(u);
    const double v = f / psi;
    // sum phi_j P_{2j+1}'(v): P_{m+1}' = P_{m-1}' + (2m + 1) P_m.
    double even = 1;
    double odd = v;
    double slope = 1;
    double sum = field.series(0);
    for (int j = 1; j < field.series.size(); ++j) {
      const double m = 2 * j;
      even = ((2 * m - 1) * v * odd - (m - 1) * even) / m;
      slope += (2 * m + 1) * even;
      odd = ((2 * m + 1) * v * even - m * odd) / (m + 1);
      sum += slope * field.series(j);
    }
    // sqrt(2 (cos f - cos t')), and t' - f without cancellation.
    const double half = std::sin((pi / 2 - u) / 2);
    const double rest = opposite * 2 * half * half;
    const double root =
        2 * std::sqrt(std::sin((opposite + f) / 2) * std::sin(rest / 2));
    integral += gauss.weight(i) * sum / root * std::cos(u);
  }
  integral *= largest / 2 * opposite / psi;

  const double cosine = std::cos(opposite);
  return 1 - field.contact.mean_deficit - cosine + integral -
         field.mean_gap / 2 - 1.5 * field.contact.gap_shift * cosine +
         smooth(field, opposite);
}

}  // namespace contact::detail
