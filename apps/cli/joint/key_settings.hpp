#pragma once

#include <string>
#include <vector>

#include "libcontact/files/setting.hpp"

namespace cli {

/// Settings of --set KEY=VALUES, given once or more: one set for each
/// combination of the values, with the last key running fastest. VALUES are
/// numbers, a range of them as of Sweep, or texts between commas. One
/// combination without settings if there are none. Throws contact::Error for a
/// text of another form, a key that is there twice or too many combinations.
std::vector<contact::KeySettings> key_settings(
    const std::vector<std::string>& texts);

/// The same of --set KEY=VALUE, where commas are the value's.
contact::KeySettings single_settings(const std::vector<std::string>& texts);

}  // namespace cli
