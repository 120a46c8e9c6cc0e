#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace contact::detail {

/// The folder `data`, whose files are also called by their names alone. Empty
/// until a program or package that knows it sets it at its start.
std::filesystem::path& shipped_data();

/// The file that another one names: relative to its folder, or, for a name
/// without path and ending, a shipped file, as in pair = "steel_bronze".
/// @param key  "pair" (of data/materials) or "file" (of data/joints)
std::filesystem::path named_file(const std::filesystem::path& folder,
                                 std::string_view key, const std::string& name);

}  // namespace contact::detail
