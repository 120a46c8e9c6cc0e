#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "programs/study/findings/findings.hpp"

namespace study {

/// Content of the page in addition to the results.
struct PageExtras {
  std::map<std::string, std::string> pictures;  ///< SVG by name
  /// Replay files beside the page, by run.
  std::map<std::uint64_t, std::string> replays;
  std::string study_file;  ///< text of the study file
};

/// The report as one page that needs no network.
/// @param command  beginning of the command that repeats a run
std::string report_page(const Study& study, const Findings& findings,
                        const std::string& command, const PageExtras& extras);

}  // namespace study
