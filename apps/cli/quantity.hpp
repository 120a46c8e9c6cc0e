#pragma once

#include <string_view>

namespace cli {

/// A length in m from "0.05", "0.05m", "50mm" or "25um". Throws contact::Error
/// for anything else and for a length that is not positive and finite.
/// @param option  name for messages, such as "--radius"
double parse_length(std::string_view option, std::string_view text);

}  // namespace cli
