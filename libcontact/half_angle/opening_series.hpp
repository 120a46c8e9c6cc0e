#pragma once

#include <Eigen/Core>
#include <functional>

#include "libcontact/base/chebyshev_table.hpp"

namespace contact::detail {

/// Numbers of a contact that closes nearly all round, over psi = pi - theta0
/// in [0, largest], as Chebyshev series in ln(1 + psi/t): contacts change their
/// law where psi is of the order of t.
class OpeningSeries {
 public:
  using Row = std::function<Eigen::RowVectorXd(double opening)>;

  /// @param thickness  t > 0
  /// @param largest    psi > 0
  OpeningSeries(double thickness, double largest);

  /// @param count  of nodes, > 2
  /// @param row    the numbers at psi in (0, largest); called here only
  void tabulate(int count, const Row& row);

  Eigen::Index columns() const { return series_.columns(); }
  /// Whether the last coefficients of the first column are below 1e-8: what is
  /// cut off is as large.
  bool is_resolved() const { return series_.is_resolved(1e-8, 1, 3); }

  /// The first numbers at psi in [0, largest].
  Eigen::RowVectorXd at(double opening, Eigen::Index columns) const;

  struct Value {
    double value;
    double slope;  ///< over psi
  };
  Value first(double opening) const;

 private:
  double variable(double opening) const;  // [-1, 1]

  double thickness_;
  double range_;
  ChebyshevTable series_;
};

}  // namespace contact::detail
