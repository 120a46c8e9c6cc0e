#pragma once

#include <Eigen/Core>

namespace contact::detail {

/// Everything of the Legendre-Galerkin method for a difference kernel that
/// does not depend on the kernel: for even u = sum u_j P_{2j}(v), or odd
/// u = sum u_j P_{2j+1}(v),
///
///     ∬ P_{2i}(v) P_{2j}(w) k(v - w) dv dw = ∫_0^2 C_ij(x) k(x) dx,  k even,
///     C_ij(x) = ∫_{-1}^{1-x} P_{2i}(v) P_{2j}(v+x) + P_{2j}(v) P_{2i}(v+x) dv
///
/// over [-1, 1], as sums over one set of nodes x. With x = 2 y^3 and Gauss's
/// rule in y they take kernels with a logarithm at x = 0 to 1e-13.
struct LegendreGalerkin {
  enum class Parity { even, odd };
  /// The table for a number of unknowns in [4, max_unknowns]; made at the
  /// first call, kept for the life of the program. Any thread.
  static const LegendreGalerkin& table(int unknowns,
                                       Parity parity = Parity::even);
  static constexpr int max_unknowns = 64;
  static constexpr int max_nodes = 6 * max_unknowns + 16;
  static constexpr int max_projection_nodes = max_unknowns + 12;

  LegendreGalerkin(int unknowns, Parity parity);

  Eigen::VectorXd node;  ///< x
  /// (i (i+1)/2 + j, node), j <= i
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>
      correlation;
  Eigen::MatrixXd edge;  ///< (i, node): ∫ P_{2i}(v) k(1 - v) dv
  /// @name Of even functions only
  /// @{
  /// Legendre coefficients of ((1 - v^2)^2/4) ln(1 - v^2).
  Eigen::VectorXd edge_term;
  Eigen::MatrixXd slope;  ///< even_legendre_slope()
  /// @}
  Eigen::VectorXd projection_node;
  Eigen::MatrixXd projection;  ///< (i, projection node): ∫ P_{2i} g dv
};

}  // namespace contact::detail
