#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace contact::test {

/// |computed - expected| / |expected|, computed in Real. If the expected value
/// is 0, only 0 is correct; NaN is never correct. Both faults give infinity.
template <class Real>
double relative_error(const Real& computed, const Real& expected) {
  if (computed == expected) return 0;
  Real difference = computed - expected;
  if (difference < 0) difference = -difference;
  const Real size = expected < 0 ? Real(-expected) : expected;
  const double error = static_cast<double>(Real(difference / size));
  return error >= 0 ? error : std::numeric_limits<double>::infinity();
}

/// Collects the errors of one quantity over a table and compares them with a
/// stated budget, at the latest in its destructor. It prints one line
/// (quantity, rows, max, RMS, budget, worst row), records the two numbers as
/// properties of the running test, and fails the test if the budget is exceeded
/// or no row was added.
class AccuracyReport {
 public:
  /// @param quantity  what is compared, as printed
  /// @param budget    largest relative error allowed; write beside it, in the
  ///                  test, where it comes from
  AccuracyReport(std::string quantity, double budget)
      : quantity_(std::move(quantity)), budget_(budget) {}
  /// A moved-from report is not checked.
  AccuracyReport(AccuracyReport&& other) noexcept : AccuracyReport(other) {
    other.is_checked_ = true;
  }
  ~AccuracyReport() {
    if (!is_checked_) check();
  }

  /// One row by its relative error; the label names the row.
  template <class Real>
  void add(const Real& computed, const Real& expected,
           const std::string& label) {
    add_error(relative_error(computed, expected), label);
  }

  /// Adds a row with an error measured by the caller. NaN counts as infinite.
  void add_error(double error, const std::string& label);

  /// Allows a report without rows.
  void may_be_empty() { may_be_empty_ = true; }

  double max() const { return max_; }
  double rms() const;
  std::size_t size() const { return count_; }
  const std::string& worst() const { return worst_; }

  /// Runs the destructor's check now.
  void check();

 private:
  AccuracyReport(const AccuracyReport&) = default;

  std::string quantity_;
  double budget_;
  double max_ = 0;
  double sum_of_squares_ = 0;
  std::size_t count_ = 0;
  std::string worst_;
  bool is_checked_ = false;
  bool may_be_empty_ = false;
};

}  // namespace contact::test
