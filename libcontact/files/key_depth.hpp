#pragma once

#include <cstddef>
#include <string_view>

/// Each part of a dotted key is a table inside the one before it. The parser
/// takes any number of them, and tables that are nested by the hundred thousand
/// overflow the stack when they are destroyed.
namespace contact::detail {

/// Known keys have up to four parts, as body.hinge.joint.file.
inline constexpr std::size_t most_key_parts = 32;

/// The line of the first key or table header of a TOML text that has more than
/// most_key_parts parts; 0 if none has. Of a text that is not TOML the answer
/// holds up to the place where a parser stops.
std::size_t line_of_deep_key(std::string_view toml);

}  // namespace contact::detail
