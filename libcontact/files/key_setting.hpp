#pragma once

#include <string>

#include "libcontact/files/toml_nodes.hpp"
#include "libcontact/files/toml_reader.hpp"

namespace contact::detail {

/// Gives a key of a file another value, as KeySetting says. Tables that are
/// missing are made; keys that are not known are left for others to refuse.
/// Throws Error "KEY = VALUE must be ..." if it leads to no table.
void set_key(toml::table& file, const KnownKeys& keys, const std::string& key,
             const std::string& value);

}  // namespace contact::detail
