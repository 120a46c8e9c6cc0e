#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/stream/terminal_report.hpp"
#include "programs/study/findings/findings.hpp"

namespace study {

/// Results of a study for other programs; NaN is null, infinity the text "inf"
/// or "-inf".
nlohmann::ordered_json to_json(const Study& study, const Findings& findings);

using Cells = std::vector<std::string>;

/// A paragraph, a table, or a paragraph above a table.
struct Part {
  std::string heading = {};  ///< "": continues the previous part
  std::string text = {};
  Cells header = {};  ///< empty: no table
  std::vector<Cells> rows = {};
  /// Columns that a report leaves out, in this order, if it would be too wide.
  Cells spare = {};
  std::vector<std::string> pictures = {};  ///< names of pictures
  std::vector<std::uint64_t> runs = {};    ///< run of each row
};

/// Style of keys and requirements: as in files, or in words.
struct Words {
  std::string (*key)(std::string_view);
  std::string (*demand)(const Requirement&);
};
extern const Words as_in_files;
extern const Words in_words;

/// Distributions of the inputs, for people.
std::vector<Part> inputs_of(const Study& study, const Words& words);
/// Note on pressures above over_limit, with the number of runs.
std::string above_limit_text(const Study& study, const Findings& findings);

/// Results of a study, for people.
std::vector<Part> parts_of(const Study& study, const Findings& findings,
                           const Words& words);

/// Command that repeats a run.
/// @param command  its beginning
std::string command_of(const Study& study, const std::string& command,
                       std::uint64_t run);

/// The parts as Markdown.
/// @param command  beginning of the command that repeats a run
std::string to_text(const Study& study, const Findings& findings,
                    const std::string& command);

/// The parts for a terminal: verdicts as sentences, then aligned tables.
std::string to_report(const Study& study, const Findings& findings,
                      const std::string& command,
                      const cli::TerminalReport::Style& style);

/// "clearance.smallest_m at least 0.05"
std::string to_string(const Requirement& requirement);

}  // namespace study
