#pragma once

#include <span>
#include <string>
#include <string_view>

namespace contact::detail {

/// `text` on one line: control characters as \xNN, cut to some 60 characters.
std::string printable(std::string_view text);

/// The candidate that is at most two slips (a letter more, less, other, or two
/// exchanged) from `word`, fewer than half of its letters; empty if none is.
std::string nearest(std::string_view word,
                    std::span<const std::string> candidates);

}  // namespace contact::detail
