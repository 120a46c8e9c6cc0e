#include "libcontact/files/key_setting.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/key_units.hpp"

namespace contact::detail {
namespace {

// A step of a key's way through its file: "layer[1]", without an index 0.
struct Step {
  std::string_view name;
  std::size_t index = 0;
};

Step step_of(std::string_view text) {
  const auto bracket = text.find('[');
  Step step{text.substr(0, bracket)};
  if (bracket == text.npos || !text.ends_with(']')) return {text};
  const auto digits = text.substr(bracket + 1, text.size() - bracket - 2);
  const auto end = digits.data() + digits.size();
  return std::from_chars(digits.data(), end, step.index).ptr == end ? step
                                                                    : Step{};
}

const KnownKey* known(const KnownKeys* keys, std::string_view name) {
  if (keys == nullptr) return nullptr;
  const auto found = std::ranges::find_if(*keys, [&](const KnownKey& key) {
    return unit_in(name, key.key, key.dimension) != nullptr;
  });
  return found == keys->end() ? nullptr : &*found;
}

// The table that a step leads to, made if it is not there; null if something
// else is.
toml::table* table_at(toml::table& from, const Step& step) {
  if (step.index == 0) {
    return from.insert(step.name, toml::table{}).first->second.as_table();
  }
  toml::node* node = from.get(step.name);
  toml::array* array = node == nullptr ? nullptr : node->as_array();
  if (array == nullptr || step.index > array->size()) return nullptr;
  return (*array)[step.index - 1].as_table();
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

void set_key(toml::table& file, const KnownKeys& keys, const std::string& key,
             const std::string& value) {
  const std::string setting =
      message("{} = {}", printable(key), printable(value));
  const auto refuse = [&] {
    throw Error(must_be(setting,
                        "a key of the file: TABLE.KEY or "
                        "TABLE.LAYER[NUMBER].KEY"));
  };
  toml::table* table = &file;
  const KnownKeys* in = &keys;
  std::string_view rest = key;
  for (auto dot = rest.find('.'); dot != rest.npos; dot = rest.find('.')) {
    const Step step = step_of(rest.substr(0, dot));
    const KnownKey* next = known(in, step.name);
    const bool is_value = next != nullptr && next->inside.empty();
    table = is_value ? nullptr : table_at(*table, step);
    if (table == nullptr) refuse();
    in = next == nullptr ? nullptr : &next->inside;
    rest.remove_prefix(dot + 1);
  }
  if (rest.empty() || has_control_characters(value) ||
      value.find("'''") != value.npos) {
    refuse();
  }
  if (const KnownKey* leaf = known(in, rest)) {
    for (const std::string& other : spellings(leaf->key, leaf->dimension)) {
      table->erase(other);
    }
  }
  toml::table made = parsed(value, setting);
  made.get("value")->visit(
      [&](auto& node) { table->insert_or_assign(rest, std::move(node)); });
}

}  // namespace contact::detail
