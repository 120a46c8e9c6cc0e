#include "libcontact/conforming/legendre_galerkin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>

#include "libcontact/base/gauss_legendre.hpp"

namespace contact::detail {

const LegendreGalerkin& LegendreGalerkin::table(int unknowns) {
  static std::mutex mutex;
  static std::array<std::unique_ptr<LegendreGalerkin>, max_unknowns + 1> tables;
  const std::lock_guard lock(mutex);
  auto& entry = tables[unknowns];
  if (!entry) entry = std::make_unique<LegendreGalerkin>(unknowns);
  return *entry;
}

LegendreGalerkin::LegendreGalerkin(int n) {
  // C_ij is a polynomial of degree 4 n - 3 in x, 12 n - 9 in y.
  const int nodes = 6 * n + 16;
  const GaussLegendre outer(nodes);
  const GaussLegendre inner(2 * n);
  node.resize(nodes);
  correlation.resize(n * (n + 1) / 2, nodes);
  edge.resize(n, nodes);
  Eigen::MatrixXd left(n, inner.node.size());
  Eigen::MatrixXd right(n, inner.node.size());
  for (int m = 0; m < nodes; ++m) {
    const double y = (1 + outer.node(m)) / 2;
    const double x = 2 * y * y * y;
    const double weight = 3 * y * y * outer.weight(m);  // dx = 6 y^2 dy
    node(m) = x;
    edge.col(m) = weight * even_legendre(n, 1 - x);
    const double half_length = 1 - x / 2;
    for (int k = 0; k < inner.node.size(); ++k) {
      const double v = -1 + half_length * (1 + inner.node(k));
      left.col(k) =
          half_length * inner.weight(k) * weight * even_legendre(n, v);
      right.col(k) = even_legendre(n, v + x);
    }
    const Eigen::MatrixXd product = left * right.transpose();
    for (int i = 0, row = 0; i < n; ++i) {
      for (int j = 0; j <= i; ++j, ++row) {
        correlation(row, m) = product(i, j) + product(j, i);
      }
    }
  }

  // 128 nodes integrate the logarithm to 1e-12, up to 32 unknowns.
  const GaussLegendre fine(std::max(128, 4 * n));
  edge_term = Eigen::VectorXd::Zero(n);
  for (int k = 0; k < fine.node.size(); ++k) {
    const double rest = (1 - fine.node(k)) * (1 + fine.node(k));
    edge_term += fine.weight(k) * rest * rest / 4 * std::log(rest) *
                 even_legendre(n, fine.node(k));
  }
  for (int i = 0; i < n; ++i) edge_term(i) *= 2 * i + 0.5;

  // Half of a rule for even functions: smooth right sides need few more
  // nodes than the polynomials.
  const int half = n + 12;
  const GaussLegendre rule(2 * half);
  projection_node = rule.node.tail(half);
  projection.resize(n, half);
  for (int k = 0; k < half; ++k) {
    projection.col(k) =
        2 * rule.weight(half + k) * even_legendre(n, projection_node(k));
  }
}

}  // namespace contact::detail
