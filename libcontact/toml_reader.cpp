#include "libcontact/toml_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "libcontact/detail/text.hpp"
#include "libcontact/error.hpp"
#include "libcontact/units.hpp"

namespace contact {
namespace {

// value in SI = value * multiply / divide; powers of ten are divided where
// that is exact, so that 50 mm is the double nearest to 0.05 m.
struct Unit {
  std::string_view ending;
  std::string_view symbol;
  double multiply = 1;
  double divide = 1;

  double to_si(double value) const { return value * multiply / divide; }
  double from_si(double value) const { return value * divide / multiply; }
};

// Of paths and of what the parser says.
constexpr std::size_t longest_line = 300;

constexpr double rpm = std::numbers::pi / 30;

std::span<const Unit> units(Dimension dimension) {
  static constexpr Unit number[] = {{"", ""}};
  static constexpr Unit length[] = {{"m", "m"},
                                    {"mm", "mm", 1, 1e3},
                                    {"um", "um", 1, 1e6},
                                    {"km", "km", 1e3}};
  static constexpr Unit stress[] = {{"Pa", "Pa"},
                                    {"kPa", "kPa", 1e3},
                                    {"MPa", "MPa", 1e6},
                                    {"GPa", "GPa", 1e9}};
  static constexpr Unit force[] = {
      {"N", "N"}, {"kN", "kN", 1e3}, {"MN", "MN", 1e6}};
  static constexpr Unit line_force[] = {
      {"N_per_m", "N/m"}, {"kN_per_m", "kN/m", 1e3}, {"N_per_mm", "N/mm", 1e3}};
  static constexpr Unit moment[] = {
      {"N_m", "N m"}, {"kN_m", "kN m", 1e3}, {"N_mm", "N mm", 1, 1e3}};
  static constexpr Unit angle[] = {{"rad", "rad"}, {"deg", "deg", degree}};
  static constexpr Unit angular_velocity[] = {{"rad_per_s", "rad/s"},
                                              {"deg_per_s", "deg/s", degree},
                                              {"rpm", "rpm", rpm}};
  static constexpr Unit angular_acceleration[] = {
      {"rad_per_s2", "rad/s^2"}, {"deg_per_s2", "deg/s^2", degree}};
  static constexpr Unit velocity[] = {{"m_per_s", "m/s"},
                                      {"mm_per_s", "mm/s", 1, 1e3},
                                      {"km_per_h", "km/h", 1, 3.6}};
  static constexpr Unit acceleration[] = {{"m_per_s2", "m/s^2"}};
  static constexpr Unit time[] = {{"s", "s"}, {"ms", "ms", 1, 1e3}};
  static constexpr Unit mass[] = {
      {"kg", "kg"}, {"g", "g", 1, 1e3}, {"t", "t", 1e3}};
  static constexpr Unit inertia[] = {{"kg_m2", "kg m^2"}};
  switch (dimension) {
    case Dimension::number:
      return number;
    case Dimension::length:
      return length;
    case Dimension::stress:
      return stress;
    case Dimension::force:
      return force;
    case Dimension::line_force:
      return line_force;
    case Dimension::moment:
      return moment;
    case Dimension::angle:
      return angle;
    case Dimension::angular_velocity:
      return angular_velocity;
    case Dimension::angular_acceleration:
      return angular_acceleration;
    case Dimension::velocity:
      return velocity;
    case Dimension::acceleration:
      return acceleration;
    case Dimension::time:
      return time;
    case Dimension::mass:
      return mass;
    case Dimension::inertia:
      return inertia;
  }
  return number;
}

// A key's spelling with its unit, from the list of its dimension.
struct Spelling {
  std::string key;
  const Unit* unit;
};

// `key` alone (SI), then with every ending.
std::vector<Spelling> spellings(std::string_view key, Dimension dimension) {
  const std::span<const Unit> all = units(dimension);
  std::vector<Spelling> result = {{std::string(key), &all.front()}};
  for (const Unit& unit : all) {
    if (unit.ending.empty()) continue;
    result.push_back({fmt::format("{}_{}", key, unit.ending), &unit});
  }
  return result;
}

// "radius (in m), radius_m, radius_mm"
std::string spellings_text(std::string_view key, Dimension dimension) {
  std::string text;
  for (const Spelling& spelling : spellings(key, dimension)) {
    if (!text.empty()) text += ", ";
    text += spelling.key;
    if (spelling.key == key && !spelling.unit->symbol.empty()) {
      text += fmt::format(" (in {})", spelling.unit->symbol);
    }
  }
  return text;
}

std::string allowed_text(const Interval& allowed, const Unit& unit) {
  const bool any_low = allowed.low == -Interval::largest;
  const bool any_high = allowed.high == Interval::largest;
  const auto bound = [&](double value) {
    const std::string number = fmt::format("{:.6g}", unit.from_si(value));
    return unit.symbol.empty() ? number
                               : fmt::format("{} {}", number, unit.symbol);
  };
  std::string text;
  if (any_low && any_high) {
    text = "a finite number";
  } else if (any_high) {
    text = allowed.low_excluded ? "above " + bound(allowed.low)
                                : bound(allowed.low) + " or above";
  } else if (any_low) {
    text = (allowed.high_excluded ? "below " : "up to ") + bound(allowed.high);
  } else if (!allowed.low_excluded && !allowed.high_excluded) {
    text = fmt::format("{:.6g} to {}", unit.from_si(allowed.low),
                       bound(allowed.high));
  } else {
    text = fmt::format(
        "{} {:.6g}, {} {}", allowed.low_excluded ? "above" : "from",
        unit.from_si(allowed.low), allowed.high_excluded ? "below" : "up to",
        bound(allowed.high));
  }
  return allowed.or_infinity ? text + ", or inf" : text;
}

std::string type_text(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

// The value as messages show it: scalars in TOML, of others the type.
std::string value_text(const toml::node& node) {
  if (const auto text = node.as_string()) {
    return '"' + detail::printable(text->get()) + '"';
  }
  if (const auto number = node.as_floating_point()) {
    return fmt::format("{}", number->get());
  }
  if (const auto number = node.as_integer()) {
    return fmt::format("{}", number->get());
  }
  if (const auto flag = node.as_boolean())
    return flag->get() ? "true" : "false";
  return type_text(node);
}

// A file that ends where a table begins has no line for it.
unsigned line_of(const toml::node& node) {
  return std::max(1u, unsigned(node.source().begin.line));
}

}  // namespace

bool Interval::contains(double value) const {
  if (std::isinf(value)) return or_infinity && value > 0;
  return (low_excluded ? value > low : value >= low) &&
         (high_excluded ? value < high : value <= high);
}

struct TomlTable::File {
  std::string source;
  std::filesystem::path folder;
  toml::table root;
  // Of each table: spellings asked for, with the key they belong to.
  std::map<const void*, std::map<std::string, std::string>> known;
};

// A key that was found.
struct TomlTable::Entry {
  std::string place;  // "FILE:LINE: TABLE.KEY"
  std::string spelling;
  const toml::node* node;
  const Unit* unit;

