#include "libcontact/files/toml_reader.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/files/key_depth.hpp"
#include "libcontact/files/key_setting.hpp"
#include "libcontact/files/key_units.hpp"
#include "libcontact/files/named_file.hpp"
#include "libcontact/files/repeated_setting.hpp"
#include "libcontact/files/toml_file.hpp"

namespace contact {
namespace {

// Limit for the parser's messages.
constexpr std::size_t longest_line = 300;

std::string shape_text(const ArrayShape& shape) {
  const std::string text = detail::message("an array of {}{}", shape.rows,
                                           shape.or_more ? " or more" : "");
  return shape.columns == 0
             ? text + " numbers"
             : detail::message("{} arrays of {} numbers", text, shape.columns);
}

// Line `number` of a text, from 1.
std::string_view line_of(std::string_view text, unsigned number) {
  for (unsigned i = 1; i < number; ++i) {
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  return text.substr(0, text.find_first_of("\r\n"));
}

// The rule that a number breaks which people write and TOML does not take: 10,5
// .5 50. 0010 5mm; "" for other text.
std::string number_rule(std::string_view value) {
  constexpr std::string_view digits = "0123456789";
  const auto has_digit = [&](std::string_view text, std::size_t at) {
    return at < text.size() && digits.find(text[at]) != digits.npos;
  };
  if (value.starts_with('+') || value.starts_with('-')) value.remove_prefix(1);
  const std::size_t count =
      std::min(value.find_first_not_of(digits), value.size());
  const std::string_view rest = value.substr(count);
  if (rest.starts_with(',') && count > 0 && has_digit(rest, 1)) {
    return "a number whose decimals have a point, as 10.5, and thousands no "
           "comma";
  }
  if (rest.starts_with('.') && !(count > 0 && has_digit(rest, 1))) {
    return "a number with digits on both sides of its point, as 0.5 and 50.0";
  }
  if (count > 1 && value[0] == '0') return "a number without zeros in front";
  const std::size_t letters = rest.find_first_not_of(" \t.0123456789e+-");
  return count > 0 && letters != rest.npos
             ? "a number alone: its unit is in the key, as in length_mm"
             : "";
}

// Message on a line that the parser refuses.
std::string parse_problem(std::string_view line, std::string_view parser) {
  if (parser.find("utf-8") != parser.npos) {
    return detail::must_be("the file",
                           "UTF-8: it is UTF-16, Latin-1 or no text");
  }
  std::string_view value = line.substr(0, line.find('#'));
  const std::size_t equals = value.find('=');
  std::string rule;
  if (equals != value.npos)
    rule = number_rule(detail::trimmed(value.substr(equals + 1)));
  return rule.empty()
             ? detail::printable(parser, longest_line)
             : detail::must_be(
                   detail::printable(detail::trimmed(value), longest_line),
                   rule);
}

Interval numbers_of(const KnownKey& key) {
  return key.allowed.numbers.value_or(Interval::any());
}

const toml::table& as_table(const void* table) {
  return *static_cast<const toml::table*>(table);
}

}  // namespace

// A key that was found.
struct TomlTable::Entry {
  const File* file;
  std::string name;  // "TABLE.KEY"
  const toml::node* node;
  const Unit* unit;

  [[noreturn]] void must_be(std::string_view rule) const {
    must_be(*node, "", rule);
  }

  // Names the value at `index` of its array: "[3]", "[2][1]".
  [[noreturn]] void must_be(const toml::node& value, const std::string& index,
                            std::string_view rule) const {
    throw Error(
        detail::must_be(file->subject(*node, name + index, value), rule));
  }

  // `index` makes the place in an array for a message: "[3]", "[2][1]".
  template <class Index>
  double number(const toml::node& value, const Interval& range,
                const Index& index) const {
    const auto integer = value.as_integer();
    const auto floating = value.as_floating_point();
    if (!integer && !floating) must_be(value, index(), "a number");
    const double result = unit->to_si(
        floating ? floating->get() : static_cast<double>(integer->get()));
    if (is_unlikely(result)) must_be(value, index(), unlikely_rule(value));
    if (range.contains(result)) return result;
    const bool says_so =
        range.low == -Interval::largest || range.high != Interval::largest;
    must_be(value, index(),
            detail::range_text(range, *unit) +
                (std::isinf(result) && !says_so ? " and finite" : ""));
  }

