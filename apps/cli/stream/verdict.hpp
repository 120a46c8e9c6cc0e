#pragma once

#include <string>
#include <string_view>

/// Colours of verdicts on a terminal.
namespace cli {

/// A word, padded or not, in green if it is a good verdict, red if bad.
std::string coloured(std::string_view padded, std::string_view word);

/// A printable Markdown table with coloured verdicts.
std::string with_coloured_verdicts(std::string_view table);

}  // namespace cli
