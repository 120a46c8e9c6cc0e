// SPDX-License-Identifier: MIT
#pragma once

#include "separation/case/case.hpp"

namespace separation {

/// Times of the rows of a run, from 0 to its end.
class OutputTimes {
 public:
  /// @param ends_only  none between
  OutputTimes(const Case& c, bool ends_only);

  double operator[](long i) const;
  /// Whether another time exists; the last one is the end.
  bool has(long i) const { return i <= count_; }
  /// Index of the first output time after a time and its rounding.
  long after(double time) const;
  /// Largest difference of times that count as equal.
  double instant() const { return rounding * step_; }

 private:
  static constexpr double rounding = 1e-9;  // in steps
  double end_;
  double step_;
  long count_;
};

}  // namespace separation
