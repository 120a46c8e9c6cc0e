#include "libcontact/files/key_setting.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/key_units.hpp"

namespace contact::detail {
namespace {

// A step of a key's way through its file: "layer[1]", "body[slosh]".
struct Step {
  std::string_view name;
  std::string_view which = {};
};

Step step_of(std::string_view text) {
  const auto bracket = text.find('[');
  if (bracket == text.npos || !text.ends_with(']')) return {text};
  return {text.substr(0, bracket),
          text.substr(bracket + 1, text.size() - bracket - 2)};
}

const KnownKey* known(const KnownKeys* keys, std::string_view name) {
  if (keys == nullptr) return nullptr;
  const auto found = std::ranges::find_if(*keys, [&](const KnownKey& key) {
    return unit_in(name, key.key, key.dimension) != nullptr;
  });
  return found == keys->end() ? nullptr : &*found;
}

// Of an array of tables, by number or name; null if there is none.
toml::table* table_among(toml::array& tables, std::string_view which) {
  std::size_t index = 0;
  const auto end = which.data() + which.size();
  const auto number = std::from_chars(which.data(), end, index);
  const bool is_number = number.ec == std::errc() && number.ptr == end;
  for (toml::node& node : tables) {
    toml::table* table = node.as_table();
    if (is_number ? --index == 0
                  : table != nullptr && (*table)["name"] == which) {
      return table;
    }
  }
  return nullptr;
}

// The table that a step leads to, made if it is not there; null if something
// else is.
toml::table* table_at(toml::table& from, const Step& step) {
  if (step.which.empty()) {
    return from.insert(step.name, toml::table{}).first->second.as_table();
  }
  toml::node* node = from.get(step.name);
  toml::array* array = node == nullptr ? nullptr : node->as_array();
  return array == nullptr ? nullptr : table_among(*array, step.which);
}

// Whether a key that a table does not have is left to a file that it names.
bool is_of_file(const toml::table& table, const KnownKeys* keys,
                std::string_view name) {
  if (keys == nullptr || table.contains(name)) return false;
  return std::ranges::any_of(*keys, [&](const KnownKey& key) {
    return table.contains(key.key) && known(&key.of_file, name) != nullptr;
  });
}

// The name under which a table has a key, in whatever unit; the one that was
// given if it has none.
std::string name_in(const toml::table& table, const KnownKey* key,
                    std::string_view given) {
  if (key != nullptr && !table.contains(given)) {
    for (const std::string& other : spellings(key->key, key->dimension)) {
      if (table.contains(other)) return other;
    }
  }
  return std::string(given);
}

// What a number, or all numbers of an array, are when multiplied, as in TOML;
// "" for anything else.
std::string multiplied(const toml::node& node, double factor) {
  if (const auto number = node.value<double>()) {
    return message("{}", *number * factor);
  }
  const toml::array* array = node.as_array();
  if (array == nullptr) return {};
  std::string text;
  for (const toml::node& element : *array) {
    const std::string next = multiplied(element, factor);
    if (next.empty()) return {};
    text += (text.empty() ? "[" : ", ") + next;
  }
  return text + ']';
}

// The factor of a value "*1.05".
std::optional<double> factor_of(std::string_view value) {
  if (!value.starts_with('*')) return {};
  double factor = 0;
  const auto [end, error] =
      std::from_chars(value.data() + 1, value.data() + value.size(), factor);
  const bool whole = end == value.data() + value.size();
  if (error != std::errc() || !whole || !std::isfinite(factor)) return {};
  return factor;
}

// The node of an array that "[2]" calls; null if there is none.
toml::node* element(toml::node* array, std::string_view which) {
  if (array == nullptr || array->as_array() == nullptr) return nullptr;
  std::size_t index = 0;
  const auto end = which.data() + which.size();
  const auto [stop, error] = std::from_chars(which.data(), end, index);
  const bool is_number = error == std::errc() && stop == end;
  return is_number ? array->as_array()->get(index - 1) : nullptr;
}

// {value = VALUE}, whose nodes say where they are from; what is no TOML is a
// text.
toml::table parsed(const std::string& value, const std::string& source) {
  try {
    return toml::parse("value = " + value, source);
  } catch (const toml::parse_error&) {
    return toml::parse("value = '''" + value + "'''", source);
  }
}

}  // namespace

KeyOfFile set_key(toml::table& file, const KnownKeys& keys,
                  const KeySetting& setting) {
  const std::string text =
      message("{} = {}", printable(setting.key), printable(setting.value));
  const auto refuse = [&] {
    throw Error(must_be(text,
                        "a key of the file: TABLE.KEY, TABLE[NUMBER].KEY or "
                        "TABLE[NAME].KEY"));
  };
  toml::table* table = &file;
  const KnownKeys* in = &keys;
  std::string_view rest = setting.key;
  for (auto dot = rest.find('.'); dot != rest.npos; dot = rest.find('.')) {
    const Step step = step_of(rest.substr(0, dot));
    if (is_of_file(*table, in, step.name)) return {table, std::string(rest)};
    const KnownKey* next = known(in, step.name);
    const bool is_value = next != nullptr && next->inside.empty();
    table = is_value ? nullptr : table_at(*table, step);
    if (table == nullptr) refuse();
    in = next == nullptr ? nullptr : &next->inside;
    rest.remove_prefix(dot + 1);
  }
  if (is_of_file(*table, in, rest)) return {table, std::string(rest)};
  if (rest.empty() || has_control_characters(setting.value) ||
      setting.value.find("'''") != setting.value.npos) {
    refuse();
  }
  const Step leaf = step_of(rest);
  const KnownKey* key = known(in, leaf.name);
  const auto factor = factor_of(setting.value);
  const std::string name =
      factor ? name_in(*table, key, leaf.name) : std::string(leaf.name);
  toml::node* there = table->get(name);
  if (!leaf.which.empty()) there = element(there, leaf.which);
  std::string value = setting.value;
  if (factor) {
    value = there == nullptr ? "" : multiplied(*there, *factor);
    if (value.empty()) {
      throw Error(needs(text, "a number, or numbers, to multiply"));
    }
  }
  toml::table made = parsed(value, text);
  toml::node& node = *made.get("value");
  if (!leaf.which.empty()) {
    if (there == nullptr) refuse();
    toml::array& array = *table->get_as<toml::array>(name);
    const auto place = std::ranges::find_if(
        array, [there](const toml::node& other) { return &other == there; });
    node.visit([&](auto& v) { array.replace(place, std::move(v)); });
    return {nullptr, {}};
  }
  if (key != nullptr) {
    for (const std::string& other : spellings(key->key, key->dimension)) {
      table->erase(other);
    }
  }
  node.visit([&](auto& v) { table->insert_or_assign(name, std::move(v)); });
  return {nullptr, {}};
}

}  // namespace contact::detail
