#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

/// Drivers of a number: rank correlation, regression, Sobol' indices.
namespace study {

/// Ranks from 1; equal numbers have equal ranks. NaN has rank NaN and is not
/// counted.
std::vector<double> ranks(std::span<const double> values);

/// Correlation of two columns over the rows where both are numbers; NaN if one
/// of them does not vary. Applied to ranks it is Spearman's.
double correlation(std::span<const double> a, std::span<const double> b);

/// Accumulates a linear regression row by row.
class Regression {
 public:
  explicit Regression(std::size_t inputs);
  /// Ignores rows with a NaN.
  void add(std::span<const double> inputs, double output);

  struct Answer {
    /// Change of the output, in its standard deviations, for one standard
    /// deviation of each input; 0 for an input that does not vary.
    std::vector<double> standardised;
    /// Share of the variance explained by the inputs, R^2.
    double explained;
  };
  /// NaN if the output does not vary or there are too few rows.
  Answer solve() const;

 private:
  Eigen::VectorXd origin_;  ///< the first row, subtracted to avoid cancellation
  Eigen::VectorXd sums_;
  Eigen::MatrixXd products_;
  double count_ = 0;
};

/// Share of the variance caused by one source alone, and by all interactions
/// that include it, each with its standard error.
struct SobolIndex {
  double first;
  double first_error;
  double total;
  double total_error;
};

/// Indices from the outputs of Saltelli's design, groups of A, B and A with a
/// column of B for each source, by the estimators of
/// libcontact/docs/reference/references.md#saltelli-2010 and
/// libcontact/docs/reference/references.md#jansen-1999. Standard errors follow
/// from the scatter between the shifts, which alternate over the groups; their
/// root mean square is 0.8 to 1.3 times the true error
/// (Drivers.SobolErrorsAreAsLargeAsTheySay). Groups with a NaN are ignored.
std::vector<SobolIndex> sobol_indices(std::span<const double> outputs,
                                      std::size_t sources, std::size_t shifts);

}  // namespace study
