#pragma once

#include <string>
#include <vector>

#include "libcontact/files/setting.hpp"

namespace cli {

/// Settings of --set KEY=VALUES, given once or more: one set for each
/// combination of the values; the last key varies fastest. VALUES are numbers,
/// a range of numbers as in Sweep, or comma-separated texts. Without --set
/// there is one combination without settings. Throws contact::Error for
/// malformed text, repeated keys or too many combinations.
std::vector<contact::KeySettings> key_settings(
    const std::vector<std::string>& texts);

/// The settings of --set KEY=VALUE; here commas belong to the value.
contact::KeySettings single_settings(const std::vector<std::string>& texts);

}  // namespace cli
