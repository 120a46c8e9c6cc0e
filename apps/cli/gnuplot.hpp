#pragma once

#include <string>
#include <string_view>

/// Drawing of pictures by gnuplot.
namespace cli {

/// Checks that a picture of this name can be drawn: .svg, .png or .pdf.
/// @throws contact::Error "OPTION FILE must be ..." if not
void check_picture_name(std::string_view option, std::string_view file);

/// Whether these bytes, which begin a picture of this name's kind, are all of
/// it: they end as such pictures end.
bool is_whole_picture(std::string_view picture, std::string_view file);

/// Size of the canvas of an .svg and of its font, dots; of the other kinds the
/// font is as large or smaller, against the canvas.
inline constexpr int picture_width = 840;
inline constexpr int picture_height = 560;
inline constexpr int picture_font = 19;

/// Draws what a gnuplot script says. The style is loaded, the terminal and
/// the output are set before it.
/// @param file     name of the picture; appears when it is complete
/// @param stretch  height of the canvas over picture_height
/// @return "" or why there is no picture: gnuplot or the terminal that it
///         needs for this kind of file is missing, drawing failed, or the
///         file cannot be written
std::string draw_script(std::string_view script, const std::string& file,
                        double stretch = 1);

/// The picture as the text of an SVG file.
/// @throws contact::Error why there is none, as above
std::string svg_of(std::string_view script);

/// Text that is shown as it is, quoted for gnuplot: "it\047s". In single quotes
/// gnuplot 5.4 loses apostrophes, so these and the special characters of double
/// quotes are octal numbers; control characters become \xNN.
std::string gnuplot_text(std::string_view text);

/// The same of the label of a tic, which gnuplot takes for a format.
std::string gnuplot_tic(std::string_view text);

}  // namespace cli
