#include "libcontact/files/toml_nodes.hpp"

#include <algorithm>
#include <sstream>

#include "libcontact/base/text.hpp"

namespace contact::detail {
namespace {

// Longest array in messages, as long as a text.
constexpr std::size_t longest_array = 60;

// "[1, 2.5]"; a long one is cut: "[1, 2.5, ... 500 in all]".
std::string array_text(const toml::array& array) {
  std::string text;
  for (const toml::node& element : array) {
    std::string next = (text.empty() ? "" : ", ") + value_text(element);
    if (text.size() + next.size() > longest_array) {
      text +=
          message("{}... {} in all", text.empty() ? "" : ", ", array.size());
      break;
    }
    text += next;
  }
  return '[' + text + ']';
}

}  // namespace

int line_of(const toml::node& node) {
  return std::max(1, static_cast<int>(node.source().begin.line));
}

std::string value_text(const toml::node& node) {
  if (const auto text = node.as_string()) {
    return '"' + printable(text->get()) + '"';
  }
  if (const auto number = node.as_floating_point()) {
    return message("{}", number->get());
  }
  if (const auto number = node.as_integer()) {
    return message("{}", number->get());
  }
  if (const auto flag = node.as_boolean())
    return flag->get() ? "true" : "false";
  if (const auto array = node.as_array()) return array_text(*array);
  if (node.is_table()) return "a table";
  std::ostringstream text;
  if (const auto date = node.as_date()) text << *date;
  if (const auto time = node.as_time()) text << *time;
  if (const auto both = node.as_date_time()) text << *both;
  return text.str();
}

std::string joined(const std::string& table, const std::string& key) {
  return table.empty() ? key : table + '.' + key;
}

std::string named(const std::string& key, const toml::node& value) {
  return value.is_table() ? key : key + " = " + value_text(value);
}

// Texts carry their length, so that their content is not taken for structure.
std::string canonical(const toml::node& node) {
  std::string text;
  if (const auto table = node.as_table()) {
    for (const auto& [name, value] : *table) {  // in alphabetical order
      const std::string_view key = name.str();
      text += message("{}:{}={},", key.size(), key, canonical(value));
    }
    return '{' + text + '}';
  }
  if (const auto array = node.as_array()) {
    for (const toml::node& element : *array) text += canonical(element) + ',';
    return '[' + text + ']';
  }
  if (const auto string = node.as_string()) {
    return message("\"{}:{}", string->get().size(), string->get());
  }
  // All numbers are read as such.
  if (const auto integer = node.as_integer()) {
    return message("{}", static_cast<double>(integer->get()));
  }
  return value_text(node);
}

}  // namespace contact::detail
