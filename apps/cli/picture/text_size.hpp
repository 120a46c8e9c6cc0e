#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/gnuplot.hpp"

/// Size of the texts of pictures, in units of the pictures' font (em).
namespace cli {

/// Width of the canvas, and its usual height without a legend below the plots.
inline constexpr double canvas_width =
    picture_width / static_cast<double>(picture_font);
inline constexpr double canvas_height =
    picture_height / static_cast<double>(picture_font);
/// Empty room along its edges.
inline constexpr double canvas_margin = 0.5;

/// Line spacing.
inline constexpr double line_step = 1.3;

/// Width of a line of text in DejaVu Sans, the widest of the usual sans-serif
/// fonts: exact for printable ASCII; for other characters a width that few
/// exceed.
double text_width(std::string_view text);

/// Breaks text into lines no wider than `room`, after commas if that suffices,
/// else at any blank. A word that is too wide has a line of its own.
std::vector<std::string> wrapped(std::string_view text, double room);

}  // namespace cli
