#include "libcontact/base/linear/solve.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <utility>

namespace contact::detail {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Ref;
using Eigen::Vector3d;

void factor_positive(Ref<MatrixXd> a) {
  const Eigen::LLT<Ref<MatrixXd>> in_place(a);
}

void solve_lower(const Ref<const MatrixXd>& l, Ref<MatrixXd> b) {
  l.triangularView<Eigen::Lower>().solveInPlace(b);
}

void solve_factored(const Ref<const MatrixXd>& l, Ref<MatrixXd> b) {
  const auto lower = l.triangularView<Eigen::Lower>();
  if (b.cols() == 1) {  // allocates nothing
    auto column = b.col(0);
    lower.solveInPlace(column);
    lower.adjoint().solveInPlace(column);
  } else {
    lower.solveInPlace(b);
    lower.adjoint().solveInPlace(b);
  }
}

MatrixXd solve_positive(MatrixXd a, MatrixXd b) {
  factor_positive(a);
  solve_factored(a, b);
  return b;
}

MatrixXd inverse_of_positive(MatrixXd a) {
  const Eigen::Index size = a.rows();
  return solve_positive(std::move(a), MatrixXd::Identity(size, size));
}

Vector3d solve_positive(const Matrix3d& a, const Vector3d& b) {
  return a.llt().solve(b);
}

Matrix3d inverse_of_positive(const Matrix3d& a) {
  return a.llt().solve(Matrix3d::Identity());
}

bool is_positive(const Matrix3d& a) { return a.llt().info() == Eigen::Success; }

MatrixXd solve_symmetric(const Ref<const MatrixXd>& a,
                         const Ref<const MatrixXd>& b) {
  return a.ldlt().solve(b);
}

void solve_in_place(Ref<MatrixXd> a, Ref<MatrixXd> b) {
  const Eigen::PartialPivLU<Ref<MatrixXd>> factors(a);
  b = factors.solve(b).eval();
}

MatrixXd solve_square(MatrixXd a, MatrixXd b) {
  solve_in_place(a, b);
  return b;
}

MatrixXd solve_least_squares(const Ref<const MatrixXd>& a,
                             const Ref<const MatrixXd>& b) {
  return a.colPivHouseholderQr().solve(b);
}

}  // namespace contact::detail
