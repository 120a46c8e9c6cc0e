#pragma once

#include <string>

#include "libcontact/files/toml_nodes.hpp"
#include "libcontact/files/toml_reader.hpp"

namespace contact::detail {

/// Where a setting belongs.
struct KeyPlace {
  /// A table that names a file to which the key is left; null: it is made.
  const toml::table* table;
  /// The key of that file.
  std::string rest;
  /// One text for all names of a key: tables and places of arrays by their
  /// numbers, without a unit.
  std::string place;
};

/// What messages call it: where it is from, else "KEY = VALUE". Nodes that it
/// has made have this for their source.
std::string setting_text(const KeySetting& setting);

/// Gives a key of a file another value, as KeySetting says. Tables that are
/// missing are made; keys that are not known are left for others to refuse.
/// Throws Error "KEY = VALUE must be ..." if it leads to no table.
KeyPlace set_key(toml::table& file, const KnownKeys& keys,
                 const KeySetting& setting);

}  // namespace contact::detail
