#pragma once

#include <vector>

namespace contact::detail {

/// Real zeros in (low, high) of the polynomial with these coefficients, the
/// constant first, ascending, to rounding: between the zeros of its derivative
/// it is monotone. None for a constant.
std::vector<double> zeros(const std::vector<double>& of, double low,
                          double high);

}  // namespace contact::detail
