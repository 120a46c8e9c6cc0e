#include "libcontact/files/key_setting.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/number.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/key_depth.hpp"
#include "libcontact/files/key_units.hpp"
#include "libcontact/files/stranger.hpp"

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

// The number of a place that a text is and nothing else.
std::optional<std::size_t> place_in(std::string_view text) {
  std::size_t number = 0;
  const auto end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return {};
  return number;
}

// The node of an array that "[2]" calls; null if there is none.
toml::node* element(toml::node* array, std::string_view which) {
  if (array == nullptr || array->as_array() == nullptr) return nullptr;
  const auto index = place_in(which);
  return index ? array->as_array()->get(*index - 1) : nullptr;
}

// The place in an array of tables, from 1, that a number or a name calls; 0 if
// no table has that name.
std::size_t place_among(const toml::array& tables, std::string_view which) {
  if (const auto number = place_in(which)) return *number;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const toml::table* table = tables[i].as_table();
    if (table != nullptr && (*table)["name"] == which) return i + 1;
  }
  return 0;
}

// The table that a step leads to, made if it is not there; null if something
// else is.
struct Inner {
  toml::table* table;
  std::size_t place;  // in its array, from 1; 0: in none
};
Inner table_at(toml::table& from, const Step& step) {
  if (step.which.empty()) {
    return {from.insert(step.name, toml::table{}).first->second.as_table(), 0};
  }
  toml::node* node = from.get(step.name);
  toml::array* array = node == nullptr ? nullptr : node->as_array();
  if (array == nullptr) return {nullptr, 0};
  const std::size_t place = place_among(*array, step.which);
  toml::node* found = array->get(place - 1);
  return {found == nullptr ? nullptr : found->as_table(), place};
}

// Throws of a key that the table does not know.
void refuse_unknown(const toml::table& table, const KnownKeys* keys,
                    std::string_view name, std::string place,
                    const std::string& setting) {
  if (keys == nullptr || known(keys, name) != nullptr) return;
  if (!place.empty()) place.pop_back();  // its point
  throw Error(setting + ": " +
              unknown_key(std::string(name), table, *keys, place));
}

// Throws, listing the names of the tables, if the array has none called
// `step.which`.
void refuse_stranger(const toml::table& from, const Step& step,
                     const std::string& setting) {
  const toml::array* const array = from.get_as<toml::array>(step.name);
  if (array == nullptr || place_in(step.which)) return;
  std::vector<std::string> names;
  for (const toml::node& node : *array) {
    const toml::table* const table = node.as_table();
    if (table == nullptr) continue;
    if (auto name = (*table)["name"].value<std::string>()) {
      names.push_back(std::move(*name));
    }
  }
  if (names.empty()) return;
  if (step.which.empty()) {
    throw Error(must_be(setting, message("of one {}, as {}[{}]", step.name,
                                         step.name, names.front())));
  }
  throw Error(setting + ": " + unknown(step.name, step.which, names));
}

// Place in messages, the same for all names of a step.
std::string place_text(const KnownKey* key, const Step& step,
                       std::size_t place) {
  const std::string_view name = key == nullptr ? step.name : key->key;
  return place == 0 ? std::string(name) : message("{}[{}]", name, place);
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

// Multiplied number, or numbers of an array, as in TOML; "" for other values.
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
  const auto factor = number_in(value.substr(1));
  return factor && std::isfinite(*factor) ? factor : std::nullopt;
}

// {value = VALUE}, whose nodes say where they are from; what is no TOML is a
// text.
toml::table parsed(const std::string& value, const std::string& source) {
  if (line_of_deep_key(value) == 0) {
    try {
      return toml::parse("value = " + value, source);
    } catch (const toml::parse_error&) {
    }
  }
  return toml::parse("value = '''" + value + "'''", source);
}

