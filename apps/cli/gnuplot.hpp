#pragma once

#include <string>
#include <string_view>

/// Drawing of pictures by gnuplot.
namespace cli {

/// Checks that a picture of this name can be drawn: .svg, .png or .pdf.
/// @throws contact::Error "OPTION FILE must be ..." if not
void check_picture_name(std::string_view option, std::string_view file);

/// True if these bytes end as a complete picture of this kind ends.
bool is_whole_picture(std::string_view picture, std::string_view file);

/// Size of the canvas of an .svg, and of its font, in dots. Relative to the
/// canvas the fonts of the other kinds are at most as large.
inline constexpr int picture_width = 840;
inline constexpr int picture_height = 560;
inline constexpr int picture_font = 19;

/// Runs a gnuplot script; loads the style and sets terminal and output first.
/// @param file     name of the picture; appears when it is complete
/// @param stretch  height of the canvas over picture_height
/// @return "" or the reason why there is no picture: gnuplot or the terminal
///         for this kind of file is missing, drawing failed, or the file cannot
///         be written
std::string draw_script(std::string_view script, const std::string& file,
                        double stretch = 1);

/// The picture as the text of an SVG file.
/// @throws contact::Error with the reasons of draw_script()
std::string svg_of(std::string_view script);

/// Quotes literal text for gnuplot: "it\047s". gnuplot 5.4 drops apostrophes
/// within single quotes, so these and the special characters of double quotes
/// become octal numbers; control characters become \xNN.
std::string gnuplot_text(std::string_view text);

/// As above, for the label of a tic, which gnuplot reads as a format.
std::string gnuplot_tic(std::string_view text);

}  // namespace cli
