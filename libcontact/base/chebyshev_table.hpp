#pragma once

#include <Eigen/Core>
#include <functional>

namespace contact::detail {

/// Functions of v in [-1, 1] as Chebyshev series, a column each. Evaluated by
/// Clenshaw's recurrence.
class ChebyshevTable {
 public:
  /// The functions at v = cos(2 h), h in (0, pi/2): cos^2 h and sin^2 h are how
  /// far v is from both ends, in halves, to full relative precision.
  using Row = std::function<Eigen::RowVectorXd(double half_phase)>;
  struct Tangent {
    double value, slope;  ///< over v
  };

  ChebyshevTable() = default;
  /// @param count  of nodes and terms
  /// @param row    called here only
  ChebyshevTable(int count, const Row& row);

  Eigen::Index columns() const { return coefficients_.cols(); }
  /// Whether the last coefficients of the first columns are below this, and the
  /// truncated terms with them.
  bool is_resolved(double negligible, Eigen::Index columns,
                   Eigen::Index last = 4) const;
  /// Leaves out terms at the end that are below this in all columns.
  void shorten(double negligible);
  /// Adds a constant to a function.
  void shift(Eigen::Index column, double by) { coefficients_(0, column) += by; }

  double value(Eigen::Index column, double v) const;
  Tangent tangent(Eigen::Index column, double v) const;
  /// The first functions side by side.
  Eigen::RowVectorXd values(Eigen::Index columns, double v) const;

 private:
  Eigen::MatrixXd coefficients_;  // a degree a row
};

}  // namespace contact::detail
