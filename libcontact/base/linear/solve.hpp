#pragma once

#include <Eigen/Core>

namespace contact::detail {

// Eigen's decompositions, compiled once: each costs a source 2 to 7 s. Matrices
// without an inverse give infinities and NaN, or what solve_least_squares says.

/// Cholesky's L of A = L L^T in its lower triangle. Reads only this triangle of
/// A.
void factor_positive(Eigen::Ref<Eigen::MatrixXd> a);

/// X of L X = B in the place of B.
void solve_lower(const Eigen::Ref<const Eigen::MatrixXd>& l,
                 Eigen::Ref<Eigen::MatrixXd> b);

/// X of L L^T X = B in the place of B.
void solve_factored(const Eigen::Ref<const Eigen::MatrixXd>& l,
                    Eigen::Ref<Eigen::MatrixXd> b);

/// X of A X = B, A symmetric and positive definite.
Eigen::MatrixXd solve_positive(Eigen::MatrixXd a, Eigen::MatrixXd b);
Eigen::MatrixXd inverse_of_positive(Eigen::MatrixXd a);

/// The same of three rows, which allocates nothing.
Eigen::Vector3d solve_positive(const Eigen::Matrix3d& a,
                               const Eigen::Vector3d& b);
Eigen::Matrix3d inverse_of_positive(const Eigen::Matrix3d& a);
bool is_positive(const Eigen::Matrix3d& a);

/// X of A X = B, A symmetric: L D L^T with pivots.
Eigen::MatrixXd solve_symmetric(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                const Eigen::Ref<const Eigen::MatrixXd>& b);

/// X of A X = B, A square: L U with pivots in a row. The first one needs no
/// copies: A becomes its factors, and B becomes X.
void solve_in_place(Eigen::Ref<Eigen::MatrixXd> a,
                    Eigen::Ref<Eigen::MatrixXd> b);
Eigen::MatrixXd solve_square(Eigen::MatrixXd a, Eigen::MatrixXd b);

/// X with the least |A X - B|, 0 for unknowns that A cannot tell from others:
/// Q R with pivots.
Eigen::MatrixXd solve_least_squares(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                    const Eigen::Ref<const Eigen::MatrixXd>& b);

}  // namespace contact::detail
