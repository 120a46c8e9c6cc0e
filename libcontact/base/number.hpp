#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace contact::detail {

/// std::from_chars() of a double, in the general format, also with standard
/// libraries that lack it (libc++ before 20). Reads in any locale; takes
/// neither blanks nor a plus sign nor hexadecimal digits. Numbers beyond the
/// range of a double are out of range; `value` then stays.
std::from_chars_result number_from(const char* first, const char* last,
                                   double& value);

/// The number that `text` is and nothing else, read as above.
std::optional<double> number_in(std::string_view text);

}  // namespace contact::detail
