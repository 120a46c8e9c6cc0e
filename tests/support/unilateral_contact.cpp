#include "support/unilateral_contact.hpp"

#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace contact::test {
namespace {

constexpr double pi = std::numbers::pi;

// Radial displacement of the n-th harmonic of a normal pressure, in units of
// (4 rho/E) w_i; n = 1 is a rigid motion, whose size is of no influence.
double disc(int n, double nu) {
  const double k = (1 - 2 * nu) / (2 * (1 - nu));
  if (n == 0) return k;
  return n == 1 ? 0 : (n - k) / (n * n - 1.0);
}
double hole(int n, double nu) {
  const double k = (1 - 2 * nu) / (2 * (1 - nu));
  if (n == 0) return 1 - k;
  return n == 1 ? 0 : (n + k) / (n * n - 1.0);
}
double ball(int n, double nu) {
  if (n == 1) return 0;
  const double g = 2 * (1 - nu);
  return (g * n * n + nu * n - 1 + 2 * nu) /
         (g * (n - 1) * (n * n + n + 1 + nu * (2 * n + 1)));
}
double cavity(int n, double nu) {
  const double g = 2 * (1 - nu);
  return (g * n * n + (4 - 5 * nu) * n + 1 - nu) /
         (g * (n + 2) * (n * n + n + 1 - nu * (2 * n + 1)));
}

// Nodes, values of the harmonics at the nodes, and the way back: harmonics of
// nodal values.
struct Basis {
  Eigen::VectorXd theta;
  Eigen::MatrixXd synthesis;  // (node, harmonic)
  Eigen::MatrixXd analysis;   // (harmonic, node)
};

Basis cosines(int count) {
  Basis basis{Eigen::VectorXd(count), Eigen::MatrixXd(count, count), {}};
  for (int j = 0; j < count; ++j) {
    basis.theta(j) = pi * (j + 0.5) / count;
    for (int n = 0; n < count; ++n) {
      basis.synthesis(j, n) = std::cos(n * basis.theta(j));
    }
  }
  basis.analysis = basis.synthesis.transpose() * (2.0 / count);
  basis.analysis.row(0) /= 2;
  return basis;
}

Basis legendre(int count) {
  Basis basis{Eigen::VectorXd(count), Eigen::MatrixXd(count, count), {}};
  const auto zeros = boost::math::legendre_p_zeros<double>(count);
  std::vector<double> x;
  for (const double zero : zeros) {
    x.push_back(zero);
    if (zero != 0) x.push_back(-zero);
  }
  std::sort(x.rbegin(), x.rend());
  Eigen::VectorXd weight(count);
  for (int j = 0; j < count; ++j) {
    const double slope = boost::math::legendre_p_prime(count, x[j]);
    weight(j) = 2 / ((1 - x[j] * x[j]) * slope * slope);
    basis.theta(j) = std::acos(x[j]);
    double previous = 1;
    double current = x[j];
    for (int n = 0; n < count; ++n) {
      basis.synthesis(j, n) = previous;
      const double next =
          boost::math::legendre_next(n + 1, x[j], current, previous);
      previous = current;
      current = next;
    }
  }
  basis.analysis = basis.synthesis.transpose() * weight.asDiagonal();
  for (int n = 0; n < count; ++n) basis.analysis.row(n) *= n + 0.5;
  return basis;
}

// Displacement at theta, in units of (4 rho/E) w_1 load/rho or load/rho^2, by
// the uniform pressure about the pole theta = pi that balances a unit load.
// The terms fall as n^-2 (pin) and n^-2.5 (ball) and change their signs:
// summed far enough not to add to the error of the nodes.
double back_displacement(JointKind kind, double nu, double psi, double theta) {
  constexpr int terms = 4000;
  const double c = std::cos(psi);
  const double x = std::cos(theta);
  double sum = 0;
  double sign = 1;
  if (kind == JointKind::pin) {
    sum = psi / (2 * pi * std::sin(psi)) * disc(0, nu);
    for (int n = 1; n < terms; ++n) {
      sign = -sign;
      sum += sign * std::sin(n * psi) / (n * pi * std::sin(psi)) * disc(n, nu) *
             std::cos(n * theta);
    }
    return sum;
  }
  // P_{n-1}, P_n, P_{n+1} at c; P_n, P_{n+1} at x.
  double lower = 1;
  double middle = 1;
  double upper = c;
  double value = 1;
  double next_value = x;
  for (int n = 0; n < terms; ++n) {
    sum +=
        sign * (lower - upper) / (2 * pi * (1 - c * c)) * ball(n, nu) * value;
    sign = -sign;
    lower = middle;
    middle = upper;
    upper = boost::math::legendre_next(n + 1, c, middle, lower);
    const double following =
        boost::math::legendre_next(n + 1, x, next_value, value);
    value = next_value;
    next_value = following;
  }
  return sum;
}

}  // namespace

