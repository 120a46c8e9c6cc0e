#include "libcontact/base/chebyshev_table.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace contact::detail {

ChebyshevTable::ChebyshevTable(int count, const Row& row) {
  using std::numbers::pi;
  std::vector<double> cosine(4 * count);  // cos(m pi/(2 count))
  for (int m = 0; m < 4 * count; ++m) cosine[m] = std::cos(pi / 2 * m / count);
  for (int i = 0; i < count; ++i) {
    const Eigen::RowVectorXd values = row(pi / 2 * (i + 0.5) / count);
    if (i == 0) coefficients_.setZero(count, values.size());
    // Discrete orthogonality: T_k at the node is the cosine of k of its angles.
    for (int k = 0; k < count; ++k) {
      coefficients_.row(k) += (k == 0 ? 1.0 : 2.0) / count *
                              cosine[k * (2 * i + 1) % (4 * count)] * values;
    }
  }
}

bool ChebyshevTable::is_resolved(double negligible, Eigen::Index columns,
                                 Eigen::Index last) const {
  return (coefficients_.bottomLeftCorner(last, columns).array().abs() <
          negligible)
      .all();
}

void ChebyshevTable::shorten(double negligible) {
  Eigen::Index terms = coefficients_.rows();
  while (coefficients_.row(terms - 1).cwiseAbs().maxCoeff() < negligible) {
    --terms;
  }
  coefficients_.conservativeResize(terms, Eigen::NoChange);
}

double ChebyshevTable::value(Eigen::Index column, double v) const {
  const double* const c = coefficients_.col(column).data();
  double b0 = 0, b1 = 0;
  for (Eigen::Index k = coefficients_.rows() - 1; k > 0; --k) {
    b1 = c[k] + 2 * v * b0 - b1;
    std::swap(b0, b1);
  }
  return c[0] + v * b0 - b1;
}

ChebyshevTable::Tangent ChebyshevTable::tangent(Eigen::Index column,
                                                double v) const {
  const double* const c = coefficients_.col(column).data();
  double b0 = 0, b1 = 0, d0 = 0, d1 = 0;
  for (Eigen::Index k = coefficients_.rows() - 1; k > 0; --k) {
    const double d = 2 * b0 + 2 * v * d0 - d1;
    d1 = d0;
    d0 = d;
    const double b = c[k] + 2 * v * b0 - b1;
    b1 = b0;
    b0 = b;
  }
  return {c[0] + v * b0 - b1, b0 + v * d0 - d1};
}

Eigen::RowVectorXd ChebyshevTable::values(Eigen::Index columns,
                                          double v) const {
  Eigen::RowVectorXd b0 = Eigen::RowVectorXd::Zero(columns);
  Eigen::RowVectorXd b1 = b0;
  for (Eigen::Index k = coefficients_.rows() - 1; k > 0; --k) {
    b1 = 2 * v * b0 - b1 + coefficients_.row(k).head(columns);
    b0.swap(b1);
  }
  return v * b0 - b1 + coefficients_.row(0).head(columns);
}

}  // namespace contact::detail
