#pragma once

#include <string>
#include <string_view>

/// What draws the pictures.
namespace cli {

/// Whether a picture of this name can be drawn: .svg, .png or .pdf.
/// @throws contact::Error "OPTION FILE must be ..." if not
void check_picture_name(std::string_view option, std::string_view file);

/// Whether these bytes, which begin a picture of this name's kind, are all of
/// it: they end as such pictures end.
bool is_whole_picture(std::string_view picture, std::string_view file);

/// Draws what a gnuplot script says. The style is loaded, the terminal and
/// the output are set before it.
/// @param file  name of the picture; appears when it is complete
/// @return "" or why there is no picture: gnuplot or the terminal that it
///         needs for this kind of file is missing, drawing failed, or the
///         file cannot be written
std::string draw_script(std::string_view script, const std::string& file);

/// The picture as the text of an SVG file.
/// @throws contact::Error why there is none, as above
std::string svg_of(std::string_view script);

/// Text that is shown as it is, quoted for gnuplot: 'it''s'. In single quotes
/// nothing but themselves and line ends counts for gnuplot: those and other
/// control characters become \xNN.
std::string gnuplot_text(std::string_view text);

}  // namespace cli