  // "PLACE = VALUE: allowed: ALLOWED"
  [[noreturn]] void refuse(const std::string& allowed) const {
    throw Error(
        fmt::format("{} = {}: allowed: {}", place, value_text(*node), allowed));
  }

  // A number of this key or of its array.
  double number(const toml::node& value, const Interval& allowed) const {
    double result = 0;
    if (const auto floating = value.as_floating_point()) {
      result = floating->get();
    } else if (const auto integer = value.as_integer()) {
      result = static_cast<double>(integer->get());
    } else {
      throw Error(
          fmt::format("{} = {}: allowed: a number", place, value_text(value)));
    }
    result = unit->to_si(result);
    if (!allowed.contains(result)) {
      const bool says_so = allowed.low == -Interval::largest ||
                           allowed.high != Interval::largest;
      throw Error(
          fmt::format("{} = {}: allowed: {}{}", place, value_text(value),
                      allowed_text(allowed, *unit),
                      std::isinf(result) && !says_so ? ", finite" : ""));
    }
    return result;
  }

  // `count` numbers of an array appended to `to`.
  void numbers(const toml::node& array, std::size_t count,
               const Interval& allowed, std::vector<double>& to) const {
    const toml::array* values = array.as_array();
    if (values == nullptr || values->size() != count) {
      const std::string found =
          values == nullptr ? value_text(array)
                            : fmt::format("an array of {}", values->size());
      throw Error(fmt::format("{} = {}: allowed: an array of {} numbers", place,
                              found, count));
    }
    for (const toml::node& value : *values) {
      to.push_back(number(value, allowed));
    }
  }
};

TomlTable::TomlTable(std::shared_ptr<File> file, const void* table,
                     std::string path)
    : file_(std::move(file)), table_(table), path_(std::move(path)) {}

TomlTable TomlTable::from_file(const std::filesystem::path& path) {
  const auto refuse = [&path](const std::string& why) {
    throw Error(fmt::format("{}: cannot be read: {}",
                            detail::printable(path.string(), longest_line),
                            why));
  };
  if (path.native().find('\0') != path.native().npos) refuse("not a file");
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error) refuse(error.message());
  // A device could be endless.
  if (!std::filesystem::is_regular_file(status) &&
      !std::filesystem::is_fifo(status)) {
    refuse("not a file");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse(std::strerror(errno));
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) refuse(std::strerror(errno));
  return parse(text, path.string(), path.parent_path());
}

TomlTable TomlTable::from_text(std::string_view text,
                               const std::string& source) {
  return parse(text, source, {});
}

TomlTable TomlTable::parse(std::string_view text, const std::string& source,
                           std::filesystem::path folder) {
  auto file = std::make_shared<File>();
  file->source = source;
  file->folder = std::move(folder);
  try {
    file->root = toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw Error(
        fmt::format("{}:{}: {}", source, unsigned(error.source().begin.line),
                    detail::printable(error.description(), longest_line)));
  }
  const void* root = &file->root;
  return TomlTable(std::move(file), root, "");
}

namespace {

const toml::table& as_table(const void* table) {
  return *static_cast<const toml::table*>(table);
}

// Keys of A-Z a-z 0-9 _ - as they are, others quoted.
std::string key_text(std::string_view key) {
  const bool bare = !key.empty() && key.find_first_not_of(
                                        "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                        "abcdefghijklmnopqrstuvwxyz"
                                        "0123456789_-") == key.npos;
  const std::string shown = detail::printable(key);
  return bare ? shown : '"' + shown + '"';
}

std::string joined(const std::string& path, std::string_view key) {
  return path.empty() ? key_text(key) : path + '.' + key_text(key);
}

}  // namespace

std::optional<TomlTable::Entry> TomlTable::find(std::string_view key,
                                                Dimension dimension) const {
  std::optional<Entry> found;
  auto& known = file_->known[table_];
  for (const Spelling& spelling : spellings(key, dimension)) {
    known[spelling.key] = key;
    const toml::node* node = as_table(table_).get(spelling.key);
    if (node == nullptr) continue;
    Entry entry{fmt::format("{}:{}: {}", file_->source, line_of(*node),
                            joined(path_, spelling.key)),
                spelling.key, node, spelling.unit};
    if (found) {
      throw Error(fmt::format("{}: allowed: not together with {} in line {}",
                              entry.place, found->spelling,
                              line_of(*found->node)));
    }
    found = std::move(entry);
  }
  return found;
}

std::optional<TomlTable::Entry> TomlTable::find(std::string_view key) const {
  return find(key, Dimension::number);
}

void TomlTable::missing(std::string_view key, Dimension dimension) const {
  std::string hint;
  std::vector<std::string> strange;
  const auto& known = file_->known[table_];
  for (const auto& [name, node] : as_table(table_)) {
    if (!known.contains(std::string(name.str()))) {
      strange.emplace_back(name.str());
    }
  }
  for (const Spelling& spelling : spellings(key, dimension)) {
    const std::string meant = detail::nearest(spelling.key, strange);
    if (meant.empty()) continue;
    hint = fmt::format(" (is it {} in line {}?)", key_text(meant),
                       line_of(*as_table(table_).get(meant)));
    break;
  }
  throw Error(fmt::format("{}:{}: {} is missing: allowed: {}{}", file_->source,
                          line_of(as_table(table_)), joined(path_, key),
                          spellings_text(key, dimension), hint));
}

std::optional<double> TomlTable::optional_number(std::string_view key,
                                                 const Interval& allowed,
                                                 Dimension dimension) const {
  const auto entry = find(key, dimension);
  if (!entry) return {};
  return entry->number(*entry->node, allowed);
}

double TomlTable::number(std::string_view key, const Interval& allowed,
                         Dimension dimension) const {
  const auto value = optional_number(key, allowed, dimension);
  if (!value) missing(key, dimension);
  return *value;
}

std::optional<std::vector<double>> TomlTable::optional_numbers(
    std::string_view key, std::size_t size, const Interval& allowed,
    Dimension dimension) const {
  const auto entry = find(key, dimension);
  if (!entry) return {};
  std::vector<double> result;
  entry->numbers(*entry->node, size, allowed, result);
  return result;
}

std::vector<double> TomlTable::numbers(std::string_view key, std::size_t size,
                                       const Interval& allowed,
                                       Dimension dimension) const {
  auto values = optional_numbers(key, size, allowed, dimension);
  if (!values) missing(key, dimension);
  return *std::move(values);
}

std::optional<std::vector<double>> TomlTable::optional_matrix(
    std::string_view key, std::size_t rows, std::size_t columns,
    const Interval& allowed, Dimension dimension) const {
  const auto entry = find(key, dimension);
  if (!entry) return {};
  const toml::array* array = entry->node->as_array();
  if (array == nullptr || array->size() != rows) {
    entry->refuse(
        fmt::format("an array of {} arrays of {} numbers", rows, columns));
  }
  std::vector<double> result;
  for (const toml::node& row : *array) {
    entry->numbers(row, columns, allowed, result);
  }
  return result;
}

std::vector<double> TomlTable::matrix(std::string_view key, std::size_t rows,
                                      std::size_t columns,
                                      const Interval& allowed,
                                      Dimension dimension) const {
  auto values = optional_matrix(key, rows, columns, allowed, dimension);
  if (!values) missing(key, dimension);
  return *std::move(values);
}

std::optional<std::int64_t> TomlTable::optional_integer(
    std::string_view key, std::int64_t low, std::int64_t high) const {
  const auto entry = find(key);
  if (!entry) return {};
  const auto value = entry->node->as_integer();
  if (value == nullptr || value->get() < low || value->get() > high) {
    entry->refuse(fmt::format("an integer, {} to {}", low, high));
  }
  return value->get();
}

std::int64_t TomlTable::integer(std::string_view key, std::int64_t low,
                                std::int64_t high) const {
  const auto value = optional_integer(key, low, high);
  if (!value) missing(key, Dimension::number);
  return *value;
}

std::optional<bool> TomlTable::optional_boolean(std::string_view key) const {
  const auto entry = find(key);
  if (!entry) return {};
  const auto value = entry->node->as_boolean();
  if (value == nullptr) entry->refuse("true or false");
  return value->get();
}

bool TomlTable::boolean(std::string_view key) const {
  const auto value = optional_boolean(key);
  if (!value) missing(key, Dimension::number);
  return *value;
}

std::optional<std::string> TomlTable::optional_text(
    std::string_view key) const {
  const auto entry = find(key);
  if (!entry) return {};
  const auto value = entry->node->as_string();
  if (value == nullptr || value->get().empty()) {
    entry->refuse("a string, not empty");
  }
  return value->get();
}

std::string TomlTable::text(std::string_view key) const {
  auto value = optional_text(key);
  if (!value) missing(key, Dimension::number);
  return *std::move(value);
}

std::optional<std::size_t> TomlTable::optional_choice(
    std::string_view key, const std::vector<std::string>& words) const {
  const auto entry = find(key);
  if (!entry) return {};
  if (const auto value = entry->node->as_string()) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == value->get()) return i;
    }
  }
  entry->refuse(fmt::format("\"{}\"", fmt::join(words, "\", \"")));
}

