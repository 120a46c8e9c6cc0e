#include "libcontact/half_angle/opening_series.hpp"

#include <cmath>
#include <numbers>

namespace contact::detail {

OpeningSeries::OpeningSeries(double thickness, double largest)
    : thickness_(thickness), range_(std::log1p(largest / thickness)) {}

void OpeningSeries::tabulate(int count, const Row& row) {
  Eigen::MatrixXd values;
  Eigen::MatrixXd chebyshev(count, count);
  for (int i = 0; i < count; ++i) {
    const double phi = std::numbers::pi * (i + 0.5) / count;
    const double cosine = std::cos(phi / 2);
    const Eigen::RowVectorXd at =
        row(thickness_ * std::expm1(range_ * cosine * cosine));
    if (i == 0) values.resize(count, at.size());
    values.row(i) = at;
    for (int k = 0; k < count; ++k) {
      chebyshev(k, i) = (k == 0 ? 1.0 : 2.0) / count * std::cos(k * phi);
    }
  }
  coefficients_ = chebyshev * values;
}

bool OpeningSeries::is_resolved() const {
  constexpr double negligible = 1e-8;
  return (coefficients_.col(0).tail(3).array().abs() < negligible).all();
}

double OpeningSeries::variable(double opening) const {
  return 2 * std::log1p(opening / thickness_) / range_ - 1;
}

Eigen::RowVectorXd OpeningSeries::at(double opening,
                                     Eigen::Index columns) const {
  const double v = variable(opening);
  Eigen::RowVectorXd b0 = Eigen::RowVectorXd::Zero(columns);
  Eigen::RowVectorXd b1 = b0;
  for (Eigen::Index k = coefficients_.rows() - 1; k > 0; --k) {
    b1 = 2 * v * b0 - b1 + coefficients_.row(k).head(columns);
    b0.swap(b1);
  }
  return v * b0 - b1 + coefficients_.row(0).head(columns);
}

OpeningSeries::Value OpeningSeries::first(double opening) const {
  const double v = variable(opening);
  double b0 = 0, b1 = 0, d0 = 0, d1 = 0;
  for (Eigen::Index k = coefficients_.rows() - 1; k > 0; --k) {
    const double d = 2 * b0 + 2 * v * d0 - d1;
    d1 = d0;
    d0 = d;
    const double b = coefficients_(k, 0) + 2 * v * b0 - b1;
    b1 = b0;
    b0 = b;
  }
  const double slope = b0 + v * d0 - d1;
  return {coefficients_(0, 0) + v * b0 - b1,
          slope * 2 / (range_ * (thickness_ + opening))};
}

}  // namespace contact::detail
