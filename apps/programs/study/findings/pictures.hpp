#pragma once

#include <string>
#include <vector>

#include "programs/study/findings/findings.hpp"

namespace study {

/// Picture drawn by gnuplot.
struct Picture {
  std::string name;
  std::string script;  ///< "": there are no numbers
};

/// "1", ...: the histogram of each requirement with its limit and bounds,
/// "ranking_1", ...: what drives it, "inputs_1", ...: what was drawn, and of a
/// case "clearance" and "angles", between which values the first runs and the
/// worst ones were over the time.
std::vector<Picture> pictures_of(const Study& study, const Findings& findings,
                                 const Journal& journal);

/// All files that draw() may write.
std::vector<std::string> picture_files(const Study& study,
                                       const std::string& file);

/// Draws each as FILE_NAME.EXT.
/// @return "" or why there are not all of them
std::string draw(const std::vector<Picture>& pictures, const std::string& file);

}  // namespace study
