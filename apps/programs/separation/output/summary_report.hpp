#pragma once

#include <nlohmann/json_fwd.hpp>

#include "cli/output.hpp"
#include "cli/table.hpp"

namespace separation {

/// The summary of a run for people: its events, then the numbers of each body,
/// of its joints and clearances, a line each.
void write_report(const nlohmann::ordered_json& summary, cli::Output& output,
                  const cli::TableStyle& style);

}  // namespace separation
