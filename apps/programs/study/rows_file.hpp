#pragma once

#include <string>

#include "cli/table.hpp"
#include "study/rows/journal.hpp"
#include "study/study.hpp"

namespace study {

/// Writes all rows in their order: run, inputs, quantities, status ("ok" or the
/// reason of the failure).
void write_csv(const Study& study, const Journal& journal,
               cli::TableStyle style, const std::string& file);

/// Writes a data set for each column: run, status (0 ok, 1 failed),
/// inputs/NAME, quantities/NAME. The file is built in memory.
void write_hdf5(const Study& study, const Journal& journal,
                const std::string& file);

}  // namespace study
