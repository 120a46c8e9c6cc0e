#include "libcontact/files/stranger.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/key_units.hpp"

namespace contact::detail {
namespace {

// A key that is its own former name: its reader reports the replacement, and no
// message suggests it.
bool is_gone(const KnownKey& key) { return key.key == key.former; }

// Symbols of the trade that people write for a key.
constexpr std::pair<std::string_view, std::string_view> symbols[] = {
    {"E", "youngs_modulus"}, {"nu", "poissons_ratio"}, {"mu", "coefficient"},
    {"f", "coefficient"},    {"f0", "coefficient"},    {"D", "diameter"},
    {"d", "diameter"},       {"R", "radius"},          {"r", "radius"},
    {"L", "length"},         {"B", "length"},          {"T", "temperature"}};

// The key of a symbol, with the symbol's unit: youngs_modulus_GPa of E_GPa.
std::string key_of_symbol(const std::string& key,
                          const std::vector<const KnownKey*>& known) {
  const std::size_t end = std::min(key.find('_'), key.size());
  for (const auto& [symbol, name] : symbols) {
    if (key.substr(0, end) != symbol) continue;
    for (const KnownKey* other : known) {
      if (other->key != name) continue;
      std::string spelling = std::string(name) + key.substr(end);
      return unit_in(spelling, name, other->dimension) != nullptr
                 ? spelling
                 : std::string(name);
    }
  }
  return {};
}

// The known spelling that a user has most likely meant by a key; "" for none:
// its new name, one that is nearly the same, or the same but for an ending,
// such as a unit that it does not take. One that is there was not meant, unless
// a table [x.y] beside a misspelt [x] has made it.
std::string meant_by(const std::string& key, const toml::table& table,
                     const std::vector<const KnownKey*>& known) {
  std::vector<std::string> likely;
  // A key given as a setting is not in the table, and is meant for one that is.
  const bool is_free = !table.contains(key) || table[key].is_table();
  for (const KnownKey* other : known) {
    if (is_gone(*other)) continue;
    const auto now = spellings(other->key, other->dimension);
    const auto before = spellings(other->former, other->dimension);
    const auto renamed = std::ranges::find(before, key) - before.begin();
    if (!other->former.empty() && renamed < std::ssize(before)) {
      return now[renamed];
    }
    for (const std::string& spelling : now) {
      if (is_free || !table.contains(spelling)) {
        likely.push_back(spelling);
      }
    }
  }
  std::string meant = key_of_symbol(key, known);
  if (meant.empty()) meant = nearest(key, likely);
  if (!meant.empty()) return meant;
  for (const std::string& other : likely) {
    if (key.starts_with(other + '_') && other.size() > meant.size()) {
      meant = other;
    }
  }
  if (!meant.empty()) return meant;
  for (const KnownKey* k : known) {
    const toml::table* in = table[k->key].as_table();
    if (in == nullptr) continue;
    for (const KnownKey* inner : of_kind(*in, k->inside)) {
      if (!is_gone(*inner) &&
          unit_in(key, inner->key, inner->dimension) != nullptr) {
        return joined(std::string(k->key), key);
      }
    }
  }
  return meant;
}

}  // namespace

bool has_word(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const auto end = std::min(words.find(' '), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

std::vector<const KnownKey*> of_kind(const toml::table& table,
                                     const KnownKeys& keys) {
  const auto kind = table["kind"].value<std::string>();
  std::vector<const KnownKey*> all;
  std::vector<const KnownKey*> fitting;
  bool named = false;
  for (const KnownKey& key : keys) {
    const bool fits = kind && has_word(key.kinds, *kind);
    all.push_back(&key);
    if (fits || key.kinds.empty()) fitting.push_back(&key);
    named = named || fits;
  }
  return named ? fitting : all;
}

// Called for every key that is read: without the list of of_kind().
const KnownKey* known_key(const toml::table& table, const KnownKeys& keys,
                          std::string_view name) {
  const toml::value<std::string>* kind = table["kind"].as_string();
  const auto fits = [kind](const KnownKey& key) {
    return kind != nullptr && has_word(key.kinds, kind->get());
  };
  const KnownKey* other = nullptr;
  for (const KnownKey& key : keys) {
    if (key.key != name) continue;
    if (key.kinds.empty() || fits(key)) return &key;
    if (other == nullptr) other = &key;
  }
  return other == nullptr || std::ranges::any_of(keys, fits) ? nullptr : other;
}

std::string unknown_key(const std::string& key, const toml::table& table,
                        const KnownKeys& keys, const std::string& path) {
  const auto known = of_kind(table, keys);
  std::vector<std::string> names;
  for (const KnownKey* k : known) {
    // Keys of several kinds are there once for each.
    if (!is_gone(*k) && std::ranges::find(names, k->key) == names.end()) {
      names.emplace_back(k->key);
    }
  }
  return unknown("key", joined(path, printable(key)),
                 meant_by(key, table, known), names);
}

void Stranger::look_for(const toml::node& in, const KnownKeys& keys,
                        const std::string& path) {
  if (const toml::array* array = in.as_array()) {
    std::size_t index = 0;
    for (const toml::node& element : *array) {
      look_for(element, keys, message("{}[{}]", path, ++index));
    }
  }
  const toml::table* table = in.as_table();
  if (table == nullptr) return;
  const auto known = of_kind(*table, keys);
  for (const auto& [name, value] : *table) {
    const std::string key(name.str());
    const auto found = std::ranges::find_if(known, [&](const KnownKey* k) {
      return unit_in(key, k->key, k->dimension) != nullptr;
    });
    if (found == known.end()) {
      note(value, unknown_key(key, *table, keys, path));
    } else if (read != nullptr && !read->contains(&value)) {
      note(value, must_be(named(joined(path, key), value),
                          "left out: it has no effect here"));
    } else if (!(*found)->inside.empty()) {
      // A table in the place of a value is refused when that is read.
      look_for(value, (*found)->inside, joined(path, key));
    }
  }
}

void Stranger::note(const toml::node& value, std::string what) {
  if (node != nullptr && line_of(*node) <= line_of(value)) return;
  node = &value;
  complaint = std::move(what);
}

}  // namespace contact::detail