std::size_t TomlTable::choice(std::string_view key,
                              const std::vector<std::string>& words) const {
  const auto value = optional_choice(key, words);
  if (!value) missing(key, Dimension::number);
  return *value;
}

std::optional<TomlTable> TomlTable::optional_table(std::string_view key) const {
  const auto entry = find(key);
  if (!entry) return {};
  const toml::table* inner = entry->node->as_table();
  if (inner == nullptr) entry->refuse("a table");
  return TomlTable(file_, inner, joined(path_, key));
}

TomlTable TomlTable::table(std::string_view key) const {
  const auto inner = optional_table(key);
  if (!inner) {
    throw Error(fmt::format("{}:{}: the table [{}] is missing", file_->source,
                            line_of(as_table(table_)), joined(path_, key)));
  }
  return *inner;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const auto entry = find(key);
  if (!entry) return {};
  const toml::array* array = entry->node->as_array();
  std::vector<TomlTable> result;
  if (array != nullptr) {
    for (const toml::node& node : *array) {
      if (!node.is_table()) entry->refuse("an array of tables");
      result.push_back(TomlTable(
          file_, node.as_table(),
          fmt::format("{}[{}]", joined(path_, key), result.size() + 1)));
    }
  }
  if (result.empty()) entry->refuse("an array of tables");
  return result;
}

