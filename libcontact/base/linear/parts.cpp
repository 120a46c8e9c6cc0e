#include "libcontact/base/linear/parts.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace contact::detail {

Eigen::VectorXd singular_values(const Eigen::Ref<const Eigen::MatrixXd>& a) {
  return a.jacobiSvd().singularValues();
}

SymmetricParts symmetric_parts(const Eigen::Matrix3d& a) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace contact::detail
