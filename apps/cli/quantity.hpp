#pragma once

#include <array>
#include <string_view>

#include "cli/number.hpp"

namespace cli {

/// A number within an interval. Throws contact::Error with the name of its
/// option for anything else.
/// @param option  name for messages, such as "--radius"
double parse_value(std::string_view option, std::string_view text,
                   const Allowed& allowed);

/// A whole number within an interval. Throws contact::Error for anything else.
int parse_count(std::string_view option, std::string_view text, int min,
                int max);

/// "X,Y,Z": three numbers, finite. Throws contact::Error for anything else.
/// @param what  for messages: "a force in N"
std::array<double, 3> parse_vector(std::string_view option,
                                   std::string_view text,
                                   std::string_view what);

/// A length in m from "0.05", "0.05m", "50mm" or "25um". Throws contact::Error
/// for anything else and for a length that is not positive and finite.
/// @param option  name for messages, such as "--radius"
double parse_length(std::string_view option, std::string_view text);

}  // namespace cli
