#pragma once

#include <string>

#include "cli/output_names.hpp"
#include "programs/study/findings/findings.hpp"
#include "programs/study/findings/pictures.hpp"

namespace study {

/// Writes the report as a page, and of a case beside it the replay of each
/// worst run, FILE_runN.html. What draws them may be missing: the page has
/// tables alone then, and a warning says so.
/// @param command  that begins the one for a single run
/// @param names  of all files, of which a replay may not be another
/// @return false if the page or a replay could not be written, of which it
///   warns
bool write_report(const Study& study, const Findings& findings,
                  const std::vector<Picture>& pictures,
                  const std::string& command, const std::string& file,
                  cli::OutputNames& names);

}  // namespace study
