#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "programs/study/findings/findings.hpp"

namespace study {

/// Content of the page beside the results.
struct PageExtras {
  std::map<std::string, std::string> pictures;  ///< SVG, by their names
  /// Names of the files of replays, beside the page, by their runs.
  std::map<std::uint64_t, std::string> replays;
  std::string study_file;  ///< its text
};

/// The report as one page that needs no network.
/// @param command  that begins the one for a single run
std::string report_page(const Study& study, const Findings& findings,
                        const std::string& command, const PageExtras& extras);

}  // namespace study