UnilateralContact solve_unilateral(JointKind kind, const ElasticPair& pair,
                                   double load_parameter, int nodes,
                                   double patch_half_angle) {
  const bool is_pin = kind == JointKind::pin;
  const Basis basis = is_pin ? cosines(nodes) : legendre(nodes);
  const double w1 = pair.inner_compliance_share();
  const double w2 = pair.outer_compliance_share();
  const double nu1 = pair.inner().poissons_ratio;
  const double nu2 = pair.outer().poissons_ratio;
  Eigen::VectorXd inner(nodes);
  Eigen::VectorXd outer(nodes);
  for (int n = 0; n < nodes; ++n) {
    inner(n) = w1 * (is_pin ? disc(n, nu1) : ball(n, nu1));
    outer(n) = w2 * (is_pin ? hole(n, nu2) : cavity(n, nu2));
  }
  // p is in units of load/rho or load/rho^2, displacements in units of the
  // clearance: (4 rho/E) p_n becomes `factor` p_n.
  const double factor =
      is_pin ? 2 * pi * load_parameter : 8 * load_parameter / 3;
  const Eigen::MatrixXd compliance =
      factor * basis.synthesis * (inner + outer).asDiagonal() * basis.analysis;
  Eigen::VectorXd back = Eigen::VectorXd::Zero(nodes);
  if (patch_half_angle >= 0) {
    for (int j = 0; j < nodes; ++j) {
      back(j) = factor * w1 *
                back_displacement(kind, nu1, patch_half_angle, basis.theta(j));
    }
  }
  // Resultant: pin 2 ∫ p cos t dt = pi p_1, ball 2 pi ∫ p cos t sin t dt =
  // (4 pi/3) p_1.
  const Eigen::RowVectorXd resultant =
      basis.analysis.row(1) * (is_pin ? pi : 4 * pi / 3);
  const Eigen::VectorXd cosine = basis.theta.array().cos();

  // gap = 1 - D cos t + compliance p + back. Active set: solve with gap = 0
  // on it and the load given, then drop nodes in tension and add nodes that
  // overlap, until nothing changes.
  UnilateralContact result;
  result.theta = basis.theta;
  std::vector<bool> active(nodes);
  for (int j = 0; j < nodes; ++j) active[j] = basis.theta(j) < pi / 2;
  result.converged = false;
  for (result.iterations = 1; result.iterations <= 100; ++result.iterations) {
    std::vector<int> index;
    for (int j = 0; j < nodes; ++j) {
      if (active[j]) index.push_back(j);
    }
    const int m = static_cast<int>(index.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(m + 1, m + 1);
    Eigen::VectorXd right(m + 1);
    system.topLeftCorner(m, m) = compliance(index, index);
    system.topRightCorner(m, 1) = -cosine(index);
    system.bottomLeftCorner(1, m) = resultant(index);
    right.head(m) = -Eigen::VectorXd::Ones(m) - back(index);
    right(m) = 1;
    const Eigen::VectorXd solution = system.partialPivLu().solve(right);
    result.pressure = Eigen::VectorXd::Zero(nodes);
    result.pressure(index) = solution.head(m);
    result.gap = Eigen::VectorXd::Ones(nodes) - solution(m) * cosine +
                 compliance * result.pressure + back;
    std::vector<bool> next(nodes);
    for (int j = 0; j < nodes; ++j) {
      next[j] = active[j] ? result.pressure(j) > 0 : result.gap(j) < 0;
    }
    if (next == active) {
      result.converged = true;
      const int last = index.back();
      const double a = std::pow(result.pressure(last - 1), 2);
      const double b = std::pow(result.pressure(last), 2);
      result.half_angle =
          basis.theta(last) +
          b / (a - b) * (basis.theta(last) - basis.theta(last - 1));
      return result;
    }
    active = next;
  }
  return result;
}

}  // namespace contact::test
