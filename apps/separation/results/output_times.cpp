#include "separation/results/output_times.hpp"

#include <algorithm>
#include <cmath>

namespace separation {

OutputTimes::OutputTimes(const Case& c, bool ends_only)
    : end_(c.end_time),
      step_(ends_only ? c.end_time : c.output_step),
      // A last step of a rounding error's length is none.
      count_(std::max(
          1L, static_cast<long>(std::ceil(c.end_time / step_ - rounding)))) {}

long OutputTimes::after(double time) const {
  if (time >= end_) return count_ + 1;
  return static_cast<long>(std::floor(time / step_ + rounding)) + 1;
}

double OutputTimes::operator[](long i) const {
  return i >= count_ ? end_ : static_cast<double>(i) * step_;
}

}  // namespace separation
