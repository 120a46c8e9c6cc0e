#pragma once

#include <span>
#include <string>
#include <string_view>

/// The grammar of messages about what somebody gave. `what` names it, with its
/// value where it has one: "radius_mm = -50", "--radius -50mm", "radius = -50".
/// A file's name and line come in front: "j.toml:4: ".
namespace contact::detail {

/// Message "WHAT must be RULE"; `rule` is the condition: "above 0".
std::string must_be(std::string_view what, std::string_view rule);

/// `unknown KIND "WORD": did you mean "NEAREST"? (KNOWN, ...)`, without the
/// question if nothing is near.
std::string unknown(std::string_view kind, std::string_view word,
                    std::span<const std::string> known);
/// The same where the caller knows what is nearest; "" for nothing.
/// @param shown  the word, printable
std::string unknown(std::string_view kind, std::string_view shown,
                    std::string_view near, std::span<const std::string> known);

/// `: did you mean "NEAR"?`; "" if nothing is near.
std::string did_you_mean(std::string_view near);

/// "A, B or C"
std::string either(std::span<const std::string> words);

/// Message "WHAT requires OTHER".
std::string needs(std::string_view what, std::string_view other);

/// Message "WHAT conflicts with OTHER"; with a line number, "... (line 3)".
std::string conflicts(std::string_view what, std::string_view other,
                      int line = 0);

/// `duplicate KIND WHAT (lines 3 and 9)`, without lines if they are 0.
std::string duplicate(std::string_view kind, std::string_view what,
                      int first_line = 0, int second_line = 0);

}  // namespace contact::detail
