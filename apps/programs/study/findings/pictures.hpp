#pragma once

#include <string>
#include <vector>

#include "programs/study/findings/findings.hpp"

namespace study {

/// A picture drawn by gnuplot.
struct Picture {
  std::string name;
  std::string script;  ///< "" if there are no numbers
};

/// "1", ...: the histogram of each requirement with its limit and bounds;
/// "ranking_1", ...: its drivers; "inputs_1", ...: the draws. For a case also
/// "clearance" and "angles": envelopes over time of the first runs and the
/// worst ones.
std::vector<Picture> pictures_of(const Study& study, const Findings& findings,
                                 const Journal& journal);

/// All files that draw() may write.
std::vector<std::string> picture_files(const Study& study,
                                       const std::string& file);

/// Draws each picture as FILE_NAME.EXT.
/// @return "" or the reason why pictures are missing
std::string draw(const std::vector<Picture>& pictures, const std::string& file);

}  // namespace study
