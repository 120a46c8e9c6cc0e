#pragma once

#include "cli/program.hpp"
#include "programs/table/run.hpp"

namespace hinge_table {

/// The --quantity of the operation counts for bodies on hinges.
inline constexpr const char* operations_quantity = "operations";

/// Writes the operations needed to find all accelerations and reactions
/// (section 1.3 of the paper), and to find them again in an outer iteration
/// (section 4): by solving for all hinges at once, by the paper's count of its
/// formulas, and by our solver; a row for each number of bodies. Throws
/// contact::Error for options without effect.
cli::ExitStatus run_operations(const Options& options);

}  // namespace hinge_table
