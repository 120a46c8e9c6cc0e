#pragma once

#include <string>

#include "cli/output_names.hpp"
#include "programs/study/findings/findings.hpp"
#include "programs/study/findings/pictures.hpp"

namespace study {

/// Writes the report as a page. For a case it also writes the replay of each
/// worst run, FILE_runN.html. If the drawing programs are missing, the page has
/// tables only, and a warning is printed.
/// @param command  beginning of the command that repeats a run
/// @param names  of all files; a replay must differ from them
/// @return false, with a warning, if the page or a replay could not be written
bool write_report(const Study& study, const Findings& findings,
                  const std::vector<Picture>& pictures,
                  const std::string& command, const std::string& file,
                  cli::OutputNames& names);

}  // namespace study
