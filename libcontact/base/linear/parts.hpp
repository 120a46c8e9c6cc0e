#pragma once

#include <Eigen/Core>

namespace contact::detail {

// More of Eigen's decompositions, compiled once.

/// From the largest one on.
Eigen::VectorXd singular_values(const Eigen::Ref<const Eigen::MatrixXd>& a);

/// Eigenvalues of a symmetric matrix in ascending order, and their unit
/// eigenvectors in columns.
struct SymmetricParts {
  Eigen::Vector3d values;
  Eigen::Matrix3d vectors;
};
SymmetricParts symmetric_parts(const Eigen::Matrix3d& a);

}  // namespace contact::detail
