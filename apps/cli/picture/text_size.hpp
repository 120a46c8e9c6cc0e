#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/gnuplot.hpp"

/// How much room the texts of pictures take. Lengths are in sizes of the
/// pictures' font (em).
namespace cli {

/// Width of the canvas, and its height where no legend makes it higher.
inline constexpr double canvas_width =
    picture_width / static_cast<double>(picture_font);
inline constexpr double canvas_height =
    picture_height / static_cast<double>(picture_font);

/// Distance of lines of text.
inline constexpr double line_step = 1.3;

/// Width of a line of text in DejaVu Sans, than which other fonts without
/// serifs are narrower: of printable ASCII its own widths, of other characters
/// one that few exceed.
double text_width(std::string_view text);

/// Lines that are not wider than `room`, broken behind commas where that is
/// enough, else at any blank; a word that is wider has a line of its own.
std::vector<std::string> wrapped(std::string_view text, double room);

}  // namespace cli
