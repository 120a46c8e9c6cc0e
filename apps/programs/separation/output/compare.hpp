#pragma once

#include <vector>

#include "cli/program.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// Compares the case with ideal joints, full friction and the traditional
/// estimate: a row for each body and quantity.
///
/// Section 6 of the paper: the traditional estimate applies the friction
/// coefficient to the reaction R. The normal force R_n is less than R, so true
/// friction is smaller.
void write_comparison(const Case& c, const std::vector<Outcome>& outcomes,
                      const cli::OutputOptions& options);

}  // namespace separation
