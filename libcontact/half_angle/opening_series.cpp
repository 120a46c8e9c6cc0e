#include "libcontact/half_angle/opening_series.hpp"

#include <cmath>

namespace contact::detail {

OpeningSeries::OpeningSeries(double thickness, double largest)
    : thickness_(thickness), range_(std::log1p(largest / thickness)) {}

void OpeningSeries::tabulate(int count, const Row& row) {
  series_ = {count, [&](double half_phase) {
               const double cosine = std::cos(half_phase);
               return row(thickness_ * std::expm1(range_ * cosine * cosine));
             }};
}

double OpeningSeries::variable(double opening) const {
  return 2 * std::log1p(opening / thickness_) / range_ - 1;
}

Eigen::RowVectorXd OpeningSeries::at(double opening,
                                     Eigen::Index columns) const {
  return series_.values(columns, variable(opening));
}

OpeningSeries::Value OpeningSeries::first(double opening) const {
  const auto [value, slope] = series_.tangent(0, variable(opening));
  return {value, slope * 2 / (range_ * (thickness_ + opening))};
}

}  // namespace contact::detail