bool TomlTable::has(std::string_view key, Dimension dimension) const {
  return find(key, dimension).has_value();
}

void TomlTable::refuse_unknown_keys() const {
  const toml::node* first = nullptr;
  std::string message;
  const auto look_at = [&](const toml::table& table, const toml::node& value,
                           const std::string& key, const std::string& place) {
    if (first != nullptr && line_of(*first) <= line_of(value)) return;
    first = &value;
    std::vector<std::string> absent;  // spellings that are not there
    std::vector<std::string> keys;
    for (const auto& [spelling, asked] : file_->known[&table]) {
      if (!table.contains(spelling)) absent.push_back(spelling);
      if (spelling == asked) keys.push_back(asked);
    }
    const std::string meant = detail::nearest(key, absent);
    message = fmt::format(
        "{}:{}: {}: unknown key: {}", file_->source, line_of(value), place,
        meant.empty() ? fmt::format("allowed: {}", fmt::join(keys, ", "))
                      : fmt::format("did you mean {}?", meant));
  };
  const std::function<void(const toml::node&, const std::string&)> visit =
      [&](const toml::node& node, const std::string& path) {
        if (const toml::array* array = node.as_array()) {
          std::size_t index = 0;
          for (const toml::node& element : *array) {
            visit(element, fmt::format("{}[{}]", path, ++index));
          }
        } else if (const toml::table* table = node.as_table()) {
          for (const auto& [name, value] : *table) {
            const std::string key(name.str());
            const std::string place = joined(path, key);
            if (file_->known[table].contains(key)) {
              visit(value, place);
            } else {
              look_at(*table, value, key, place);
            }
          }
        }
      };
  visit(file_->root, "");
  if (first != nullptr) throw Error(message);
}

void TomlTable::fail(std::string_view key, const std::string& message) const {
  for (const auto& [spelling, asked] : file_->known[table_]) {
    const toml::node* node = as_table(table_).get(spelling);
    if (asked != key || node == nullptr) continue;
    throw Error(fmt::format("{}:{}: {} = {}: {}", file_->source, line_of(*node),
                            joined(path_, spelling), value_text(*node),
                            message));
  }
  throw Error(fmt::format("{}:{}: {}: {}", file_->source,
                          line_of(as_table(table_)), joined(path_, key),
                          message));
}

const std::string& TomlTable::source() const { return file_->source; }

const std::filesystem::path& TomlTable::folder() const { return file_->folder; }

}  // namespace contact
