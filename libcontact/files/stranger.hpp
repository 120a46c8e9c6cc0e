#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "libcontact/files/toml_nodes.hpp"
#include "libcontact/files/toml_reader.hpp"

namespace contact::detail {

/// Tests for a word among words separated by blanks: KnownKey::kinds.
bool has_word(std::string_view words, std::string_view word);

/// Keys for the table's kind; all if the kind is missing or wrong.
std::vector<const KnownKey*> of_kind(const toml::table& table,
                                     const KnownKeys& keys);

/// Key with this name among them; null if there is none.
const KnownKey* known_key(const toml::table& table, const KnownKeys& keys,
                          std::string_view name);

/// Message about a key that a table does not know, with the one that may be
/// meant: of the table, or of a table in it.
std::string unknown_key(const std::string& key, const toml::table& table,
                        const KnownKeys& keys, const std::string& path);

/// The first key of a file that is not known, or not read.
struct Stranger {
  /// Null if only unknown ones are looked for.
  const std::set<const toml::node*>* read = nullptr;
  const toml::node* node = nullptr;
  std::string complaint = {};

  void look_for(const toml::node& in, const KnownKeys& keys,
                const std::string& path);

 private:
  void note(const toml::node& value, std::string what);
};

}  // namespace contact::detail
