#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/option.hpp"

/// Builds the help texts of programs from their rows of options and their
/// help.txt.
namespace cli {

/// A row and its heading in --help.
struct GroupedOption {
  std::string group;
  Option row;
};

/// A program as its help describes it.
struct ProgramHelp {
  std::string name;
  std::string does;
  std::vector<GroupedOption> options;
  std::string text;  ///< help.txt; examples follow "Examples:"
};

/// --help: at most 40 lines with three examples and the options in groups.
std::string short_help(const ProgramHelp& program);

/// --help-columns: the paragraphs on columns, or the whole text if it has none.
std::string columns_help(std::string_view text);

/// --completion: completes options, file names and words in a shell.
/// @param shell  "bash", "zsh" or "fish"
std::string completion(std::string_view shell, const ProgramHelp& program);

/// --man: the manual page, in troff with the man macros.
std::string man_page(const ProgramHelp& program, std::string_view version);

}  // namespace cli
