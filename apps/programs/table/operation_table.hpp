#pragma once

#include "cli/program.hpp"
#include "programs/table/run.hpp"

namespace hinge_table {

/// The name in --quantity of the operations of bodies on hinges.
inline constexpr const char* operations_quantity = "operations";

/// Operations by which all accelerations and reactions are found (section 1.3
/// of the paper) and found again in an outer iteration (section 4): by solving
/// for all hinges at once, by the paper's count of its formulas, and by ours; a
/// row for each number of bodies. Throws contact::Error for options that change
/// nothing here.
cli::ExitStatus run_operations(const Options& options);

}  // namespace hinge_table
