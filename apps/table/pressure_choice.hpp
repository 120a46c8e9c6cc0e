#pragma once

#include "cli/laws.hpp"
#include "table/run.hpp"

namespace hinge_table {

/// The pressure law that the options name, for a ball of their materials.
/// Throws contact::Error if they do not fit together, or if the law depends on
/// the materials and there are none.
cli::NamedPressure chosen_pressure(const Options& options);

}  // namespace hinge_table
