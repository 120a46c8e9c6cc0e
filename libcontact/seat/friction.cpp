#include "libcontact/seat/friction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contact::detail {
namespace {

constexpr double pi = std::numbers::pi;

// N_nm(cos v), (n, m). Where sin^m v is below the doubles N_nm is too, for
// these degrees.
void legendre(double cosine, double sine, const Eigen::MatrixXd& ratio,
              Eigen::MatrixXd& n_m) {
  const int degrees = static_cast<int>(n_m.rows()) - 1;
  n_m(0, 0) = std::sqrt(0.5);
  for (int m = 0; m <= degrees; ++m) {
    if (m > 0) {
      n_m(m, m) = std::sqrt((2 * m + 1) / (2.0 * m)) * sine * n_m(m - 1, m - 1);
    }
    double before = 0;
    for (int n = m; n < degrees; ++n) {
      n_m(n + 1, m) =
          (cosine * n_m(n, m) - ratio(n, m) * before) / ratio(n + 1, m);
      before = n_m(n, m);
    }
  }
}

// lambda_n of Phi for even n, kappa_n of Xi for odd ones.
Eigen::VectorXd factors(int degrees) {
  Eigen::VectorXd factor(degrees);
  double even = 1;   // (n - 1)!!/n!!
  double odd = 0.5;  // (n - 2)!!/(n + 1)!!
  for (int n = 0; n < degrees; ++n) {
    if (n % 2 == 0) {
      if (n > 0) even *= (n - 1.0) / n;
      factor(n) = -2 * pi * pi * even * even / ((n - 1.0) * (n + 2));
    } else {
      if (n > 1) odd *= (n - 2.0) / (n + 1);
      factor(n) = 2 * pi * pi * odd * odd;
    }
  }
  return factor;
}

// Value and gradient on the sphere, e_theta and e_phi, of
// sum c_nm N_nm cos(m phi).
Eigen::Vector3d expand(const Eigen::MatrixXd& c, const Eigen::MatrixXd& n_m,
                       int first, const Eigen::ArrayXd& cosine,
                       const Eigen::ArrayXd& sine) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int n = first; n < c.rows(); n += 2) {
    sum(0) += c(n, 0) * n_m(n, 0);
    sum(1) -= c(n, 0) * std::sqrt(n * (n + 1.0)) * n_m(n, 1);
    for (int m = 1; m <= n; ++m) {
      const double up = std::sqrt((n - m) * (n + m + 1.0));
      const double down = std::sqrt((n + m) * (n - m + 1.0));
      const double slope = (down * n_m(n, m - 1) - up * n_m(n, m + 1)) / 2;
      // m N_nm/sin v, finite at the poles.
      const double over_sine =
          std::sqrt((2 * n + 1.0) / (2 * n - 1.0)) *
          (std::sqrt((n + m) * (n + m - 1.0)) * n_m(n - 1, m - 1) +
           std::sqrt((n - m) * (n - m - 1.0)) * n_m(n - 1, m + 1)) /
          2;
      sum += c(n, m) * Eigen::Vector3d(n_m(n, m) * cosine(m), slope * cosine(m),
                                       -over_sine * sine(m));
    }
  }
  return sum;
}

// p = sum a_im cos(m phi) in each cell, (i, m).
Eigen::MatrixXd by_order(const Eigen::MatrixXd& pressure) {
  const int last = static_cast<int>(pressure.cols()) - 1;
  Eigen::MatrixXd transform(last + 1, last + 1);
  for (int j = 0; j <= last; ++j) {
    for (int m = 0; m <= last; ++m) {
      const double ends =
          (j == 0 || j == last ? 0.5 : 1) * (m == 0 || m == last ? 0.5 : 1);
      transform(j, m) =
          2.0 / last * ends * std::cos(pi * ((j * m) % (2 * last)) / last);
    }
  }
  return pressure * transform;
}

}  // namespace

SeatHarmonics::SeatHarmonics(const SeatSolution& solution, double unit_force,
                             int degrees)
    : degrees_(degrees), ratio_(degrees + 1, degrees + 1) {
  for (int m = 0; m <= degrees; ++m) {
    for (int n = 0; n <= degrees; ++n) {
      ratio_(n, m) = std::sqrt(
          std::abs((n - m) * (n + m) / ((2.0 * n - 1) * (2 * n + 1))));
    }
  }
  const SeatCells::Rule rule = solution.solver->cells().rule(degrees);
  const Eigen::MatrixXd orders = by_order(solution.patch.pressure);
  const auto most = std::min<Eigen::Index>(degrees, orders.cols());
  Eigen::MatrixXd n_m = Eigen::MatrixXd::Zero(degrees + 1, degrees + 1);
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(degrees, degrees);
  for (Eigen::Index k = 0; k < rule.angle.size(); ++k) {
    legendre(std::cos(rule.angle(k)), std::sin(rule.angle(k)), ratio_, n_m);
    for (Eigen::Index m = 0; m < most; ++m) {
      q.col(m).tail(degrees - m) += rule.weight(k) * orders(rule.cell(k), m) *
                                    n_m.col(m).segment(m, degrees - m);
    }
  }
  const Eigen::VectorXd factor = factors(degrees) * unit_force;
  harmonics_ = factor.asDiagonal() * q;
}

SeatSlip SeatHarmonics::operator()(const Eigen::Vector3d& axis) const {
  const double across = std::hypot(axis.x(), axis.y());
  const double phi = across > 0 ? std::atan2(axis.y(), axis.x()) : 0;
  const Eigen::ArrayXd angles =
      Eigen::ArrayXd::LinSpaced(degrees_, 0, (degrees_ - 1) * phi);
  const Eigen::ArrayXd cosine = angles.cos(), sine = angles.sin();
  Eigen::MatrixXd n_m = Eigen::MatrixXd::Zero(degrees_ + 1, degrees_ + 1);
  legendre(axis.z(), across, ratio_, n_m);
  const Eigen::Vector3d power = expand(harmonics_, n_m, 0, cosine, sine);
  const Eigen::Vector3d angle = expand(harmonics_, n_m, 1, cosine, sine);
  const Eigen::Vector3d e_theta(axis.z() * std::cos(phi),
                                axis.z() * std::sin(phi), -across);
  const Eigen::Vector3d e_phi(-std::sin(phi), std::cos(phi), 0);
  // w x e_theta = e_phi, w x e_phi = -e_theta.
  return {angle(1) * e_phi - angle(2) * e_theta,
          power(0) * axis + power(1) * e_theta + power(2) * e_phi};
}

}  // namespace contact::detail