// Puts a value in its place in a table; under which name, "" if the array has
// no such place.
std::string put(toml::table& table, const Step& leaf, const KnownKeys* keys,
                std::string value, const std::string& setting) {
  const KnownKey* key = known(keys, leaf.name);
  const auto factor = factor_of(value);
  const std::string name =
      factor ? name_in(table, key, leaf.name) : std::string(leaf.name);
  const bool is_element = !leaf.which.empty();
  toml::node* there = table.get(name);
  if (is_element) there = element(there, leaf.which);
  if (factor) {
    value = there == nullptr ? "" : multiplied(*there, *factor);
    if (value.empty()) {
      throw Error(needs(setting, "a number, or numbers, to multiply"));
    }
  }
  toml::table made = parsed(value, setting);
  toml::node& node = *made.get("value");
  if (is_element) {
    if (there == nullptr) return {};
    toml::array& array = *table.get_as<toml::array>(name);
    const auto place = std::ranges::find_if(
        array, [there](const toml::node& other) { return &other == there; });
    node.visit([&](auto& v) { array.replace(place, std::move(v)); });
    return name;
  }
  if (key != nullptr) {
    for (const std::string& other : spellings(key->key, key->dimension)) {
      table.erase(other);
    }
  }
  node.visit([&](auto& v) { table.insert_or_assign(name, std::move(v)); });
  return name;
}

// Appends the numbers below a node that stands in an array; integers become
// what they are read as.
void add_numbers(toml::array& array, toml::array::iterator place,
                 std::vector<NumberNode>& to) {
  if (auto* inner = place->as_array()) {
    for (auto i = inner->begin(); i != inner->end(); ++i) {
      add_numbers(*inner, i, to);
    }
    return;
  }
  if (const auto* integer = place->as_integer()) {
    place = array.replace(place, static_cast<double>(integer->get()));
  }
  if (auto* number = place->as_floating_point()) {
    to.push_back({&number->get(), number->get()});
  }
}

}  // namespace

std::string setting_text(const KeySetting& setting) {
  if (!setting.origin.empty()) return printable(setting.origin);
  return message("{} = {}", printable(setting.key), printable(setting.value));
}

KeyPlace set_key(toml::table& file, const KnownKeys& keys,
                 const KeySetting& setting) {
  const std::string text = setting_text(setting);
  const auto refuse = [&] {
    throw Error(must_be(text,
                        "a key of the file: TABLE.KEY, TABLE[NUMBER].KEY or "
                        "TABLE[NAME].KEY"));
  };
  const auto dots =
      static_cast<std::size_t>(std::ranges::count(setting.key, '.'));
  if (dots >= most_key_parts) refuse();
  toml::table* table = &file;
  const KnownKeys* in = &keys;
  std::string_view rest = setting.key;
  std::string place;
  for (auto dot = rest.find('.'); dot != rest.npos; dot = rest.find('.')) {
    const Step step = step_of(rest.substr(0, dot));
    if (is_of_file(*table, in, step.name)) {
      return {table, std::string(rest), true, place};
    }
    const KnownKey* next = known(in, step.name);
    if (next != nullptr && next->inside.empty()) refuse();
    const Inner inner = table_at(*table, step);
    if (inner.table == nullptr) {
      refuse_unknown(*table, in, step.name, place, text);
      refuse_stranger(*table, step, text);
      refuse();
    }
    table = inner.table;
    place += place_text(next, step, inner.place) + '.';
    in = next == nullptr ? nullptr : &next->inside;
    rest.remove_prefix(dot + 1);
  }
  if (is_of_file(*table, in, rest)) {
    return {table, std::string(rest), true, place};
  }
  if (rest.empty() || has_control_characters(setting.value) ||
      setting.value.find("'''") != setting.value.npos) {
    refuse();
  }
  const Step leaf = step_of(rest);
  if (factor_of(setting.value)) {
    refuse_unknown(*table, in, leaf.name, place, text);
  }
  std::string key = put(*table, leaf, in, setting.value, text);
  if (key.empty()) refuse();
  if (!leaf.which.empty()) key += message("[{}]", leaf.which);
  place +=
      place_text(known(in, leaf.name), leaf, place_in(leaf.which).value_or(0));
  return {table, key, false, place};
}

std::vector<NumberNode> numbers_at(const KeyPlace& place) {
  const auto [name, which] = step_of(place.key);
  toml::node& node = *place.table->get(name);
  std::vector<NumberNode> numbers;
  if (auto* array = node.as_array()) {
    const toml::node* wanted = which.empty() ? nullptr : element(&node, which);
    for (auto i = array->begin(); i != array->end(); ++i) {
      if (wanted == nullptr || &*i == wanted) add_numbers(*array, i, numbers);
    }
    return numbers;
  }
  if (const auto* integer = node.as_integer()) {
    place.table->insert_or_assign(name, static_cast<double>(integer->get()));
  }
  if (auto* number = place.table->get_as<double>(name)) {
    numbers.push_back({&number->get(), number->get()});
  }
  return numbers;
}

}  // namespace contact::detail
