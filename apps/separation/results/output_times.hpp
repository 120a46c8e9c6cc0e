#pragma once

#include "separation/case/case.hpp"

namespace separation {

/// Times of the rows of a run: 0, the first one, ... to its end.
class OutputTimes {
 public:
  /// @param ends_only  none between
  OutputTimes(const Case& c, bool ends_only);

  double operator[](long i) const;
  /// Whether there is one more, the end at last.
  bool has(long i) const { return i <= count_; }
  /// The first one after a time and its rounding.
  long after(double time) const;
  /// Times so near are one.
  double instant() const { return rounding * step_; }

 private:
  static constexpr double rounding = 1e-9;  // in steps
  double end_;
  double step_;
  long count_;
};

}  // namespace separation
