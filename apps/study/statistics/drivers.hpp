#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

/// Drivers of a number: rank correlation, regression, Sobol' indices.
namespace study {

/// Ranks from 1; equal numbers share theirs. NaN has rank NaN and none counts
/// it.
std::vector<double> ranks(std::span<const double> values);

/// Correlation of two columns where both are numbers; NaN where either does
/// not vary. Of ranks it is Spearman's.
double correlation(std::span<const double> a, std::span<const double> b);

/// Sums of a linear regression, a row at a time.
class Regression {
 public:
  explicit Regression(std::size_t inputs);
  /// Rows with a NaN are left out.
  void add(std::span<const double> inputs, double output);

  struct Answer {
    /// Change of the output, in its deviations, by one deviation of an input;
    /// 0 of an input that does not vary.
    std::vector<double> standardised;
    /// Share of the variance that they explain, R^2.
    double explained;
  };
  /// NaN where the output does not vary or rows are too few.
  Answer solve() const;

 private:
  Eigen::VectorXd origin_;  ///< the first row, so that sums lose no digits
  Eigen::VectorXd sums_;
  Eigen::MatrixXd products_;
  double count_ = 0;
};

/// Share of the variance by one source alone, and by all that it is part of,
/// each with its standard error.
struct SobolIndex {
  double first;
  double first_error;
  double total;
  double total_error;
};

/// Indices from the outputs of Saltelli's design, groups of A, B and A with a
/// column of B for each source: the estimators of
/// libcontact/docs/reference/references.md#saltelli-2010 and
/// libcontact/docs/reference/references.md#jansen-1999. Errors are from the
/// spread of the shifts, which take turns with the groups: as a root of mean
/// squares 0.8 to 1.3 times the true error
/// (Drivers.SobolErrorsAreAsLargeAsTheySay). Groups with a NaN are left out.
std::vector<SobolIndex> sobol_indices(std::span<const double> outputs,
                                      std::size_t sources, std::size_t shifts);

}  // namespace study
