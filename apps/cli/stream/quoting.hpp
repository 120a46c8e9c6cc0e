#pragma once

#include <string>
#include <string_view>

/// Text of others (names in files, names of files) as it has to be written so
/// that it is read as that text. CSV: csv.hpp, pages: html/markup.hpp,
/// pictures: gnuplot.hpp.
namespace cli {

/// A cell or a line of Markdown that shows this text: no link, no emphasis.
/// Control characters and marks of direction become \xNN.
std::string markdown_text(std::string_view text);

/// The same of LaTeX, in a table too: behind the end of a row a "[" or "*"
/// would be an argument of it.
std::string latex_text(std::string_view text);

/// One word of a command of a POSIX shell: 'it'\''s', or as it is.
std::string shell_word(std::string_view text);

/// Lines for a terminal: all but line ends and tabs that could speak to it
/// becomes \xNN.
std::string terminal_text(std::string_view text);

}  // namespace cli
