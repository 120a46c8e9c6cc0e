#pragma once

#include <nlohmann/json_fwd.hpp>

#include "cli/output.hpp"
#include "cli/table.hpp"

namespace separation {

/// Prints the summary of a run for people: tables of its events and bodies, the
/// smallest distance and the drift of energy; with --all a row for each number
/// of the bodies, joints and clearances.
void write_report(const nlohmann::ordered_json& summary, cli::Output& output,
                  const cli::TableStyle& style);

}  // namespace separation
