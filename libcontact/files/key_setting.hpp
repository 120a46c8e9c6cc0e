#pragma once

#include <string>

#include "libcontact/files/toml_nodes.hpp"
#include "libcontact/files/toml_reader.hpp"

namespace contact::detail {

/// A key of a file that a table names.
struct KeyOfFile {
  const toml::table* table;
  std::string key;
};

/// Gives a key of a file another value, as KeySetting says. Tables that are
/// missing are made; keys that are not known are left for others to refuse.
/// Throws Error "KEY = VALUE must be ..." if it leads to no table.
/// @return the key that is left to another file; without a table if none is
KeyOfFile set_key(toml::table& file, const KnownKeys& keys,
                  const KeySetting& setting);

}  // namespace contact::detail
