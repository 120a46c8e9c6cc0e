#include "libcontact/conforming/legendre_galerkin.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>

#include "libcontact/base/gauss_legendre.hpp"

namespace contact::detail {

const LegendreGalerkin& LegendreGalerkin::table(int unknowns, Parity parity) {
  using Tables =
      std::array<std::unique_ptr<LegendreGalerkin>, max_unknowns + 1>;
  static std::mutex mutex;
  static Tables& even = *new Tables;
  static Tables& odd = *new Tables;
  const std::lock_guard lock(mutex);
  auto& entry = (parity == Parity::odd ? odd : even)[unknowns];
  if (!entry) entry = std::make_unique<LegendreGalerkin>(unknowns, parity);
  return *entry;
}

LegendreGalerkin::LegendreGalerkin(int n, Parity parity) {
  const bool is_odd = parity == Parity::odd;
  const auto legendre = is_odd ? odd_legendre : even_legendre;
  // C_ij is a polynomial of degree 4 n - 3 (odd: 4 n - 1) in x, 12 n - 9
  // (12 n - 3) in y.
  const int nodes = 6 * n + 16;
  const GaussLegendre outer(nodes);
  const GaussLegendre inner(2 * n);
  // dx = 6 y^2 dy
  const Eigen::ArrayXd y = (1 + outer.node.array()) / 2;
  const Eigen::VectorXd weight = 3 * y.square() * outer.weight.array();
  node = 2 * y.cube();
  edge.noalias() = legendre(n, (1 - node.array()).matrix()).transpose() *
                   weight.asDiagonal();
  correlation.resize(n * (n + 1) / 2, nodes);
  for (int m = 0; m < nodes; ++m) {
    // v + x at a node is -v at its mirror image, where odd ones change sign.
    const double half_length = 1 - node(m) / 2;
    const Eigen::MatrixXd left =
        legendre(n, (half_length * (1 + inner.node.array()) - 1).matrix());
    const Eigen::MatrixXd right =
        ((is_odd ? -2 : 2) * half_length * weight(m) * inner.weight)
            .asDiagonal() *
        left.colwise().reverse();
    for (int i = 0; i < n; ++i) {
      correlation.col(m).segment(i * (i + 1) / 2, i + 1).noalias() =
          right.leftCols(i + 1).transpose() * left.col(i);
    }
  }

  // Half of a rule, the products being even: smooth right sides need few more
  // nodes than the polynomials.
  const int half = n + 12;
  const GaussLegendre rule(2 * half);
  projection_node = rule.node.tail(half);
  projection.noalias() = legendre(n, projection_node).transpose() *
                         (2 * rule.weight.tail(half)).asDiagonal();
  if (is_odd) return;

  // 128 nodes integrate the logarithm to 1e-12, up to 32 unknowns.
  const GaussLegendre fine(std::max(128, 4 * n));
  const Eigen::ArrayXd rest = (1 - fine.node.array()) * (1 + fine.node.array());
  edge_term = even_legendre(n, fine.node).transpose() *
              (fine.weight.array() * rest.square() / 4 * rest.log()).matrix();
  for (int i = 0; i < n; ++i) edge_term(i) *= 2 * i + 0.5;

  slope = even_legendre_slope(n);
}

}  // namespace contact::detail
