#pragma once

#include <vector>

#include "cli/program.hpp"
#include "separation/results/run.hpp"

namespace separation {

/// The same case with ideal joints, full friction and the traditional
/// estimate, side by side: a row for each body and quantity.
///
/// Section 6 of the paper: the normal force R_n is less than the reaction
/// R of which the traditional estimate takes the friction, so that friction
/// sets itself to the least that fits.
void write_comparison(const Case& c, const std::vector<Outcome>& outcomes,
                      const cli::OutputOptions& options);

}  // namespace separation