  // An angle beyond a turn whose key has no unit is meant in degrees.
  bool is_unlikely(double result) const {
    return unit->ending == "rad" && !name.ends_with("_rad") &&
           std::abs(result) > 2 * detail::pi && std::isfinite(result);
  }
  std::string unlikely_rule(const toml::node& value) const {
    return detail::message(
        "at most a turn without a unit: {0} is {0} rad; write {1}_deg = {0} or "
        "{1}_rad = {0}",
        detail::value_text(value), name.substr(name.rfind('.') + 1));
  }

  // Appended to `to`.
  void numbers(const toml::node& value, const ArrayShape& shape,
               const Interval& range, const std::string& index,
               std::vector<double>& to) const {
    const toml::array* array = value.as_array();
    if (array == nullptr || array->size() < shape.rows ||
        (array->size() > shape.rows && !shape.or_more)) {
      must_be(value, index, shape_text(shape));
    }
    std::size_t i = 0;
    for (const toml::node& element : *array) {
      ++i;
      const auto at = [&] { return detail::message("{}[{}]", index, i); };
      if (shape.columns == 0) {
        to.push_back(number(element, range, at));
      } else {
        numbers(element, {shape.columns}, range, at(), to);
      }
    }
  }

  std::string text(const toml::node& value, std::string_view rule) const {
    const auto given = value.as_string();
    if (given == nullptr || given->get().empty()) must_be(rule);
    // It would end the text for HDF5 and C.
    if (given->get().find('\0') != std::string::npos) {
      must_be("without the character U+0000");
    }
    return given->get();
  }
};

TomlTable::TomlTable(std::shared_ptr<File> file, const void* table,
                     const KnownKeys* keys, std::string path)
    : file_(std::move(file)),
      table_(table),
      keys_(keys),
      path_(std::move(path)) {}

TomlTable TomlTable::from_file(const std::filesystem::path& path,
                               KnownKeys keys, const KeySettings& settings) {
  return from_text(detail::file_text(path), path.string(), std::move(keys),
                   path.parent_path(), settings);
}

TomlTable TomlTable::from_text(std::string_view text, const std::string& source,
                               KnownKeys keys, std::filesystem::path folder,
                               const KeySettings& settings) {
  return of(parsed(text, source, std::move(keys)), source, std::move(folder),
            settings, {});
}

TomlTable::Parsed TomlTable::parsed(std::string_view text,
                                    const std::string& source, KnownKeys keys) {
  if (const std::size_t line = detail::line_of_deep_key(text); line > 0) {
    throw Error(detail::message(
        "{}:{}: {}", source, line,
        detail::must_be("a key", detail::message("of at most {} parts",
                                                 detail::most_key_parts))));
  }
  try {
    return {std::make_shared<const KnownKeys>(std::move(keys)),
            toml::parse(text)};
  } catch (const toml::parse_error& error) {
    const auto line = unsigned(error.source().begin.line);
    throw Error(detail::message(
        "{}:{}: {}", source, line,
        parse_problem(line_of(text, line), error.description())));
  }
}

TomlTable TomlTable::of(Parsed parsed, const std::string& source,
                        std::filesystem::path folder,
                        const KeySettings& settings,
                        std::shared_ptr<Cache> cache) {
  const auto file = std::make_shared<File>(
      File{source, std::move(folder), std::move(parsed.keys),
           std::move(parsed.root), std::move(cache)});
  std::map<std::string, std::string> keys;  // by their places
  for (const KeySetting& setting : settings) {
    const detail::KeyPlace& place = file->settings.emplace_back(
        detail::set_key(file->root, *file->keys, setting));
    if (!setting.origin.empty()) {
      file->origins.insert(detail::setting_text(setting));
    }
    if (place.of_file) {
      file->for_files[place.table].push_back(
          {place.key, setting.value, setting.origin});
    } else if (const auto [other, is_new] =
                   keys.emplace(place.text, setting.key);
               !is_new) {
      throw RepeatedSetting(detail::conflicts(
          detail::setting_text(setting), detail::printable(other->second)));
    }
  }
  file->refuse({});
  return TomlTable(file, &file->root, file->keys.get(), "");
}

TomlTable TomlTable::cached(const std::shared_ptr<Cache>& cache,
                            const std::filesystem::path& path,
                            KnownKeys (*keys)(), const KeySettings& settings) {
  const std::string source = path.string();
  const Parsed* known = nullptr;
  {
    const std::lock_guard lock(cache->mutex);
    auto found = cache->files.find(source);
    if (found == cache->files.end()) {
      found =
          cache->files
              .emplace(source, parsed(detail::file_text(path), source, keys()))
              .first;
    }
    known = &found->second;
  }
  return of(*known, source, path.parent_path(), settings, cache);
}

TomlFiles::TomlFiles() : cache_(std::make_shared<TomlTable::Cache>()) {}

TomlTable TomlFiles::open(const std::filesystem::path& path,
                          KnownKeys (*keys)(),
                          const KeySettings& settings) const {
  return TomlTable::cached(cache_, path, keys, settings);
}

TomlTable TomlFiles::text(std::string_view text, const std::string& source,
                          KnownKeys (*keys)(),
                          const std::filesystem::path& folder,
                          const KeySettings& settings) const {
  return TomlTable::of(TomlTable::parsed(text, source, keys()), source, folder,
                       settings, cache_);
}

const KnownKey& TomlTable::declared(std::string_view key) const {
  const KnownKey* known = detail::known_key(as_table(table_), *keys_, key);
  if (known == nullptr) {
    throw std::logic_error(detail::message("{} is not declared", key));
  }
  return *known;
}

std::optional<TomlTable::Entry> TomlTable::find(std::string_view key) const {
  const KnownKey& known = declared(key);
  std::optional<Entry> found;
  for (const auto& [name, node] : as_table(table_)) {
    const auto unit = detail::unit_in(name.str(), known.key, known.dimension);
    if (unit == nullptr) continue;
    file_->read.insert(&node);
    Entry entry{file_.get(), detail::joined(path_, std::string(name.str())),
                &node, unit};
    if (found) {
      if (detail::line_of(node) < detail::line_of(*found->node))
        std::swap(entry, *found);
      const auto line = [&](const toml::node& of) {
        return file_->source.empty() ? 0 : detail::line_of(of);
      };
      throw Error(file_->at(*entry.node) +
                  detail::duplicate(
                      "key",
                      detail::message("{} as {}", found->name, entry.name),
                      line(*found->node), line(*entry.node)));
    }
    found = std::move(entry);
  }
  return found;
}

TomlTable::Entry TomlTable::at(std::string_view key) const {
  auto entry = find(key);
  if (!entry) needs(detail::spellings_text(key, declared(key).dimension));
  return *std::move(entry);
}

TomlTable TomlTable::inner(const void* table, std::string_view key,
                           std::string path) const {
  return {file_, table, &declared(key).inside, std::move(path)};
}

bool TomlTable::has(std::string_view key) const {
  return find(key).has_value();
}

bool TomlTable::is_table(std::string_view key) const {
  const auto entry = find(key);
  return entry && entry->node->is_table();
}

double TomlTable::number(std::string_view key) const {
  return number(key, numbers_of(declared(key)));
}

double TomlTable::number(std::string_view key, const Interval& range) const {
  const Entry entry = at(key);
  return entry.number(*entry.node, range, [] { return ""; });
}

std::vector<double> TomlTable::numbers(std::string_view key,
                                       const ArrayShape& shape) const {
  return numbers(key, shape, numbers_of(declared(key)));
}

std::vector<double> TomlTable::numbers(std::string_view key,
                                       const ArrayShape& shape,
                                       const Interval& range) const {
  const Entry entry = at(key);
  std::vector<double> result;
  entry.numbers(*entry.node, shape, range, "", result);
  return result;
}

std::int64_t TomlTable::integer(std::string_view key) const {
  const Entry entry = at(key);
  const auto [low, high] = declared(key).allowed.integers.value();
  const auto value = entry.node->as_integer();
  if (value == nullptr || value->get() < low || value->get() > high) {
    entry.must_be(detail::message("an integer, {} to {}", low, high));
  }
  return value->get();
}

bool TomlTable::flag(std::string_view key) const {
  const auto entry = find(key);
  if (!entry) return false;
  const auto value = entry->node->as_boolean();
  if (value == nullptr) entry->must_be("true or false");
  return value->get();
}

std::string TomlTable::text(std::string_view key) const {
  const Entry entry = at(key);
  return entry.text(*entry.node, "a string, not empty");
}

std::vector<std::string> TomlTable::texts(std::string_view key) const {
  const auto entry = find(key);
  if (!entry) return {};
  constexpr const char* rule = "a string or an array of strings, none empty";
  const toml::array* array = entry->node->as_array();
  if (array == nullptr || array->empty()) {
    return {entry->text(*entry->node, rule)};
  }
  std::vector<std::string> result;
  for (const toml::node& node : *array) {
    result.push_back(entry->text(node, rule));
  }
  return result;
}

std::size_t TomlTable::choice(std::string_view key,
                              std::string_view otherwise) const {
  const Entry entry = at(key);
  std::vector<std::string> quoted;
  for (const std::string& word : declared(key).allowed.words) {
    if (entry.node->value<std::string>() == word) return quoted.size();
    quoted.push_back('"' + word + '"');
  }
  if (!otherwise.empty()) quoted.emplace_back(otherwise);
  entry.must_be(detail::either(quoted));
}

TomlTable TomlTable::table(std::string_view key) const {
  const auto entry = find(key);
  const std::string path = detail::joined(path_, std::string(key));
  if (!entry) needs(detail::message("the table [{}]", path));
  if (!entry->node->is_table()) entry->must_be("a table");
  return inner(entry->node->as_table(), key, path);
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const auto entry = find(key);
  if (!entry) return {};
  std::vector<TomlTable> result;
  if (const toml::array* array = entry->node->as_array()) {
    for (const toml::node& node : *array) {
      if (!node.is_table()) entry->must_be("an array of tables");
      result.push_back(inner(
          node.as_table(), key,
          detail::message("{}[{}]", detail::joined(path_, std::string(key)),
                          result.size() + 1)));
    }
  }
  if (result.empty()) entry->must_be("an array of tables");
  return result;
}

// "FILE:LINE: TABLE.KEY = VALUE", as much of it as there is.
std::string TomlTable::subject(std::string_view key) const {
  const auto entry = find(key);
  return entry ? file_->subject(*entry->node, entry->name, *entry->node)
               : file_->at(as_table(table_)) +
                     detail::joined(path_, std::string(key));
}

void TomlTable::must_be(std::string_view key, std::string_view rule) const {
  throw Error(detail::must_be(subject(key), rule));
}

void TomlTable::needs(std::string_view key, std::string_view other) const {
  throw Error(detail::needs(subject(key), other));
}

void TomlTable::fail(std::string_view key, std::string_view message) const {
  throw Error(detail::message("{}: {}", subject(key), message));
}

void TomlTable::needs(std::string_view other) const {
  const toml::table& table = as_table(table_);
  const auto* from = file_->origin(table);
  throw Error(detail::needs(
      from != nullptr ? *from
                      : file_->at(table) + (path_.empty() ? "the file" : path_),
      other));
}

void TomlTable::refuse_both(std::string_view key,
                            std::string_view other) const {
  const auto entry = find(other);
  if (!entry || !has(key)) return;
  const auto* from = file_->origin(*entry->node);
  throw Error(
      detail::conflicts(subject(key), from != nullptr ? *from : entry->name,
                        from != nullptr ? 0 : detail::line_of(*entry->node)));
}

void TomlTable::refuse_idle() const { file_->refuse({&file_->read}); }

std::string TomlTable::canonical_text() const {
  return detail::canonical(as_table(table_));
}

std::string TomlTable::toml_text() const {
  std::ostringstream text;
  text << file_->root;
  return text.str();
}

const std::string& TomlTable::source() const { return file_->source; }

const std::filesystem::path& TomlTable::folder() const { return file_->folder; }

TomlTable TomlTable::file(std::string_view key, KnownKeys (*keys)()) const {
  const std::filesystem::path path =
      detail::named_file(folder(), key, text(key));
  const auto found = file_->for_files.find(&as_table(table_));
  const KeySettings settings =
      found == file_->for_files.end() ? KeySettings{} : found->second;
  return file_->cache ? cached(file_->cache, path, keys, settings)
                      : from_file(path, keys(), settings);
}

}  // namespace contact
