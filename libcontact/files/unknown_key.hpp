#pragma once

#include <string>

#include "libcontact/files/toml_nodes.hpp"
#include "libcontact/files/toml_reader.hpp"

namespace contact::detail {

/// Message about a key that a table does not know, with the one that may be
/// meant: of the table, or of a table in it.
std::string unknown_key(const std::string& key, const toml::table& table,
                        const KnownKeys& keys, const std::string& path);

}  // namespace contact::detail
