#pragma once

#include <string>
#include <vector>

#include "libcontact/files/toml_nodes.hpp"
#include "libcontact/files/toml_reader.hpp"

namespace contact::detail {

/// Place of a setting.
struct KeyPlace {
  /// Table that has the key, or that names the file to which it is left.
  toml::table* table;
  /// The key there, as the table or the file spells it: "com_m[2]".
  std::string key;
  bool of_file;
  /// One text for all names of a key: tables and places of arrays by their
  /// numbers, without a unit; as far as this file goes.
  std::string text;
};

/// Name of a setting in messages: its origin, else "KEY = VALUE". Nodes made by
/// it have this as their source.
std::string setting_text(const KeySetting& setting);

/// Gives a key of a file another value, as KeySetting says. Tables that are
/// missing are made; keys that are not known are left for others to refuse.
/// Throws Error "KEY = VALUE must be ..." if it leads to no table.
KeyPlace set_key(toml::table& file, const KnownKeys& keys,
                 const KeySetting& setting);

/// A number in a file.
struct NumberNode {
  double* number;
  double was;
};
/// All numbers of the last key that was set, valid until another key is set;
/// none for other types.
std::vector<NumberNode> numbers_at(const KeyPlace& place);

}  // namespace contact::detail
