#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Escapes foreign text (names in files, file names) so that it is read back as
/// the same text. CSV: csv.hpp; pages: html/markup.hpp; pictures: gnuplot.hpp.
namespace cli {

/// Markdown that shows this text in a cell or line: no link, no emphasis.
/// Control characters and direction marks become \xNN.
std::string markdown_text(std::string_view text);

/// As above for LaTeX, also in tables, where a "[" or "*" after the end of a
/// row would be read as its argument.
std::string latex_text(std::string_view text);

/// Quotes one word of a POSIX shell command if needed: 'it'\''s'.
std::string shell_word(std::string_view text);

/// Text for a terminal: control characters other than line ends and tabs become
/// \xNN.
std::string terminal_text(std::string_view text);

/// Number of characters of UTF-8 text, as terminals count them.
std::size_t terminal_width(std::string_view text);

}  // namespace cli
