#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace contact::detail {

/// Whether a character of `text` is a control character, which could end a
/// line or speak to a terminal.
bool has_control_characters(std::string_view text);

/// `text` on one line: control characters and bytes that are not UTF-8 as
/// \xNN, cut to some `longest` bytes.
std::string printable(std::string_view text, std::size_t longest = 60);

/// The candidate that is at most two slips (a letter more, less, other, or two
/// exchanged) from `word`, fewer than half of its letters; empty if none is.
std::string nearest(std::string_view word,
                    std::span<const std::string> candidates);

}  // namespace contact::detail
